// The page with a case file: its chart, values with units, and links that open elsewhere.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { scratchFolder } from "../scratch.mjs";
import { moving, openPage, program, settled, startExplorer } from "./session.mjs";

const folder = scratchFolder();
let explorer;
let browser;
let page;

const chart = `
[chart]
x = { parameter = "contact.preload", from = "5 N", to = "50 N", points = 24 }
y = { parameter = "joint.incidence_angle", from = 40, to = 140, points = 20 }
quantities = ["frequency"]
`;

before(async () => {
  const file = join(folder, "seal.toml");
  const text = execFileSync(program, ["init", "squeal"], { encoding: "utf8" });
  const changed = text
    .replace(/\[drive\][\s\S]*?\n(?=\[run\])/, '[drive]\nkind = "constant"\nvelocity = "50 mm/s"\n\n')
    .replace(/^preload = .*$/m, 'preload = "31.25 N"')
    .replace(/^axial_stiffness = .*$/m, 'axial_stiffness = "7.5 MN/m"')
    .replace(/^(settling|reversal) = .*$/gm, "");
  await writeFile(file, changed + chart);
  explorer = await startExplorer([file]);
  browser = await openPage(explorer);
  page = browser.page;
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await browser.goto();
  await settled(page);
});

after(async () => {
  await browser?.close();
  assert.equal(await explorer?.stop(), 0);
});

async function type(key, text) {
  const field = page.locator(`[data-field="${key}"]`);
  await field.fill(text);
  await field.press("Enter");
  return field;
}

test("a file with a chart opens with its axes, ranges and figure", async () => {
  assert.equal(await page.locator("#axis-x").inputValue(), "contact.preload");
  assert.equal(await page.locator("#axis-y").inputValue(), "joint.incidence_angle");
  assert.equal(await page.locator("#x-from").inputValue(), "5 N");
  assert.equal(await page.locator("#y-to").inputValue(), "140°");
  assert.equal(await page.locator("#figure").inputValue(), "frequency");
  assert.equal(await page.locator("#chart").getAttribute("data-total"), String(2 * 24 * 20));
});

test("the header's level is the one that the program prints, with its name and reference", async () => {
  const printed = execFileSync(program, ["simulate", join(folder, "seal.toml")], { encoding: "utf8" });
  const level = /^\w+ +(?:squeal|squeak|creak|none|undecided).* (-?[\d.]+ dB)$/m.exec(printed)[1];
  assert.match(await page.locator("#verdict .chip").first().innerText(), new RegExp(`joint ${level}`));
  assert.match(await page.locator("#level-note").innerText(), /re 1 nm\/s.*not sound pressure/);
});

test("a field takes what the program takes, in any unit", async () => {
  await type("contact.preload", "0.02 kN");
  await page.waitForFunction(() => document.querySelector('[data-field="contact.preload"]').value === "20 N");
  await type("contact.kinetic_friction", "55 %");
  await page.waitForFunction(() => location.hash.includes("kinetic_friction=0.55"));
  await settled(page);
  assert.ok(await page.locator("#complaint").isHidden());
});

test("a wrong unit is refused in the program's own words, at its field", async () => {
  const before = page.url();
  const field = await type("contact.preload", "5 kg");
  await page.waitForSelector("#complaint:not([hidden])");
  const said = await page.locator("#complaint").innerText();
  const options = ["simulate", join(folder, "seal.toml"), "--set", "contact.preload=5 kg"];
  const { stderr } = spawnSync(program, options, { encoding: "utf8" });
  const [what] = /contact\.preload[^(\n]*/.exec(stderr);
  assert.ok(said.startsWith(what.trim()), `${said} / ${stderr}`);
  assert.equal(await field.getAttribute("aria-invalid"), "true");
  assert.equal(page.url(), before);
  await field.press("Escape");
  assert.ok(await page.locator("#complaint").isHidden());
  await page.locator("#reset-all").click();
  await settled(page);
});

test("a design outside the chart is said, and one click widens the chart to hold it", async () => {
  assert.ok(await page.locator("#outside").isHidden());
  await type("contact.preload", "120");
  await page.waitForSelector("#outside:not([hidden])");
  assert.match(await page.locator("#outside").innerText(), /outside the chart: preload 120 N/);
  await page.locator("#widen").click();
  await page.waitForSelector("#outside", { state: "hidden" });
  const to = Number((await page.locator("#x-to").inputValue()).replace(" N", ""));
  assert.ok(to > 120 && to < 150, String(to));
  await page.goBack();
  await page.waitForSelector("#outside:not([hidden])");
  await page.goBack();
  await page.waitForSelector("#outside", { state: "hidden" });
  await settled(page);
});

test("a link holds the whole case: it opens where the file is not", async () => {
  await type("contact.kinetic_friction", "0.7");
  await settled(page);
  await page.locator("#share summary").click();
  await page.locator("#copy-link").click();
  await page.waitForSelector("#share-note[data-copied]");
  const link = await page.locator("#share-note").getAttribute("data-copied");
  assert.match(await page.locator("#share-note").innerText(), /stridor explore 'LINK'/);
  assert.ok(!link.includes("preset=file") && link.length < 2000, link);
  const toml = async (where) => {
    await where.locator("#share-note").evaluate((note) => delete note.dataset.copied);
    await where.locator("#copy-toml").click();
    await where.waitForSelector("#share-note[data-copied]");
    const text = await where.locator("#share-note").getAttribute("data-copied");
    return text
      .split("\n")
      .filter((line) => !line.startsWith("#") && !line.startsWith("title"))
      .join("\n");
  };
  const here = await toml(page);
  const chip = await page.locator("#verdict .chip").first().innerText();

  const elsewhere = await startExplorer([link]);
  const other = await openPage(elsewhere);
  try {
    await other.page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await other.goto();
    await settled(other.page);
    assert.equal(await other.page.locator("#verdict .chip").first().innerText(), chip);
    assert.equal(await other.page.locator("#y-to").inputValue(), "140°");
    assert.equal(await other.page.locator("#figure").inputValue(), "frequency");
    await other.page.locator("#share summary").click();
    assert.equal(await toml(other.page), here);

    // the same into a page that shows something else
    await other.page.goto(`${elsewhere.origin}/#preset=creak`);
    await settled(other.page);
    if (!(await other.page.locator("#paste-link").isVisible())) await other.page.locator("#share summary").click();
    await other.page.locator("#paste-link").fill(link);
    await other.page.locator("#paste-link").press("Enter");
    const shows = (text) => document.querySelector("#verdict .chip")?.innerText === text;
    await other.page.waitForFunction(shows, chip);
    assert.deepEqual(other.sins, []);
  } finally {
    await other.close();
    await elsewhere.stop();
  }
});

test("a link that leans on a file is refused where there is none, with a way out", () => {
  const options = ["explore", "--no-browser", "http://localhost:1/#preset=file"];
  const { status, stderr } = spawnSync(program, options, { encoding: "utf8" });
  assert.equal(status, 2);
  assert.match(stderr, /leans on a file.*Share, Copy link/s);
});

test("nothing went wrong on the way", () => {
  assert.deepEqual(
    browser.sins.filter((sin) => !/status of 400/.test(sin)),
    [],
  ); // a refusal is an answer
});

test("all that is wrong with a design is told, each at its field", async () => {
  const other = await openPage(explorer);
  try {
    await other.goto("#preset=squeal&contact.preload=-5+N&contact.kinetic_friction=nonsense&joint.mass=2+m");
    await other.page.waitForSelector("#complaint:not([hidden]) li");
    const told = await other.page.locator("#complaint li").allInnerTexts();
    assert.equal(told.length, 3, told.join(" / "));
    for (const key of ["contact.preload", "contact.kinetic_friction", "joint.mass"]) {
      assert.equal(told.filter((each) => each.includes(key)).length, 1, told.join(" / "));
      assert.equal(await other.page.locator(`[data-field="${key}"]`).getAttribute("aria-invalid"), "true", key);
    }
    await other.page.locator("#reset-all").click();
    await settled(other.page);
    assert.ok(await other.page.locator("#complaint").isHidden());
  } finally {
    await other.close();
  }
});

test("what follows the temperature says so, and the temperature slides over its table", async () => {
  const file = join(folder, "warm.toml");
  const text = execFileSync(program, ["init", "squeal"], { encoding: "utf8" });
  await writeFile(
    file,
    text.replace(/^kinetic_friction = .*$/m, "") +
      '\n[temperature]\nvalue = "23 degC"\nat = [-30, 23, 80]\nkinetic_friction = [0.5, 0.6, 0.7]\n',
  );
  const warm = await startExplorer([file]);
  const other = await openPage(warm);
  try {
    const { page } = other;
    await other.goto();
    await settled(page);
    const row = page.locator('[data-row="contact.kinetic_friction"]');
    const field = row.locator('input[type="text"]');
    assert.match(await row.innerText(), /follows the temperature/);
    assert.ok(await field.isDisabled());
    assert.ok(await row.locator('input[type="range"]').isHidden());
    const note = await field.getAttribute("aria-describedby");
    assert.equal(await page.evaluate((id) => document.getElementById(id).textContent, note), "follows the temperature");
    assert.match(await page.locator('[data-row="temperature.value"]').innerText(), /^θ\s*temperature/);
    assert.equal(await page.locator('[data-field="temperature.value"]').inputValue(), "23 °C");
    const axes = await page.locator("#axis-y option").allInnerTexts();
    const isFriction = (each) => each.startsWith("kinetic friction");
    assert.ok(axes.includes("temperature θ") && !axes.some(isFriction), axes.join(", "));
    assert.equal(await page.locator("#axis-y").inputValue(), "temperature.value");
    await page.locator('[data-key="temperature.value"]').fill("1000"); // its end
    await page.waitForFunction(() => document.querySelector('[data-field="contact.kinetic_friction"]').value === "0.7");
    await page.locator("#preset label").filter({ hasText: "squeak" }).click();
    await settled(page);
    assert.notEqual(await page.locator("#axis-y").inputValue(), "temperature.value", "this case has none");
    assert.ok(await field.isEnabled());
    assert.equal(await field.getAttribute("aria-describedby"), null);
    assert.ok(!(await row.innerText()).includes("follows"));
    assert.deepEqual(other.sins, []);
  } finally {
    await other.close();
    assert.equal(await warm.stop(), 0);
  }
});

/** A page on a lip as soft as a seal's, of which nothing stands in Table 1. */
async function withSoftLip(use) {
  const file = join(folder, "soft.toml");
  const text = execFileSync(program, ["init", "squeal"], { encoding: "utf8" });
  await writeFile(
    file,
    text
      .replace(/^mass = "0.1 kg"$/m, 'mass = "4.0012345 g"')
      .replace(/^flexural_stiffness = .*$/m, 'flexural_stiffness = "1.5 kN/m"')
      .replace(/^axial_stiffness = .*$/m, 'axial_stiffness = "15 kN/m"')
      .replace(/^preload = .*$/m, 'preload = "0.67 N"'),
  );
  const soft = await startExplorer([file]);
  const other = await openPage(soft);
  try {
    await other.goto();
    await settled(other.page);
    await use(other.page);
    assert.deepEqual(other.sins, []);
  } finally {
    await other.close();
    assert.equal(await soft.stop(), 0);
  }
}

test("a slider goes around the case's own value, and comes back to it to the last digit", async () => {
  await withSoftLip(async (page) => {
    const slider = page.locator('input[type="range"][data-key="joint.mass"]');
    const field = page.locator('[data-field="joint.mass"]');
    const mass = async () => Number((await field.getAttribute("title")).split(" ")[0]);
    assert.equal(await slider.inputValue(), "500", "in the middle");
    await slider.scrollIntoViewIfNeeded();
    const box = await slider.boundingBox();
    // 4 px beside the middle of its thumb, where browsers make it jump
    const [x, y] = [box.x + box.width / 2 + 4, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 1, y);
    const near = await mass();
    assert.ok(near > 0.0040012345 && near < 0.0043, String(near));
    for (let k = 1; k <= 100; ++k) await page.mouse.move(x + 60 * Math.sin(k), y);
    await page.mouse.move(x + 300, y);
    assert.ok(Math.abs((await mass()) - 0.040012345) < 1e-5, "ten times");
    await page.mouse.move(x, y);
    await page.mouse.up();
    await settled(page);
    assert.equal(await mass(), 0.0040012345);
    assert.ok(!page.url().includes("joint.mass"), "nothing was changed");
    assert.ok(await page.locator("#reset-all").isDisabled());
    // a click on the thumb alone changes nothing
    await page.mouse.click(x, y);
    assert.equal(await mass(), 0.0040012345);
    // nor do fifty steps there and back by the keyboard, nor what was typed beyond its ends
    await slider.focus();
    for (const key of ["ArrowRight", "ArrowLeft"]) for (let k = 0; k < 50; ++k) await page.keyboard.press(key);
    assert.equal(await mass(), 0.0040012345);
    await field.fill("7.123456789 kg");
    await field.press("Enter");
    await page.waitForFunction(() => location.hash.includes("joint.mass=7.123456789"));
    await slider.focus();
    await page.keyboard.press("ArrowLeft");
    assert.ok((await mass()) > 6.9);
    await page.keyboard.press("ArrowRight");
    assert.equal(await mass(), 7.123456789);
    await page.locator("#reset-all").click();
    await settled(page);
    assert.equal(await mass(), 0.0040012345);
    assert.equal(await page.locator("#x-from").inputValue(), "67 mN", "the chart goes around it, too");
    assert.ok(await page.locator("#outside").isHidden());
  });
});

test("units are a choice of the browser: what is sent stays the same to the last digit", async () => {
  await withSoftLip(async (page) => {
    const field = page.locator('[data-field="joint.flexural_stiffness"]');
    const slider = page.locator('input[type="range"][data-key="joint.flexural_stiffness"]');
    const said = () => new URL(page.url()).hash;
    const moved = async () => {
      await slider.focus();
      await page.keyboard.press("ArrowRight");
      const value = /flexural_stiffness=([^&]+)/.exec(said())[1];
      await page.keyboard.press("ArrowLeft");
      return value;
    };
    assert.equal(await field.inputValue(), "1.5 kN/m");
    const [value, address] = [await moved(), said()];
    await settled(page);
    await moving(page);
    // what the design before still asks for (its fine motion, its surroundings) may come late: it asks for that design
    const requests = [];
    page.on("request", (request) => requests.push([new URL(request.url()).pathname, request.postDataJSON()?.set]));
    await page.locator("#units").selectOption("engineering");
    assert.equal(await field.inputValue(), "1.5 N/mm");
    assert.equal(await page.locator('[data-field="joint.mass"]').inputValue(), "4.001 g");
    assert.match(await page.locator("#mechanism-readout").innerText(), /V\s=\s-?[\d.]+\smm\/s/);
    assert.equal(said(), address);
    const late = ["/api/motion", "/api/design"];
    assert.deepEqual(
      requests.filter(([path, set]) => !late.includes(path) || set.length > 0),
      [],
    );
    assert.equal(await moved(), value);
    assert.equal(said(), address);
    // a number alone is in the unit that is shown, as the program reads it
    const mass = page.locator('[data-field="joint.mass"]');
    await mass.fill("4.1");
    await mass.press("Enter");
    await page.waitForFunction(() => location.hash.includes("joint.mass=0.0041"));
    await page.reload();
    await settled(page);
    assert.equal(await field.inputValue(), "1.5 N/mm", "it is kept");
  });
});

test("cells of a chart that stopped are pale, and are called nothing", async () => {
  await withSoftLip(async (page) => {
    // the first look at a chart, and no more: most of its cells are not computed
    await page.route("**/api/chart", async (route) => {
      try {
        const response = await route.fetch();
        const [first] = (await response.text()).split("\n");
        await route.fulfill({ response, body: first + "\n" });
      } catch {
        // a newer wish took its place
      }
    });
    const colours = async () =>
      page.evaluate(() => {
        const canvas = document.querySelector('#chart canvas[data-direction="coming"]');
        const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
        copy.drawImage(canvas, 0, 0);
        const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
        const counts = {};
        for (let k = 0; k < data.length; k += 4) {
          const colour = "#" + [0, 1, 2].map((c) => data[k + c].toString(16).padStart(2, "0")).join("");
          counts[colour] = (counts[colour] ?? 0) + 1;
        }
        return counts;
      });
    for (const [theme, none, pale] of [
      ["light", "#e6e6e6", "#f8f8f8"],
      ["dark", "#30353b", "#212429"],
    ]) {
      const design = `preset=squeal&contact.static_friction=0.8${theme.length}`;
      await page.goto(`${page.url().split("#")[0]}#${design}&theme=${theme}`);
      await page.waitForSelector("#chart-status:has-text('stopped')");
      assert.match(await page.locator("#chart-status").innerText(), /^\d+ of 8192 cells run · stopped/);
      const found = await colours();
      const all = Object.values(found).reduce((a, b) => a + b, 0);
      assert.ok((found[none] ?? 0) < 0.1 * all, `${theme}: ${found[none]} of ${all} are drawn as quiet`);
      assert.ok(
        found[pale] > 0.3 * all,
        JSON.stringify(
          Object.entries(found)
            .sort((a, b) => b[1] - a[1])
            .slice(0, 5),
        ),
      );
      assert.match(await page.locator("#legend").innerText(), /pale: not computed yet/);
      await page.locator('#chart canvas[data-direction="coming"]').hover({ position: { x: 93, y: 93 } });
      assert.match(await page.locator("#chart-readout").innerText(), /not computed yet/);
    }
  });
});
