// The page in a real browser, as a user meets it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { scratchFolder } from "../scratch.mjs";
import { openPage, program, settled, startExplorer } from "./session.mjs";

const folder = scratchFolder();
let explorer;
let browser;
let page;

before(async () => {
  const [sound, library] = [join(folder, "sound.wav"), join(folder, "noises.sqlite")];
  const text = execFileSync(program, ["init", "creak"]);
  execFileSync(program, ["listen", "-", "--out", sound], { input: text });
  execFileSync(program, ["library", "add", sound, "--library", library, "--system", "seal"], { stdio: "ignore" });
  explorer = await startExplorer(["--library", library]);
  browser = await openPage(explorer);
  page = browser.page;
  await browser.goto();
});

after(async () => {
  await browser?.close();
  assert.equal(await explorer?.stop(), 0);
});

const verdict = (direction) => page.locator("#verdict").getAttribute(`data-${direction}`);

async function choose(preset) {
  await page.locator(`input[data-preset="${preset}"]`).check({ force: true });
  const reset = page.locator("#reset-all");
  if (await reset.isEnabled()) await reset.click();
  await settled(page);
}

async function setSlider(key, value) {
  const field = page.locator(`[data-field="${key}"]`);
  await field.fill(String(value));
  await field.press("Enter");
  await settled(page);
}

test("opens with the paper's squeal and leaves no token in the address", async () => {
  await settled(page);
  assert.equal(await verdict("going"), "squeal");
  assert.equal(await verdict("coming"), "none");
  assert.ok(!page.url().includes("token"));
});

test("every preset has its category", async () => {
  const categories = {
    squeak: ["squeak", null],
    creak: ["creak", "creak"],
    quiet: ["none", "none"],
    squeal: ["squeal", "none"],
  };
  for (const [preset, [going, coming]] of Object.entries(categories)) {
    await choose(preset);
    assert.equal(await verdict("going"), going, preset);
    if (coming) assert.equal(await verdict("coming"), coming, preset);
  }
});

test("a click on the chart runs the cell, and says what the command line says to the last digit", async () => {
  await choose("squeal");
  const answered = page.waitForResponse((response) => response.url().endsWith("/api/simulate"));
  const map = page.locator("#chart canvas").first();
  const box = await map.boundingBox();
  await map.click({ position: { x: box.width * 0.6, y: box.height * 0.3 } });
  const response = await answered;
  const design = response.request().postDataJSON();
  assert.ok(design.set.some((item) => item.startsWith("contact.preload=")));
  const text = execFileSync(program, ["init", design.preset]);
  const overrides = design.set.flatMap((item) => ["--set", item]);
  const printed = execFileSync(program, ["simulate", "-", "--json", ...overrides], { input: text, encoding: "utf8" });
  assert.equal(await response.text(), printed);
});

test("dragging a slider redraws the chart while it moves", async () => {
  await choose("squeal");
  const slider = page.locator('input[type="range"][data-key="joint.incidence_angle"]');
  const redraws = async () => Number(await page.locator("#chart").getAttribute("data-redraws"));
  const before = await redraws();
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width * 0.4, box.y + box.height / 2);
  await page.mouse.down();
  for (let step = 0; step < 20; ++step) {
    await page.mouse.move(box.x + box.width * (0.4 + 0.01 * step), box.y + box.height / 2);
    await page.waitForTimeout(50);
  }
  assert.ok((await redraws()) > before + 3);
  await page.mouse.up();
  await settled(page);
});

test("the address holds the whole state: a copy of it shows the same, and back goes back", async () => {
  await choose("squeal");
  await setSlider("contact.preload", 35);
  const address = page.url();
  assert.match(address, /contact\.preload/);
  const category = await verdict("going");
  await choose("quiet");
  await page.goBack();
  await settled(page);
  assert.equal(page.url(), address);
  assert.equal(await page.locator('[data-field="contact.preload"]').inputValue(), "35 N");
  const fragment = new URL(address).hash;
  await page.goto("about:blank");
  await page.goto(`${explorer.origin}/${fragment}`);
  await settled(page);
  assert.equal(await verdict("going"), category);
  assert.equal(await page.locator('[data-field="contact.preload"]').inputValue(), "35 N");
});

test("arrow keys move the cell", async () => {
  await choose("squeal");
  const before = page.url();
  await page.locator("#chart canvas").first().focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction((old) => location.href !== old, before);
  await settled(page);
});

test("a wrong value is refused in words, and the old one stays", async () => {
  await choose("squeal");
  const field = page.locator('[data-field="contact.preload"]');
  await field.fill("nonsense");
  await field.press("Enter");
  await page.waitForSelector("#complaint:not([hidden]), [data-field='contact.preload']:invalid, [aria-invalid='true']");
  await setSlider("contact.preload", 20);
  assert.equal(await verdict("going"), "squeal");
});

test("a cell can be heard", async () => {
  await choose("squeal");
  await page.locator("#tab-listen").click();
  const player = page.locator("#view-listen audio").first();
  await player.waitFor({ state: "attached" });
  await page.waitForFunction(() => document.querySelector("#view-listen audio")?.readyState >= 2);
  await player.evaluate((audio) => audio.play());
  await page.waitForFunction(() => document.querySelector("#view-listen audio").currentTime > 0.05);
  await player.evaluate((audio) => audio.pause());
});

test("a recording of the library is seen, heard, and held against the simulation", async () => {
  await page.locator("#tab-library").click();
  const row = page.locator("#view-library [data-entry]").first();
  assert.match(await row.innerText(), /seal/);
  await page.waitForFunction(() => document.querySelector("#view-library audio")?.readyState >= 2);
  await page.waitForFunction(() => /by ear: creak/.test(document.querySelector("#view-library").innerText));
  await page.locator("#compare").click();
  await page.waitForFunction(() => document.querySelectorAll("#view-listen audio[src]").length === 2);
});

test("keep quiet names a change that makes it quiet with one click", async () => {
  await choose("squeal");
  await page.locator("#tab-quiet").click();
  await page.waitForSelector("#apply-change");
  assert.match(await page.locator("#nearest").innerText(), /nearest quiet design .+ → .+ % of their ranges away/);
  await page.locator("#apply-change").click();
  await page.waitForFunction(() => document.querySelector("#verdict").dataset.going === "none", null, {
    timeout: 30000,
  });
  await settled(page);
  assert.equal(await verdict("coming"), "none");
});

test("what is shown can be taken along: as a link, a command, files and a picture", async () => {
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await choose("squeal");
  await setSlider("contact.preload", 35);
  await page.locator("#share summary").click();
  const copied = async (id) => {
    await page.locator("#share-note").evaluate((note) => delete note.dataset.copied);
    await page.locator(`#${id}`).click();
    await page.waitForSelector("#share-note[data-copied]");
    return page.locator("#share-note").getAttribute("data-copied");
  };
  const here = page.url().replace(/&other=library:\d+/, ""); // recordings are of this machine
  assert.equal(await copied("copy-link"), here);
  const command = (await copied("copy-command")).replaceAll("stridor ", `${program} `);
  const printed = execFileSync("sh", ["-c", command], { encoding: "utf8" });
  assert.match(printed, new RegExp(`^going +${await verdict("going")}`, "m"));
  const toml = await copied("copy-toml");
  const checked = execFileSync(program, ["simulate", "-", "--json"], { input: toml, encoding: "utf8" });
  assert.equal(JSON.parse(checked).case.contact.preload, 35);
  assert.match(await copied("copy-chart-toml"), /\[chart\]/);
  for (const [id, begin] of [
    ["save-png", "\x89PNG"],
    ["save-csv", ""],
  ]) {
    const download = page.waitForEvent("download");
    await page.locator(`#${id}`).click();
    const bytes = await readFile(await (await download).path(), "latin1");
    assert.ok(bytes.startsWith(begin) && bytes.length > 1000, id);
  }
  await page.locator("#share summary").click();
});

test("a link whose preset is none of the program's makes no command", async () => {
  const other = await page.context().newPage();
  await other.goto(`${explorer.origin}/#preset=${encodeURIComponent("squeal; touch /tmp/owned")}`);
  await other.locator("#share summary").click();
  await other.locator("#copy-command").click();
  await other.waitForFunction(() => document.querySelector("#share-note").textContent.includes("no preset"));
  assert.equal(await other.locator("#share-note").getAttribute("data-copied"), null);
  await other.close();
});

test("the report opens from a file, without Stridor and without a script", async () => {
  await choose("squeal");
  await page.locator("#share summary").click();
  const download = page.waitForEvent("download", { timeout: 90000 });
  await page.getByRole("button", { name: /report/i }).click();
  const path = await (await download).path();
  const text = await readFile(path, "utf8");
  assert.ok(!/<script/i.test(text));
  const file = `${path}.html`;
  await writeFile(file, text);
  const context = page.context();
  const other = await context.newPage();
  const requests = [];
  other.on("request", (request) => requests.push(request.url()));
  await other.goto(`file://${file}`);
  // figures are images, so that names inside of one do not clash with those of another
  const widths = await other.locator("img").evaluateAll((images) => images.map((image) => image.naturalWidth));
  assert.ok(widths.length >= 2 && widths.every((width) => width > 0), widths.join(", "));
  assert.match(await other.locator("body").innerText(), /squeal/);
  assert.deepEqual(
    requests.filter((url) => !url.startsWith("file://") && !url.startsWith("data:")),
    [],
  );
  await other.close();
});

test("a file that leads to the link opens the page", async () => {
  const own = await startExplorer();
  const file = join(folder, "open.html");
  await writeFile(file, `<!doctype html><meta http-equiv="refresh" content="0; url=${own.link()}">`);
  const other = await openPage(own);
  try {
    await other.page.goto(`file://${file}`);
    await other.page.waitForSelector('#verdict[aria-busy="false"]', { timeout: 20000 });
    assert.equal(other.page.url().split("#")[0], `${own.origin}/`);
  } finally {
    await other.close();
    await own.stop();
  }
});

test("menus close with Esc and with a click beside them, and give the focus back to their button", async () => {
  const isOpen = (menu) => menu.evaluate(({ open }) => open);
  await page.keyboard.press("Escape"); // should one be open
  for (const menu of [page.locator("#share"), page.locator(".axes details")]) {
    const summary = menu.locator("summary");
    const hasFocus = () => summary.evaluate((element) => element === document.activeElement);
    await summary.focus();
    await page.keyboard.press("Enter");
    const field = menu.locator("input").last();
    const before = await field.inputValue();
    await field.fill("half typed");
    await page.keyboard.press("Escape");
    assert.ok(!(await isOpen(menu)) && (await hasFocus()), "Esc");
    assert.equal(await field.inputValue(), before);
    await summary.click();
    await field.focus();
    await page.locator(".purpose").click();
    assert.ok(!(await isOpen(menu)) && (await hasFocus()), "a click on nothing");
    await summary.click();
    await page.locator("#tab-response").click();
    assert.ok(!(await isOpen(menu)) && !(await hasFocus()), "the focus is where the click took it");
  }
  assert.ok(await page.locator("#complaint").isHidden());
});

test("a spectrum has a logarithmic axis, and its peaks are told", async () => {
  await choose("squeal");
  await page.locator("#tab-spectra").click();
  await page.waitForSelector("#peaks:not(:empty)");
  const told = await page.locator("#peaks").innerText();
  const [, frequency] = /^peaks \[dB re 1 nm\/s\]:\s([\d.]+)\sHz\s[\d.]+\sdB\s· /.exec(told);
  const heard = await page.locator("#verdict .chip").first().innerText();
  assert.ok(Math.abs(Number(frequency) - parseFloat(/[\d.]+ Hz/.exec(heard)[0])) < 3, `${told} / ${heard}`);
  const over = page.locator('[data-plot="Spectrum"] .u-over');
  const { width, height } = await over.boundingBox();
  // a frequency twice as high lies as much further to the right, from 100 Hz as from 1 kHz
  const read = async (part) => {
    await over.hover({ position: { x: part * width, y: height / 2 } });
    return Number(await page.locator('[data-plot="Spectrum"] .u-legend .u-value').first().innerText());
  };
  const ratio = async () => ((await read(0.9)) / (await read(0.7))) * ((await read(0.3)) / (await read(0.5)));
  assert.ok(Math.abs((await ratio()) - 1) < 0.2);
  assert.match(await page.locator("#peaks").innerText(), /^peak here .+\sHz\s[\d.]+\sdB$/);
  await page.locator("#log-frequency").uncheck();
  assert.ok((await ratio()) < 0.9);
});

test("the law of friction is drawn, and a point of it goes with the hand and with the arrow keys", async () => {
  await choose("squeal");
  await page.locator("#tab-friction").click();
  await page.waitForSelector("#friction-readout:not(:empty)");
  assert.match(await page.locator("#friction-readout").innerText(), /sticks\sup\sto\s0\.8.+slips\sat\s0\sm\/s\sto/);
  const grip = page.locator('.grip[title="kinetic friction"]');
  const field = page.locator('[data-field="contact.kinetic_friction"]');
  const before = parseFloat(await field.inputValue());
  const { x, y, width, height } = await grip.boundingBox();
  const [across, down] = [x + width / 2, y + height / 2];
  await page.mouse.move(across, down);
  await page.mouse.down();
  await page.mouse.move(across, down + 30, { steps: 5 });
  await page.mouse.up();
  await settled(page);
  const dragged = parseFloat(await field.inputValue());
  assert.ok(dragged < before - 0.05, `${before} -> ${dragged}`);
  await page.waitForFunction(
    (there) =>
      Math.abs(document.querySelector('.grip[title="kinetic friction"]').getBoundingClientRect().y - there) < 2,
    y + 30,
  );
  await grip.press("ArrowUp");
  await settled(page);
  assert.ok(parseFloat(await field.inputValue()) > dragged);
  await page.goBack();
  await page.goBack();
  await settled(page);
  assert.equal(parseFloat(await field.inputValue()), before);
  await page.locator("#tab-response").click();
});

test("on a phone verdict and chart stay in sight while a slider moves, and a finger hits what it aims at", async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  try {
    await choose("squeal");
    await page.locator('input[data-key="drive.amplitude"]').scrollIntoViewIfNeeded();
    for (const selector of ["#verdict", '#chart canvas[data-direction="going"]', "#chart canvas"]) {
      const { x, y, width, height } = await page.locator(selector).first().boundingBox();
      assert.ok(x >= 0 && x + width <= 390 && y >= 0 && y + height < 844 / 2, `${selector} at ${y}`);
    }
    const small = await page
      .locator("button, select, summary, input:not([type=checkbox]):not([type=radio]), .segments label, .check")
      .evaluateAll((all) =>
        all
          .map((element) => ({ element, box: element.getBoundingClientRect() }))
          .filter(({ element, box }) => element.checkVisibility({ visibilityProperty: true }) && box.height < 44)
          .map(({ element, box }) => `${element.outerHTML.slice(0, 80)} ${box.height}`),
      );
    assert.deepEqual(small, []);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  } finally {
    await page.setViewportSize({ width: 1440, height: 900 });
  }
});

test("nothing went wrong on the way, and nothing left the page's own origin", () => {
  assert.deepEqual(
    browser.sins.filter((sin) => !/status of 400/.test(sin)),
    [],
  ); // "nonsense" was refused
});
