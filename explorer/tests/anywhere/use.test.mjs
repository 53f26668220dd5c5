// The page in one file as it is used for long: on many processors, by keyboard alone, for hundreds of moves.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { program } from "../browser/session.mjs";
import { scratchFolder } from "../scratch.mjs";
import { until } from "../until.mjs";
import { drop, openFile, ready, saved, settled, verdict, write } from "./one_file.mjs";

const folder = scratchFolder();
let file;

before(() => {
  file = write(join(folder, "page.html"));
});

const processors = (count) => `Object.defineProperty(navigator, "hardwareConcurrency", { value: ${count} });`;

const opened = (t, options) => openFile(t, file, options);

test(
  "a chart over six workers is that of one, and none is left when it is stopped",
  { timeout: 900_000 },
  async (t) => {
    const tables = [];
    for (const count of [2, 7]) {
      const { page, sins } = await opened(t, { init: processors(count), fragment: "#preset=squeak" });
      let most = 0;
      page.on("worker", () => (most = Math.max(most, page.workers().length)));
      await settled(page);
      if (count > 2) assert.ok(most >= 5, `${most} workers computed the chart`);
      await page.locator("#share summary").click();
      tables.push((await saved(page, () => page.locator("#save-csv").click())).toString());
      await page.keyboard.press("Escape");
      // moved while it computes: each move stops the chart before
      const slider = page.locator('input[type="range"][data-key="contact.preload"]');
      for (let k = 0; k < 8; ++k) await slider.press(k % 2 ? "ArrowLeft" : "PageUp");
      await settled(page);
      await until(() => page.workers().length <= 2, "the workers to end");
      assert.deepEqual(sins, []);
    }
    assert.equal(tables[0].split("\n").slice(1).join("\n"), tables[1].split("\n").slice(1).join("\n"));
  },
);

/** [MB] of the processes that this one started, what they share counted once. */
async function memory(pid = process.pid) {
  let sum = 0;
  for (const each of await readdir("/proc")) {
    if (!/^\d+$/.test(each)) continue;
    const status = await readFile(`/proc/${each}/status`, "utf8").catch(() => "");
    if (Number(/^PPid:\s+(\d+)/m.exec(status)?.[1]) !== pid) continue;
    const rollup = await readFile(`/proc/${each}/smaps_rollup`, "utf8").catch(() => "");
    sum += Number(/^Pss:\s+(\d+)/m.exec(rollup)?.[1] ?? 0) / 1e3 + (await memory(Number(each)));
  }
  return sum;
}

test("five hundred moves of a slider take no more memory than a tab may", { timeout: 900_000 }, async (t) => {
  const { page, sins } = await opened(t);
  await settled(page);
  const begin = await memory();
  const slider = page.locator('input[type="range"][data-key="contact.kinetic_friction"]');
  await slider.focus();
  let most = 0;
  for (let move = 0; move < 500; ++move) {
    await page.keyboard.press(Math.floor(move / 25) % 2 ? "ArrowLeft" : "ArrowRight");
    if (move % 50 === 49) most = Math.max(most, await memory());
  }
  await settled(page);
  const end = await memory();
  t.diagnostic(`whole browser [MB]: ${begin.toFixed(0)} before, ${most.toFixed(0)} at most, ${end.toFixed(0)} after`);
  assert.ok(end < 700, `${end} MB`);
  assert.deepEqual(sins, []);
});

/** Presses Tab until this has the focus. */
async function reach(page, selector, key = "Tab") {
  for (let press = 0; press < 250; ++press) {
    const isThere = await page.evaluate((wanted) => document.activeElement?.matches(wanted) ?? false, selector);
    if (isThere) return;
    await page.keyboard.press(key);
  }
  assert.fail(`${selector} is not reached by ${key}`);
}

for (const width of [1440, 1024, 390])
  test(`ten tasks of a newcomer by keyboard alone, ${width} px`, { timeout: 900_000 }, async (t) => {
    const { page, sins } = await opened(t, { viewport: { width, height: 900 } });
    const press = (...keys) => keys.reduce((done, key) => done.then(() => page.keyboard.press(key)), Promise.resolve());
    await settled(page);
    // 1: see that it squeals, and that nothing leaves
    assert.equal(await verdict(page), "squeal");
    assert.match(await page.locator("#purpose").textContent(), /nothing leaves this machine/);
    // 2: take another of the paper's noises
    await press("3");
    await until(async () => (await verdict(page)) === "creak", "the creak");
    // 3: write a number with its unit
    await press("1");
    await until(async () => (await verdict(page)) === "squeal", "the squeal");
    await reach(page, '[data-field="contact.kinetic_friction"]');
    await press("Control+a");
    await page.keyboard.type("0.3");
    await press("Enter");
    await until(async () => (await verdict(page)) === "none", "a quiet design");
    // 4: take it back: a digit is a key where no text is written
    await reach(page, 'input[type="range"][data-key="contact.preload"]');
    await press("1");
    await until(async () => (await verdict(page)) === "squeal", "the squeal again");
    // 5: move a slider
    await reach(page, 'input[type="range"][data-key="contact.preload"]');
    const before = await page.locator('[data-field="contact.preload"]').inputValue();
    await press("ArrowRight", "ArrowRight");
    await until(
      async () => (await page.locator('[data-field="contact.preload"]').inputValue()) !== before,
      "a preload",
    );
    await settled(page);
    // 6: go to another cell of the chart
    await reach(page, "#chart canvas");
    const address = page.url();
    await press("ArrowUp", "Enter");
    await until(() => page.url() !== address, "another cell");
    await settled(page);
    // 7: see and hear the sound
    await reach(page, "#tab-response, [role=tab][aria-selected=true]");
    for (let tab = 0; tab < 12; ++tab) {
      if ((await page.locator("#tab-listen").getAttribute("aria-selected")) === "true") break;
      await press("ArrowRight");
    }
    await page.waitForSelector("#view-listen:not([hidden])");
    await page.waitForSelector('[data-slot="A"][data-bytes]');
    // 8: have the keys explained, and leave
    await press("?");
    await page.waitForSelector("dialog[open]");
    await press("Escape");
    await page.waitForSelector("dialog[open]", { state: "detached" });
    // 9: the tour, begun and left
    await press("t");
    await page.waitForSelector("#tour:not([hidden])");
    await press("Escape");
    await page.waitForSelector("#tour", { state: "hidden" });
    // 10: take the page along with this design
    await reach(page, "#share summary", "Shift+Tab");
    await press("Enter");
    await page.waitForSelector("#save-page");
    await reach(page, "#save-page");
    assert.ok((await saved(page, () => press("Enter"))).toString("latin1").startsWith("<!doctype html>"));
    assert.deepEqual(sins, []);
  });

test("a case comes with the files that it names, chosen or dropped", { timeout: 600_000 }, async (t) => {
  const toml = ready("squeal").replace(
    /\[drive\][^]*?\n(?=\[run\])/,
    '[drive]\nkind = "sampled"\nfile = "measured/speed.csv"\n\n',
  );
  const [plain, samples] = [join(folder, "moved.toml"), join(folder, "speed.csv")];
  await writeFile(plain, toml);
  await writeFile(samples, "time [s],velocity [m/s]\n0,0.1\n5,0.1\n");
  const { page, sins } = await opened(t);
  await settled(page);
  await page.locator("#share summary").click();
  await page.locator("#open-case").setInputFiles(plain);
  await until(async () => (await page.locator("#share-note").textContent()).includes("speed.csv"), "what is missing");
  assert.match(await page.locator("#share-note").textContent(), /is not here.*Choose it together with the case/);
  await page.locator("#open-case").setInputFiles([samples, plain]);
  await until(() => page.url().includes("preset=file"), "the case");
  await settled(page);
  const withSamples = await saved(page, async () => {
    await page.locator("#share summary").click();
    await page.locator("#save-page").click();
  });
  assert.match(withSamples.toString("latin1"), /"speed\.csv":/);
  // dropped: a case that stands alone, then what is none
  await drop(page, { "holiday.jpg": "no case" });
  await until(async () => /no case/.test(await page.locator("#complaint").textContent()), "the refusal");
  await drop(page, { "creak.toml": ready("creak") });
  await until(async () => (await verdict(page).catch(() => "")) === "creak", "the dropped case");
  await settled(page);
  assert.deepEqual(sins, []);
});

test("a recording that is dropped is heard and judged beside the design", { timeout: 600_000 }, async (t) => {
  const sound = join(folder, "seal.wav");
  execFileSync(program, ["listen", "-", "-o", sound], { input: ready("squeal") });
  const { page, sins } = await opened(t, { fragment: "#preset=creak" });
  await settled(page);
  await page.locator("#share summary").click();
  await page.locator("#open-case").setInputFiles(sound);
  await page.waitForSelector('[data-slot="B"][data-bytes]');
  const told = page.locator('[data-slot="B"]');
  assert.match(await told.locator("h3").textContent(), /recording 1 \(seal\.wav\)/);
  assert.match(await told.locator(".muted").first().textContent(), /by ear: squeal/);
  await writeFile(join(folder, "damaged.mp3"), "no sound");
  await page.locator("#share summary").click();
  await page.locator("#open-case").setInputFiles(join(folder, "damaged.mp3"));
  const note = page.locator("#share-note");
  await until(async () => /damaged\.mp3 is no sound/.test(await note.textContent()), "the refusal");
  assert.match(await note.textContent(), /Write a WAV file/);
  assert.deepEqual(sins, []);
});

const said = (page) => page.locator('[role="alert"]:visible').first().textContent();

const noMemory = "WebAssembly.Instance = function () { throw new RangeError('could not allocate memory'); };";

test("what a browser lacks is said in a sentence with a way out", { timeout: 600_000 }, async (t) => {
  const ways = {
    "delete globalThis.WebAssembly;": /runs no WebAssembly.*another\?/,
    "delete globalThis.Worker;": /too old for the page\. Open the file in Firefox/,
    "globalThis.Worker = class { constructor() { throw new Error('no'); } };": /no workers.*another browser/,
    // a worker that a policy forbids fails later
    "globalThis.Worker = class extends Worker { constructor() { super('data:text/javascript,'); } };":
      /no workers.*another browser/,
    "WebAssembly.compileStreaming = () => Promise.reject(new RangeError('Out of memory'));":
      /no memory.*Close other tabs/,
    [`globalThis.Blob = class extends Blob {
      constructor(parts, options) {
        const before = options?.type === "text/javascript" ? [${JSON.stringify(noMemory)}] : [];
        super([...before, ...parts], options);
      }
    };`]: /no more memory.*Close other tabs/,
  };
  for (const [init, words] of Object.entries(ways)) {
    const { page } = await opened(t, { init });
    await page.waitForSelector('[role="alert"]:not([hidden])');
    assert.match(await said(page), words, init);
    await page.context().close();
  }
});
