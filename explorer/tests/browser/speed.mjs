// How fast the page is, in headless Chromium: `node tests/browser/speed.mjs`. Prints figures and judges none of them,
// for they are the machine's as well.
import { openPage, startExplorer } from "./session.mjs";

const explorer = await startExplorer();
const browser = await openPage(explorer);
const { page } = browser;

// --- the first chart on screen
const begin = performance.now();
await browser.goto();
await page.waitForFunction(() => Number(document.querySelector("#chart")?.dataset.redraws) > 0, null, {
  polling: "raf",
});
const firstLook = performance.now() - begin;
await page.waitForSelector('#chart[data-done="true"]');
const firstChart = performance.now() - begin;
console.log(`first chart on screen  ${firstLook.toFixed(0)} ms after opening; complete ${firstChart.toFixed(0)} ms`);

// --- a chart of 64 by 64 cells that follows a slider
async function follow(label, fragment) {
  await page.goto("about:blank");
  await page.goto(`${explorer.origin}/${fragment}`);
  await page.waitForSelector('#chart[data-done="true"]');
  const slider = page.locator('input[type="range"][data-key="joint.incidence_angle"]');
  const box = await slider.boundingBox();
  const counts = () =>
    page.locator("#chart").evaluate((chart) => [Number(chart.dataset.redraws), Number(chart.dataset.charts ?? 0)]);
  await page.mouse.move(box.x + box.width * 0.35, box.y + box.height / 2);
  await page.mouse.down();
  const [redraws, charts] = await counts();
  const from = performance.now();
  for (let step = 0; performance.now() - from < 5000; ++step) {
    await page.mouse.move(box.x + box.width * (0.4 + 0.05 * Math.sin(step / 10)), box.y + box.height / 2);
    await page.waitForTimeout(20);
  }
  const seconds = (performance.now() - from) / 1000;
  const [redrawsAfter, chartsAfter] = await counts();
  await page.mouse.up();
  console.log(
    `${label}  ${((redrawsAfter - redraws) / seconds).toFixed(1)} redraws per second, ` +
      `${((chartsAfter - charts) / seconds).toFixed(1)} of them refined to the end`,
  );
}
await follow("slider, sinusoidal ", "");
await follow("slider, constant   ", "#preset=squeal&drive.kind=constant&drive.velocity=0.1");

// --- a history of a million samples that is panned
await page.goto("about:blank");
await page.goto(`${explorer.origin}/`);
await page.waitForFunction(() => Number(document.querySelector("[data-samples]")?.dataset.samples) > 9e5);
const samples = await page.locator("[data-samples]").first().getAttribute("data-samples");
const canvas = page.locator("#response");
const box = await canvas.boundingBox();
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
for (let turn = 0; turn < 4; ++turn) await page.mouse.wheel(0, -240);
await page.waitForTimeout(300);
await page.evaluate(() => {
  window.frames_ = [];
  const note = (now) => {
    window.frames_.push(now);
    requestAnimationFrame(note);
  };
  requestAnimationFrame(note);
});
await page.mouse.down();
for (let step = 0; step < 150; ++step) {
  await page.mouse.move(box.x + box.width * (0.5 + 0.3 * Math.sin(step / 12)), box.y + box.height / 2);
  await page.waitForTimeout(10);
}
await page.mouse.up();
const gaps = await page.evaluate(() => window.frames_.slice(1).map((time, k) => time - window.frames_[k]));
gaps.sort((a, b) => a - b);
const mean = gaps.reduce((sum, gap) => sum + gap, 0) / gaps.length;
console.log(
  `panning ${samples} samples  ${(1000 / mean).toFixed(0)} frames per second, ` +
    `the slowest of twenty ${(1000 / gaps[Math.floor(gaps.length * 0.95)]).toFixed(0)}`,
);

await browser.close();
await explorer.stop();
