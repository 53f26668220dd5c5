// The page in one file in Firefox, from the disk, in three widths.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { firefox, openFirefox } from "../browser/firefox.mjs";
import { lacking } from "../browser/needs.mjs";
import { program } from "../browser/session.mjs";

const skip = lacking(firefox, "Firefox", "firefox-esr");

test("the page in one file works in Firefox, wide and narrow", { skip, timeout: 600_000 }, async (t) => {
  const folder = await mkdtemp(join(tmpdir(), "stridor-one-file-"));
  t.after(() => rm(folder, { recursive: true, force: true }));
  const file = join(folder, "page.html");
  execFileSync(program, ["page", "-o", file]);
  const browser = await openFirefox(firefox);
  t.after(() => browser.close());
  for (const width of [1440, 1024, 390]) {
    await browser.resize({ width, height: 900 });
    await browser.goto(`${pathToFileURL(file).href}?${width}#preset=creak`);
    await browser.wait(`return document.querySelector('#verdict')?.getAttribute("aria-busy") === "false"
      && document.querySelector('#chart')?.dataset.done === "true";`);
    assert.equal(await browser.run("return document.querySelector('#verdict').dataset.going;"), "creak");
    const overflow = "return document.documentElement.scrollWidth - document.documentElement.clientWidth;";
    assert.ok((await browser.run(overflow)) <= 0, `${width} px`);
  }
  for (const view of ["spectra", "modes", "friction", "quiet"]) {
    await browser.click(`#tab-${view}`);
    await browser.wait(`return !document.querySelector('#view-${view}').hidden;`);
  }
  assert.deepEqual(await browser.sins("page.html"), []);
  // in a report, and with workers for a whole chart: the frame is under the report's policy
  const toml = execFileSync(program, ["init", "creak"], { encoding: "utf8" });
  const options = ["-", "--live", "--no-chart", "--no-advice", "-o", "live.html"];
  execFileSync(program, ["report", ...options], { cwd: folder, input: toml, stdio: ["pipe", "pipe", "pipe"] });
  await browser.goto(pathToFileURL(join(folder, "live.html")).href);
  await browser.click(".live summary");
  await browser.wait("return document.querySelector('.live iframe').getBoundingClientRect().height > 0;");
  await browser.run("document.querySelector('.live iframe').scrollIntoView();"); // it begins when it is seen
  await browser.enter(".live iframe");
  await browser.wait(`return document.querySelector('#verdict')?.getAttribute("aria-busy") === "false"
      && document.querySelector('#chart')?.dataset.done === "true";`);
  assert.equal(await browser.run("return document.querySelector('#verdict').dataset.going;"), "creak");
  const unknown = "Feature Policy: Skipping unsupported feature name"; // what Chromium asks of a frame
  assert.deepEqual(
    (await browser.sins("live.html")).filter((text) => !text.includes(unknown)),
    [],
  );
});
