// The page in one file within another page: a live report from the disk, and a cell of a notebook, as
// python/stridor/_html.py writes it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFile, stat, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import { dirname, join } from "node:path";
import { before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { openPage, program } from "../browser/session.mjs";
import { scratchFolder } from "../scratch.mjs";
import { until } from "../until.mjs";
import { openFile, ready, settled, verdict, write } from "./one_file.mjs";

const python = join(dirname(fileURLToPath(import.meta.url)), "../../../python/stridor");
const folder = scratchFolder();

before(async () => {
  await writeFile(join(folder, "squeal.toml"), execFileSync(program, ["init", "squeal"]));
});

function report(name, ...more) {
  const options = ["--no-advice", "--points", "4", "-o", name, ...more];
  execFileSync(program, ["report", "squeal.toml", ...options], { cwd: folder, stdio: "pipe" });
  return join(folder, name);
}

test("a live report has the design's sliders and chart in it, and moves", async (t) => {
  const [plain, live] = [report("plain.html"), report("live.html", "--live")];
  assert.ok((await stat(live)).size - (await stat(plain)).size < 2e6);
  const { page, sins } = await openFile(t, live);
  assert.match(await page.locator(".headline").textContent(), /Squeals/);
  await page.frameLocator(".live iframe").locator("#stridor-core").waitFor({ state: "attached" });
  assert.equal(await page.frameLocator(".live iframe").locator("#verdict").count(), 0);
  assert.equal(page.workers().length, 0, "closed, it costs nothing");
  await page.locator(".live summary").focus();
  await page.keyboard.press("Enter");
  const frame = page.frameLocator(".live iframe");
  await settled(frame);
  assert.equal(await verdict(frame), "squeal");
  const preload = frame.locator('[data-field="contact.kinetic_friction"]');
  await preload.fill("0.2");
  await preload.press("Enter");
  await until(async () => (await verdict(frame)) !== "squeal", "another verdict");
  await settled(frame);
  assert.equal(page.url(), pathToFileURL(live).href, "the report's address stays");
  assert.deepEqual(sins, []);
});

test("a live report reads as any other without scripts, and on paper", async (t) => {
  const live = report("live.html", "--live");
  const { page } = await openFile(t, live, { javaScriptEnabled: false });
  assert.equal(await page.locator(".live").isVisible(), false);
  assert.match(await page.locator(".headline").textContent(), /Squeals/);
  const paper = await openFile(t, live);
  assert.equal(await paper.page.locator(".live").isVisible(), true);
  await paper.page.emulateMedia({ media: "print" });
  assert.equal(await paper.page.locator(".live").isVisible(), false);
});

/** What `Page._repr_html_` gives for a file. */
function cell(file) {
  const script =
    "import importlib.util, pathlib, sys\n" +
    "spec = importlib.util.spec_from_file_location('html_pieces', sys.argv[1])\n" +
    "pieces = importlib.util.module_from_spec(spec); spec.loader.exec_module(pieces)\n" +
    "sys.stdout.buffer.write(pieces.frame(pathlib.Path(sys.argv[2]).read_bytes(), 820, 'x').encode())\n";
  return execFileSync("python3", ["-B", "-c", script, join(python, "_html.py"), file], { maxBuffer: 1e8 });
}

test("cells of a notebook have a page each, and leave the notebook's address alone", async (t) => {
  const cells = [];
  for (const kind of ["creak", "quiet"]) {
    cells.push(cell(write(join(folder, `${kind}.html`), ready(kind))).toString());
  }
  const notebook = Buffer.from(`<!doctype html><meta charset="utf-8"><title>Notebook</title>${cells.join("<hr>")}`);
  const server = createServer((request, response) => {
    response.writeHead(request.url === "/lab" ? 200 : 404, { "Content-Type": "text/html; charset=utf-8" });
    response.end(request.url === "/lab" ? notebook : "");
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  t.after(() => server.close());
  const origin = `http://127.0.0.1:${server.address().port}`;
  const browser = await openPage({ origin, link: () => `${origin}/lab` });
  t.after(() => browser.close());
  const { page, sins } = browser;
  await page.route("**/favicon.ico", (route) => route.fulfill({ status: 204 }));
  await browser.goto();
  const frames = [0, 1].map((k) => page.frameLocator(`iframe >> nth=${k}`));
  for (const frame of frames) await settled(frame);
  assert.deepEqual(await Promise.all(frames.map((each) => verdict(each))), ["creak", "none"]);
  const before = await page.evaluate(() => history.length);
  const [frame] = frames;
  await frame.locator("#share summary").click();
  assert.equal(await frame.locator("#copy-link").count(), 0);
  assert.equal(await frame.locator("#open-case").count(), 0);
  await frame.locator("#paste-link").fill("http://somewhere/#preset=squeal");
  await frame.locator("#paste-link").press("Enter");
  await until(async () => (await verdict(frame)) === "squeal", "the case of the link");
  const saving = page.waitForEvent("download");
  await frame.locator("#save-page").click();
  const saved = join(folder, "saved.html");
  await (await saving).saveAs(saved);
  const again = await openFile(t, saved);
  await settled(again.page);
  assert.equal(await again.page.locator("#verdict").getAttribute("data-going"), "squeal");
  assert.ok((await readFile(saved)).length < 1.65e6, "each letter is a byte");
  assert.equal(await verdict(frames[1]), "none", "the other cell stays");
  assert.equal(page.url(), `${origin}/lab`);
  assert.equal(await page.evaluate(() => history.length), before);
  assert.deepEqual([...sins, ...again.sins], []);
});
