// The microphone of the page in one file: what it hears stays in the file.
import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { deaf, expectHeard, expectUnheard, hearing, refusing, writeSqueal } from "../browser/hearing.mjs";
import { openFile, write } from "./one_file.mjs";

let folder;
let file;

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "stridor-microphone-"));
  file = write(join(folder, "page.html"));
});

after(() => rm(folder, { recursive: true, force: true }));

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
