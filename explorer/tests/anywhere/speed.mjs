// How soon the page in one file shows its first pictures, beside the server's, in one run:
// `node tests/anywhere/speed.mjs [TURNS]`. Prints medians and judges none of them, for they are the machine's as well.
// The page's own clock, which begins with the opening, says when the first pictures are there.
import { execFileSync } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { openPage, program, startExplorer } from "../browser/session.mjs";

const folder = await mkdtemp(join(tmpdir(), "stridor-speed-"));
const file = join(folder, "page.html");
execFileSync(program, ["page", "-o", file]);
const explorer = await startExplorer();
const { href } = pathToFileURL(file);
const views = ["spectra", "modes", "energy", "friction", "listen", "quiet"];

const firstPictures = {
  "verdict": '#verdict[aria-busy="false"]',
  "chart": '#chart:not([data-redraws="0"])',
  "whole chart": '#chart[data-done="true"]',
};

/** Runs in the page before all else: notes when each picture is there first. */
function noteFirst(pictures) {
  const times = (globalThis.firstTimes = {});
  new MutationObserver(() => {
    for (const [name, selector] of Object.entries(pictures))
      if (!(name in times) && document.querySelector(selector)) times[name] = Math.round(performance.now());
  }).observe(document, { subtree: true, childList: true, attributes: true });
}

async function timed(what, from) {
  const browser = await openPage(from);
  const { page } = browser;
  await page.addInitScript(noteFirst, firstPictures);
  await page.waitForTimeout(2000); // the browser's own start
  await browser.goto();
  for (const selector of Object.values(firstPictures)) await page.waitForSelector(selector);
  const times = await page.evaluate(() => globalThis.firstTimes);
  const painted = () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime;
  times["first letters"] = Math.round(await page.evaluate(painted));
  for (const view of views) {
    const begin = performance.now();
    await page.locator(`#tab-${view}`).click();
    await page.waitForSelector(`#view-${view}:not([hidden]):not(:has([aria-busy="true"]))`);
    times[view] = Math.round(performance.now() - begin);
  }
  await browser.close();
  for (const [name, time] of Object.entries(times)) ((taken[name] ??= {})[what] ??= []).push(time);
}

const taken = {}; // [ms] by what was waited for and by carrier
const turns = Number(process.argv[2] ?? 5);
for (let turn = 0; turn < turns; ++turn) {
  await timed("server", explorer);
  await timed("one file", { origin: href, link: () => href });
}
const median = (times) => times.sort((a, b) => a - b)[Math.floor(times.length / 2)];
console.log(`median of ${turns} [ms]`.padEnd(20), "server".padStart(8), "one file".padStart(9));
for (const [name, { "server": served, "one file": inside }] of Object.entries(taken))
  console.log(name.padEnd(20), String(median(served)).padStart(8), String(median(inside)).padStart(9));
await explorer.stop();
await rm(folder, { recursive: true, force: true });
