// What a browser hears in place of a microphone, for the tests of the page that a program serves and of that in one
// file.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { mkdtemp, rm, stat, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { until } from "../until.mjs";

/** Switches of a browser that hears this WAV file, over and over, and lets every page hear it. */
export const hearing = (wav) => [
  "--use-fake-device-for-media-stream",
  "--use-fake-ui-for-media-stream",
  `--use-file-for-fake-audio-capture=${wav}`,
];
/** Of one that lets no page hear anything, and of one without a microphone. */
export const refusing = ["--use-fake-device-for-media-stream", "--deny-permission-prompts"];
export const deaf = ["--use-fake-ui-for-media-stream"];

/** Preferences of a Firefox that hears a tone of 1 kHz and lets every page hear it, of one that lets none, and of a
    deaf one. */
export const firefoxHearing = { "media.navigator.streams.fake": true, "media.navigator.permission.disabled": true };
export const firefoxRefusing = { "media.navigator.streams.fake": true, "permissions.default.microphone": 2 };
export const firefoxDeaf = { "media.navigator.permission.disabled": true };

/** Whether this machine has the program that plays to nobody. */
export const hasLoudspeaker = spawnSync("pulseaudio", ["--version"]).status === 0;

/** A loudspeaker that nobody hears, until the test ends; gives the environment of a Firefox, whose audio needs one. */
export async function openLoudspeaker(t) {
  const folder = await mkdtemp(join(tmpdir(), "stridor-loudspeaker-"));
  const socket = join(folder, "socket");
  const loads = ["module-null-sink", `module-native-protocol-unix auth-anonymous=1 socket=${socket}`];
  const options = ["-n", "--daemonize=no", "--use-pid-file=no", "--exit-idle-time=-1", "--disable-shm=yes"];
  const child = spawn("pulseaudio", [...options, ...loads.flatMap((load) => ["-L", load])], {
    stdio: "ignore",
    env: { ...process.env, HOME: folder, XDG_RUNTIME_DIR: folder },
  });
  const ended = new Promise((resolve) => child.once("exit", resolve));
  t.after(async () => {
    child.kill();
    await ended;
    await rm(folder, { recursive: true, force: true });
  });
  await until(() => stat(socket).catch(() => null), "a loudspeaker");
  return { PULSE_SERVER: `unix:${socket}` };
}

/** Writes ten seconds of a squeal: a tone of 1.2 kHz with its overtones, which goes on where it begins anew. */
export async function writeSqueal(file) {
  const [rate, seconds, loudest] = [48_000, 10, 0.25];
  const bytes = Buffer.alloc(44 + 2 * rate * seconds);
  bytes.write("RIFF", 0, "latin1");
  bytes.writeUInt32LE(bytes.length - 8, 4);
  bytes.write("WAVEfmt ", 8, "latin1");
  [16, 1 + (1 << 16), rate, 2 * rate, 2 + (16 << 16)].forEach((number, k) => bytes.writeUInt32LE(number, 16 + 4 * k));
  bytes.write("data", 36, "latin1");
  bytes.writeUInt32LE(bytes.length - 44, 40);
  for (let k = 0; k < rate * seconds; ++k) {
    const turn = (2 * Math.PI * 1200 * k) / rate;
    const sample = Math.sin(turn) + 0.3 * Math.sin(2 * turn) + 0.1 * Math.sin(3 * turn);
    bytes.writeInt16LE(Math.round(32767 * loudest * sample), 44 + 2 * k);
  }
  await writeFile(file, bytes);
}

const told = (page) => page.locator("#microphone-verdict").textContent();

/** A newcomer's way: start, see level and verdict, stop, go on, leave the tab. */
export async function expectHeard(page, picture) {
  await page.locator("#microphone").click();
  await until(async () => /The last \d+ s, by ear: squeal \(/.test(await told(page)), "a verdict");
  const level = await page.locator("#microphone-heard .bar .muted").textContent();
  assert.match(level, /^-\d+ dB of full scale$/);
  assert.ok(await page.locator("#microphone-heard .spectrogram").isVisible());
  const first = Number(/last (\d+) s/.exec(await told(page))[1]);
  assert.ok(first <= 6, `the first verdict was of ${first} s`);
  await until(async () => /The last 10 s/.test(await told(page)), "ten seconds");
  if (picture) await page.screenshot({ path: picture, fullPage: true });
  const stop = page.locator("#microphone-stop");
  await stop.click();
  assert.equal(await stop.textContent(), "Start");
  assert.equal(await page.locator("#microphone-heard .bar .muted").textContent(), "");
  await stop.click();
  await until(async () => /The last [2-6] s/.test(await told(page)), "a new beginning");
  await page.locator("#tab-response").click();
  await page.locator("#tab-listen").click();
  assert.equal(await stop.textContent(), "Start");
}

/** Says what to do where nothing is heard. */
export async function expectUnheard(page, words, next = "Start") {
  await page.locator("#microphone").click();
  await until(async () => words.test(await told(page)), `"${words}"`);
  assert.equal(await page.locator("#microphone-stop").textContent(), next);
}
