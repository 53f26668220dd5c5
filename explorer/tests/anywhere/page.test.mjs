// The page in one file in a real browser, opened from the disk: nothing is asked of anybody, and all of it works.
import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { before, test } from "node:test";
import { scratchFolder } from "../scratch.mjs";
import { until } from "../until.mjs";
import { openFile, ready, saved, settled, verdict, write } from "./one_file.mjs";

const folder = scratchFolder();

const written = (name, toml) => write(join(folder, name), toml);

test("opens from the disk, judges, charts and says that nothing leaves", async (t) => {
  const { page, sins } = await openFile(t, written("plain.html"));
  await settled(page);
  assert.equal(await verdict(page), "squeal");
  assert.equal(await verdict(page, "coming"), "none");
  assert.match(await page.locator("#purpose").textContent(), /nothing leaves this machine/);
  const friction = page.locator('[data-field="contact.kinetic_friction"]');
  await friction.fill("0.3");
  await friction.press("Enter");
  await until(async () => (await verdict(page)) !== "squeal", "another verdict");
  await settled(page);
  for (const view of ["spectra", "modes", "energy", "friction", "listen", "quiet", "response"]) {
    await page.locator(`#tab-${view}`).click();
    await page.waitForSelector(`#view-${view}:not([hidden])`);
  }
  assert.equal(await page.locator("#tab-library").count(), 0);
  await page.locator("#tab-listen").click();
  await page.waitForSelector('[data-slot="A"][data-bytes]');
  assert.equal(await page.locator("#complaint").isVisible(), false);
  assert.deepEqual(sins, []);
});

test("begins with the case in it, whatever its structure", async (t) => {
  for (const kind of ["weatherstrip", "two-lips", "chain", "string"]) {
    const { page, sins } = await openFile(t, written(`${kind}.html`, ready(kind)));
    await page.waitForSelector('#verdict[aria-busy="false"]');
    assert.equal(await page.locator("#complaint").isVisible(), false, kind);
    assert.match(page.url(), /preset=file/);
    assert.deepEqual(sins, [], kind);
  }
});

test("knows the verdict and the chart of its case before its program has begun", async (t) => {
  for (const kind of [null, "quiet", "chain"]) {
    const file = written(`first-${kind}.html`, kind && ready(kind));
    const { page, sins } = await openFile(t, file, {
      init: "WebAssembly.compileStreaming = () => new Promise(() => {});",
    });
    await settled(page);
    if (kind !== "chain") assert.equal(await verdict(page), kind ? "none" : "squeal");
    assert.deepEqual(sins, [], kind ?? "paper");
  }
});

test("a case cannot say more than a case", async (t) => {
  const script = "</script><script>document.title='stolen'</script><img src=x onerror=alert(1)>";
  const toml = `title = '${script.replaceAll("'", '"')}'\n${ready("squeal").replace(/^title.*\n/m, "")}`;
  const fragment = `#preset=${encodeURIComponent(script)}&set=${encodeURIComponent(script)}`;
  for (const hash of ["", fragment]) {
    const { page, sins } = await openFile(t, written("hostile.html", toml), { fragment: hash });
    if (hash) await until(async () => /no preset/.test(await page.locator("#complaint").textContent()), "the refusal");
    else await settled(page);
    assert.equal(await page.title(), "Stridor");
    assert.equal(await page.locator("img[src=x]").count(), 0);
    assert.deepEqual(sins, []);
  }
});

test("saves itself with the design, and opens a case file", async (t) => {
  const { page, sins } = await openFile(t, written("save.html"), { fragment: "#preset=creak" });
  await settled(page);
  await page.locator("#share summary").click();
  const file = join(folder, "saved.html");
  await writeFile(file, await saved(page, () => page.locator("#save-page").click()));
  const again = await openFile(t, file);
  await settled(again.page);
  assert.equal(await verdict(again.page), "creak");
  const size = async (path) => (await readFile(path)).length;
  assert.ok((await size(file)) < (await size(written("plain.html"))) + 20_000);
  const quiet = join(folder, "quiet.toml");
  await writeFile(quiet, ready("quiet"));
  await page.locator("#open-case").setInputFiles(quiet);
  await until(async () => page.url().includes("preset=file"), "the case");
  await settled(page);
  assert.equal(await verdict(page), "none");
  await page.locator("#share summary").click();
  await writeFile(quiet, "contact = 1\n");
  await page.locator("#open-case").setInputFiles(quiet);
  await until(async () => (await page.locator("#share-note").textContent()).includes("contact"), "the refusal");
  assert.deepEqual([...sins, ...again.sins], []);
});

test("without WebAssembly it says what to do", async (t) => {
  const { page } = await openFile(t, written("plain.html"));
  await page.addInitScript(() => delete globalThis.WebAssembly);
  await page.reload();
  await page.waitForSelector('p.complaint[role="alert"]');
  assert.match(await page.locator("p.complaint").textContent(), /runs no WebAssembly/);
});
