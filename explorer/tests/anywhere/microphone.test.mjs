// The microphone of the page in one file: what it hears stays in the file.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { firefox, openFirefox } from "../browser/firefox.mjs";
import {
  deaf,
  expectHeard,
  expectUnheard,
  firefoxDeaf,
  firefoxHearing,
  firefoxRefusing,
  hasLoudspeaker,
  hearing,
  openLoudspeaker,
  refusing,
  writeSqueal,
} from "../browser/hearing.mjs";
import { lacking } from "../browser/needs.mjs";
import { scratchFolder } from "../scratch.mjs";
import { openFile, write } from "./one_file.mjs";

const folder = scratchFolder();
let file;

before(() => {
  file = write(join(folder, "page.html"));
});

const listening = (t, switches) => openFile(t, file, { fragment: "#view=listen", switches });

test("a microphone is judged in the file, which may connect to nothing", { timeout: 600_000 }, async (t) => {
  const squeal = join(folder, "squeal.wav");
  await writeSqueal(squeal);
  const { page, sins } = await listening(t, hearing(squeal));
  await expectHeard(page, process.env.STRIDOR_PICTURE);
  assert.deepEqual(sins, []);
  assert.match(await readFile(file, "latin1"), /connect-src 'none'/);
});

test("a microphone that is refused, or is none, leaves a sentence", { timeout: 600_000 }, async (t) => {
  const still = "Object.defineProperty(BaseAudioContext.prototype, 'currentTime', { value: 0 });";
  for (const [switches, words, init] of [
    [refusing, /The microphone was refused .*Allow it beside the page's address/],
    [deaf, /There is no microphone\. Plug one in/],
    [hearing(join(folder, "squeal.wav")), /audio does not run .*start once more/, still],
  ]) {
    const { page, sins } = await openFile(t, file, { fragment: "#view=listen", switches, init });
    await expectUnheard(page, words, init ? "Stop" : "Start");
    assert.deepEqual(sins, []);
    await page.context().close();
  }
});

const skip = lacking(firefox, "Firefox", "firefox-esr");

async function listeningFirefox(t, preferred, env = {}) {
  const browser = await openFirefox(firefox, { preferred, env });
  t.after(() => browser.close());
  await browser.goto(`${pathToFileURL(file).href}#view=listen`);
  await browser.wait("return document.querySelector('#microphone')?.checkVisibility();");
  return browser;
}

const silent = skip || lacking(hasLoudspeaker, "A loudspeaker", "pulseaudio");

test("Firefox judges a microphone in the file", { skip: silent, timeout: 600_000 }, async (t) => {
  const browser = await listeningFirefox(t, firefoxHearing, await openLoudspeaker(t));
  await expectHeard(browser);
  assert.deepEqual(await browser.sins("page.html"), []);
});

test("Firefox leaves a sentence where none is heard", { skip, timeout: 600_000 }, async (t) => {
  const nowhere = { PULSE_SERVER: "unix:/nowhere" };
  for (const [why, preferred, words, next] of [
    ["refused", firefoxRefusing, /The microphone was refused .*Allow it beside the page's address/],
    ["no microphone", firefoxDeaf, /There is no microphone\. Plug one in/],
    ["no loudspeaker", firefoxHearing, /audio does not run \(some want a loudspeaker for it\)/, "Stop"],
  ]) {
    await t.test(why, async (each) => {
      const browser = await listeningFirefox(each, preferred, nowhere);
      await expectUnheard(browser, words, next);
      assert.deepEqual(await browser.sins("page.html"), []);
    });
  }
});
