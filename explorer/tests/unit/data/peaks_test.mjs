import assert from "node:assert/strict";
import { test } from "node:test";
import { nearestPeak, peaksOf } from "../../../src/data/peaks.ts";

const lines = Array.from({ length: 400 }, (_, k) => 2.5 * k);
/** Levels whose tops are parabolas: 40 dB lower at 20 Hz from their middle, cut at a ground of 0 dB. */
const spectrum = (...tops) =>
  lines.map((f) => Math.max(0, ...tops.map(([middle, level]) => level - ((f - middle) / 20) ** 2 * 40)));

test("a peak between two lines is found where it is, with its level", () => {
  const found = peaksOf(lines, spectrum([428.5, 166.2], [857.1, 131]), 5);
  assert.equal(found.length, 2);
  for (const [k, [frequency, level]] of [
    [428.5, 166.2],
    [857.1, 131],
  ].entries()) {
    assert.ok(Math.abs(found[k].frequency - frequency) < 1e-9, String(found[k].frequency));
    assert.ok(Math.abs(found[k].level - level) < 1e-9, String(found[k].level));
  }
  assert.equal(nearestPeak(found, 600), found[0], "in octaves");
  assert.equal(nearestPeak(found, 610), found[1]);
});

test("ripple is no peak, nor is an end of the spectrum, nor what has no level", () => {
  const ripple = lines.map((_, k) => 50 + (k % 2));
  assert.deepEqual(peaksOf(lines, ripple, 5), []);
  assert.deepEqual(
    peaksOf(
      lines,
      lines.map((f) => -f),
      5,
    ),
    [],
  );
  assert.deepEqual(peaksOf(lines, Array(400).fill(null), 5), []);
  assert.equal(nearestPeak([], 100), undefined);
});

test("only the highest are told, the highest first", () => {
  const tops = [100, 300, 500, 700, 900].map((f, k) => [f, 60 + 10 * ((k * 3) % 5)]);
  const levels = peaksOf(lines, spectrum(...tops), 3).map(({ level }) => Math.round(level));
  assert.deepEqual(levels, [100, 90, 80]);
});
