// The page with structures of one's own: their fields, contacts, drawing, verdicts, sounds, and what is refused.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFile, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { scratchFolder } from "../scratch.mjs";
import { until } from "../until.mjs";
import { openPage, program, startExplorer } from "./session.mjs";

const folder = scratchFolder();

/** Opens a case file in the page, and gives the page to `look`. */
async function withFile(name, text, look, { refuses = false } = {}) {
  const file = join(folder, name);
  await writeFile(file, text);
  const explorer = await startExplorer([file]);
  const browser = await openPage(explorer);
  try {
    await browser.goto();
    await browser.page.waitForSelector('#verdict[aria-busy="false"]');
    await browser.page.waitForSelector('.response[data-draws]:not([data-draws="0"])');
    await look(browser.page);
    // the browser itself notes each answer that refuses
    const noted = browser.sins.filter((sin) => !(refuses && /status of 400/.test(sin)));
    assert.deepEqual(noted, []);
  } finally {
    await browser.close();
    assert.equal(await explorer.stop(), 0);
  }
}

function ready(name, changes = []) {
  const text = execFileSync(program, ["init", name], { encoding: "utf8" });
  return changes.reduce((whole, [from, to]) => {
    assert.ok(from instanceof RegExp ? from.test(whole) : whole.includes(from), String(from));
    return whole.replace(from, to);
  }, text);
}

/** How many colours are seen in a canvas: of one that nothing was painted on, one. */
async function colours(page, selector) {
  return page.locator(selector).evaluate((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
}

const chain = (blocks) =>
  ready("chain", [
    ["blocks = 2", `blocks = ${blocks}`],
    [/duration = "200 s"/, 'duration = "60 s"'],
    [/window = "200 s"/, 'window = "60 s"'],
  ]);

test("a chain shows its fields, its contacts and their verdicts", async () => {
  await withFile("chain.toml", chain(6), async (page) => {
    assert.equal(await page.locator('[data-field="structure.coupling"]').inputValue(), "1.2 N/m");
    assert.ok(await page.locator('[data-row="joint.mass"]').isHidden());
    assert.deepEqual(await page.locator("#contact option").allInnerTexts(), [
      "block1",
      "block2",
      "block3",
      "block4",
      "block5",
      "block6",
    ]);
    await until(async () => (await colours(page, "#mechanism")) > 20, "the drawing of the structure");
    assert.match(await page.locator("#verdict .chip").first().innerText(), /contact -?[\d.]+ dB/);
    // a click on a row of states chooses that contact
    const box = await page.locator("#response").boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + 14 + 10 * 4.5);
    assert.equal(await page.locator("#contact").inputValue(), "4");
    assert.match(await page.locator("#response-readout").innerText(), /block5:\s(stick|slip|separation)/);
    await page.locator("#tab-energy").click();
    const rows = await page.locator("#view-energy tr[data-contact]").count();
    assert.equal(rows, 6);
    assert.match(await page.locator("#view-energy").innerText(), /6 contacts as a whole: all stick/);
    await page.locator("#tab-spectra").click();
    assert.equal(await page.locator('#view-spectra [data-sound="of"] option').first().innerText(), "strongest contact");
    await page.locator(".modal summary").click();
    await page.waitForSelector("#modal-lines li");
    assert.match(await page.locator("#modal-lines li").first().innerText(), /Hz: mode \d+ \(.*Hz\) -?\d+/);
    await page.locator("#tab-modes").click();
    await page.waitForSelector("#modes-readout:not(:empty)");
  });
});

test("a slider of its builder makes the structure anew, and the chart is over its own quantities", async () => {
  await withFile(
    "chain.toml",
    chain(2),
    async (page) => {
      await page.waitForSelector('#chart[data-done="true"]');
      assert.equal(await page.locator("#axis-x").inputValue(), "contact.preload");
      const options = await page.locator("#axis-x option").evaluateAll((all) => all.map(({ value }) => value));
      assert.ok(options.includes("structure.coupling") && options.includes("structure.stiffness_scale"));
      assert.ok(!options.includes("joint.mass"));
      const field = page.locator('[data-field="structure.coupling"]');
      await field.fill("0.5 N/m");
      await field.press("Enter");
      await page.waitForFunction(() => location.hash.includes("structure.coupling=0.5"));
      await page.waitForSelector('#verdict[aria-busy="false"]');
      assert.ok(await page.locator("#complaint").isHidden());
      // counts of a builder are the file's
      await page.evaluate(() => (location.hash = `${location.hash}&structure.blocks=100`));
      await page.waitForSelector("#complaint:not([hidden])");
      assert.match(await page.locator("#complaint").innerText(), /structure\.blocks cannot be set here/);
    },
    { refuses: true },
  );
});

test("a bowed string moves in Helmholtz' motion, and is heard", async () => {
  const short = ready("string", [
    [/duration = "3 s"/, 'duration = "0.6 s"'],
    [/window = "1 s"/, 'window = "0.5 s"'],
  ]);
  await withFile("string.toml", short, async (page) => {
    // cells are shown as they come, not at the end: seen on the way, or told by the number of times they were drawn
    await page.waitForFunction(() => {
      const { done, computed, total, redraws } = document.querySelector("#chart").dataset;
      if (done === "true") return Number(redraws) > 2;
      return done === "false" && Number(computed) > 0 && Number(computed) < Number(total);
    });
    await until(async () => (await colours(page, "#mechanism")) > 20, "the drawing of the structure");
    const shown = Number(await page.locator("#verdict").evaluate(({ dataset }) => dataset.all !== undefined));
    assert.equal(shown, 1);
    await page.locator("#tab-listen").click();
    await page.waitForSelector('[data-slot="A"][data-bytes]');
    assert.ok(await page.locator("#contact").isHidden());
  });
});

test("what cannot be shown of a structure is said by name", async () => {
  await withFile(
    "chain.toml",
    chain(2),
    async (page) => {
      await page.locator("#share summary").click();
      await page.locator("#copy-link").click();
      await page.waitForFunction(() => /link/.test(document.querySelector("#share-note").textContent));
      assert.match(await page.locator("#share-note").innerText(), /a structure of its own does not travel in a link/);
    },
    { refuses: true },
  );
  await withFile(
    "long.toml",
    chain(100),
    async (page) => {
      await page.locator("#tab-modes").click();
      await page.waitForFunction(() => /200 rows/.test(document.querySelector("#view-modes").textContent));
    },
    { refuses: true },
  );
});

test("a structure of matrices in files is read once, and drawn at the places of its contacts", async () => {
  const masses = join(folder, "m.csv");
  await writeFile(masses, "1,0,0,0\n0,1,0,0\n0,0,1,0\n0,0,0,1\n");
  const contact = (k, z) =>
    `[[structure.contact]]\nname = "c${k}"\nnormal = "u${2 * k}"\ntangent = "u${2 * k - 1}"\nposition = [0, 0, ${z}]\n`;
  const text =
    '[structure]\nmass = "m.csv"\nstiffness = [[2,0,-1,0],[0,2,0,0],[-1,0,2,0],[0,0,0,2]]\n' +
    `${contact(1, 0)}${contact(2, 0.01)}` +
    '[[structure.output]]\nname = "apart"\ndirection = "u3 -u1"\n' +
    ready("chain").replace(/[^]*(?=\[contact\])/, "");
  await withFile("own.toml", text, async (page) => {
    await rm(masses);
    const field = page.locator('[data-field="contact.preload"]');
    await field.fill("3 N");
    await field.press("Enter");
    await page.waitForFunction(() => location.hash.includes("contact.preload=3"));
    await page.waitForSelector('#verdict[aria-busy="false"]');
    assert.ok(await page.locator("#complaint").isHidden());
    await page.locator("#tab-spectra").click();
    assert.deepEqual(await page.locator('#view-spectra [data-sound="of"] option').allInnerTexts(), [
      "apart",
      "c1",
      "c2",
    ]);
  });
  await assert.rejects(readFile(masses));
});

test("what is read aloud of the chart is what it shows, each way", async () => {
  await withFile("weatherstrip.toml", ready("weatherstrip"), async (page) => {
    await page.waitForSelector('#chart[data-done="true"]');
    const said = (direction) => page.locator(`#chart canvas[data-direction=${direction}]`).getAttribute("aria-label");
    assert.match(await said("going"), /: locks$/);
    assert.match(await said("coming"), /: squeal$/);
  });
});

test("of several joints each has its name and its mark, and what has no result says why", async () => {
  const axes = `
[chart]
x = { parameter = "contact.preload", from = "100 N", to = "300 N", points = 3 }
y = { parameter = "contact.kinetic_friction", from = 0.2, to = 1, points = 2 }
`;
  const lips = ready("two-lips", [
    ['"200 N"', '"120 N"'],
    [/^duration = .*$/m, 'duration = "0.2 s"'],
    [/^window = .*$/m, 'window = "0.2 s"'],
  ]);
  await withFile("lips.toml", lips + axes, async (page) => {
    await page.waitForSelector('#chart[data-done="true"]');
    assert.match(await page.locator("#verdict .chip").first().innerText(), /(upper|lower) [\d.]+ dB/);
    assert.match(await page.locator("#axis-x option:checked").innerText(), /^all: preload/);
    const gaps = await page.locator("#gaps").innerText();
    assert.match(gaps, /without a result, such as: mu_d = 1 exceeds mu_s = 0\.8 \(.*\)$/);
    assert.ok(await page.locator("#outside").isHidden(), "the design is on the chart");
    // a cell of all joints takes the place of what one of them had by itself
    const upper = page.locator('[data-field="joint.upper.contact.preload"]');
    await upper.fill("150");
    await upper.press("Enter");
    await page.waitForFunction(() => location.hash.includes("joint.upper.contact.preload=150"));
    await page.locator("#chart canvas").first().focus();
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => /&contact\.preload=/.test(location.hash));
    assert.ok(!page.url().includes("joint.upper.contact.preload"));
    await page.waitForSelector('#verdict[aria-busy="false"]');
    assert.match(await upper.inputValue(), /^[23]00 N$/);
  });
});
