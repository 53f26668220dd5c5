// The page with a case file: its chart, values with units, and links that open elsewhere.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openPage, program, startExplorer } from "./session.mjs";

let folder;
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
  folder = await mkdtemp(join(tmpdir(), "stridor-case-"));
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
  await rm(folder, { recursive: true, force: true });
});

async function settled(where) {
  await where.waitForSelector('#verdict[aria-busy="false"]');
  await where.waitForSelector('#chart[data-done="true"]');
}

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
