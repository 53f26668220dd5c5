// A session with the page in one file behind a proxy through which all would go: it refuses all, and counts who asks.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFile } from "node:fs/promises";
import { createServer } from "node:net";
import { join } from "node:path";
import { test } from "node:test";
import { program } from "../browser/session.mjs";
import { scratchFolder } from "../scratch.mjs";
import { until } from "../until.mjs";
import { drop, openFile, ready, saved, settled, verdict, write } from "./one_file.mjs";

const folder = scratchFolder();

/** What the browser asks its maker for by itself: updates, lists of dangerous sites. */
const makers = /^\S+ (https?:\/\/)?([\w-]+\.)*(google|googleapis|gstatic|googleusercontent|chromium|gvt1)\.\w+[:/]/;

/** A proxy through which all goes, this machine's own addresses too; `asked()` are the lines of who asked. */
async function startProxy(t) {
  const lines = [];
  const proxy = createServer((socket) => {
    socket.on("error", () => {});
    socket.once("data", (bytes) => {
      lines.push(bytes.toString("latin1").split("\r\n")[0]);
      socket.end("HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\nConnection: close\r\n\r\n");
    });
  });
  await new Promise((resolve) => proxy.listen(0, "127.0.0.1", resolve));
  t.after(() => proxy.close());
  const server = `http://127.0.0.1:${proxy.address().port}`;
  return {
    asked: () => lines.filter((line) => !makers.test(line)),
    all: () => lines,
    options: { offline: false, proxy: { server, bypass: "<-loopback>" } },
  };
}

// an address in each word that a page shows or keeps
const elsewhere = "http://elsewhere.test";
const hostileCase = () =>
  `title = "<img src=${elsewhere}/title.png><link rel=prefetch href=${elsewhere}/next>"\n` +
  ready("squeak").replace(/^title.*\n/m, "");
const hostileFragment =
  `#preset=${encodeURIComponent(`${elsewhere}/preset`)}&set=${encodeURIComponent(`drive.file=${elsewhere}/x.csv`)}` +
  `&view=${encodeURIComponent(`//elsewhere.test/view`)}`;

test("a page that asks somebody is seen by the proxy", { timeout: 600_000 }, async (t) => {
  const proxy = await startProxy(t);
  const file = join(folder, "talkative.html");
  await writeFile(
    file,
    `<!doctype html><link rel="icon" href="data:,"><img src="${elsewhere}/picture.png">
    <script>
      fetch("${elsewhere}/fetched").catch(() => {});
      navigator.sendBeacon("${elsewhere}/beacon", "x");
      fetch("http://127.0.0.1:8765/this-machine").catch(() => {});
      new WebSocket("ws://elsewhere.test/socket");
      new Worker(URL.createObjectURL(new Blob(["fetch('${elsewhere}/worker').catch(() => {})"])));
    </script>`,
  );
  const { sins } = await openFile(t, file, proxy.options);
  const wanted = ["picture.png", "fetched", "beacon", "127.0.0.1:8765/this-machine", "worker", "elsewhere.test:80"];
  for (const name of wanted)
    await until(() => proxy.asked().some((line) => line.includes(name)), `the request of ${name}`, { limit: 60_000 });
  assert.ok(sins.some((sin) => sin === `request: ${elsewhere}/picture.png`));
});

test("a whole session with the page asks nobody for anything", { timeout: 900_000 }, async (t) => {
  const proxy = await startProxy(t);
  const { page, sins } = await openFile(t, write(join(folder, "page.html")), proxy.options);
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await settled(page);
  // every view, and both sounds of Listen
  for (const view of ["spectra", "modes", "energy", "friction", "quiet", "listen"]) {
    await page.locator(`#tab-${view}`).click();
    await page.waitForSelector(`#view-${view}:not([hidden]):not(:has([aria-busy="true"]))`);
  }
  await page.locator("#keep").click();
  await page.waitForSelector('[data-slot="B"][data-bytes]');
  await page.locator("#audio-A").evaluate((audio) => audio.play());
  await until(() => page.locator("#audio-A").evaluate((audio) => audio.currentTime > 0), "the sound");
  // all that is saved and shared
  await page.locator("#share summary").click();
  for (const [id, beginning] of [
    ["png", "\x89PNG"],
    ["csv", "# program"],
    ["page", "<!doctype html>"],
  ])
    // prettier-ignore
    assert.ok((await saved(page, () => page.locator(`#save-${id}`).click())).toString("latin1").startsWith(beginning));
  for (const id of ["copy-link", "copy-command", "copy-toml", "copy-chart-toml"]) {
    await page.locator(`#${id}`).click();
    await until(() => page.locator("#share-note").evaluate((note) => note.dataset.copied), id);
    await page.locator("#share-note").evaluate((note) => delete note.dataset.copied);
  }
  await page.keyboard.press("Escape");
  // a recording, a case and a link that name addresses
  const sound = join(folder, "heard.wav");
  execFileSync(program, ["listen", "-", "-o", sound], { input: ready("squeal") });
  await page.locator("#share summary").click();
  await page.locator("#open-case").setInputFiles(sound);
  await page.waitForSelector('[data-slot="B"] h3:has-text("heard.wav")');
  await drop(page, { "list.mp3": `#EXTM3U\n${elsewhere}/stream.mp3\n` });
  await until(async () => /no sound/.test(await page.locator("#complaint").textContent()), "the refusal");
  await drop(page, { "hostile.toml": hostileCase() });
  await until(() => page.url().includes("preset=file"), "the hostile case");
  await settled(page);
  assert.equal(await verdict(page), "squeak");
  await page.goto(`${page.url().replace(/#.*/, "")}${hostileFragment}`);
  await until(async () => /no preset/.test(await page.locator("#complaint").textContent()), "the refusal of the link");
  assert.deepEqual(proxy.asked(), [], `of ${proxy.all().length} requests`);
  assert.deepEqual(sins, []);
  // it would not have been allowed to
  const refused = await page.evaluate((url) => fetch(url).then(() => "", String), `${elsewhere}/allowed`);
  assert.match(refused, /TypeError/);
  assert.deepEqual(proxy.asked(), []);
  t.diagnostic(`the browser itself asked its maker ${proxy.all().length} times`);
});
