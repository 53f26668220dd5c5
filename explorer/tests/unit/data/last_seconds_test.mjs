import assert from "node:assert/strict";
import { test } from "node:test";
import { LastSeconds, wavHead, wavHeadSize } from "../../../src/data/last_seconds.ts";
import { random } from "../random.mjs";

/** The samples of a WAV file of 16 bits, from -1 to 1. */
function samplesIn(wav) {
  const view = new DataView(wav.buffer);
  assert.equal(view.getUint32(4, true), wav.length - 8);
  assert.equal(view.getUint32(40, true), wav.length - wavHeadSize);
  return Array.from(
    { length: (wav.length - wavHeadSize) / 2 },
    (_, k) => view.getInt16(wavHeadSize + 2 * k, true) / 32767,
  );
}

test("in whatever pieces a sound comes, its last seconds are held, oldest first", () => {
  const number = random(5);
  const rate = 100;
  for (let run = 0; run < 50; ++run) {
    const last = new LastSeconds(rate, 1.5);
    const all = [];
    for (let piece = 0; piece < 12; ++piece) {
      const samples = Float32Array.from({ length: Math.floor(number() * 220) }, () => 2 * number() - 1);
      last.push(samples);
      all.push(...samples);
      const held = samplesIn(last.wav());
      const wanted = all.slice(-150);
      assert.equal(held.length, wanted.length);
      held.forEach((sample, k) => assert.ok(Math.abs(sample - wanted[k]) < 0.5001 / 32767));
      assert.equal(last.heard, all.length / rate);
      assert.equal(last.held, wanted.length / rate);
    }
  }
});

test("what is new is told by what is known, wherever the browser's clock stands", () => {
  const number = random(9);
  const noise = Float32Array.from({ length: 60_000 }, () => 2 * number() - 1);
  for (const period of [Infinity, 128, 375]) {
    // a tone whose periods are the same bits is as new wherever it is joined
    const sound = period === Infinity ? noise : noise.map((_, k) => noise[k % period]);
    const last = new LastSeconds(48_000, 2);
    let end = 4096;
    last.follow(sound.subarray(0, end), end);
    for (; end < 50_000;) {
      const news = 128 * Math.floor(number() * 60);
      end += news;
      last.follow(
        sound.subarray(Math.max(0, end - 16_384), end),
        Math.max(0, news + 128 * Math.round(4 * number() - 2)),
      );
    }
    const held = samplesIn(last.wav());
    if (period === Infinity) assert.equal(held.length, end);
    held.forEach((sample, k) => assert.ok(Math.abs(sample - sound[k]) < 0.5001 / 32767, `${period}: ${k}`));
  }
});

test("what was missed is left out", () => {
  const number = random(11);
  const sound = Float32Array.from({ length: 20_000 }, () => 2 * number() - 1);
  const last = new LastSeconds(48_000, 2);
  last.follow(sound.subarray(0, 4096), 4096);
  last.follow(sound.subarray(20_000 - 4096), 20_000 - 4096);
  assert.equal(last.held, (2 * 4096) / 48_000);
});

test("the level is that of the last eighth of a second", () => {
  const last = new LastSeconds(8000, 2);
  assert.equal(last.level, -Infinity);
  last.push(new Float32Array(8000).fill(1));
  assert.equal(last.level, 0);
  // a sine of a tenth: -20 dB, and -3.01 dB for its shape
  last.push(Float32Array.from({ length: 1000 }, (_, k) => 0.1 * Math.sin((2 * Math.PI * 400 * k) / 8000)));
  assert.ok(Math.abs(last.level + 23.0103) < 1e-3, `${last.level}`);
});

test("what is louder than a sample can be is cut, and never turns round", () => {
  const last = new LastSeconds(8000, 1);
  last.push(Float32Array.of(1.5, -7, Infinity, 0.5));
  assert.deepEqual(samplesIn(last.wav()).slice(0, 3), [1, -1, 1]);
});

test("the head of a WAV file tells rate, channels and coding", () => {
  const view = wavHead(10, 2, 44100, { bytes: 4, kind: 3 });
  assert.equal(view.byteLength, wavHeadSize + 80);
  assert.deepEqual(
    [20, 22, 32, 34].map((at) => view.getUint16(at, true)),
    [3, 2, 8, 32],
  );
  assert.deepEqual(
    [24, 28].map((at) => view.getUint32(at, true)),
    [44100, 352800],
  );
});
