import assert from "node:assert/strict";
import { test } from "node:test";
import { columns, extremes, pyramid } from "../../../src/data/pyramid.ts";
import { random } from "../random.mjs";

function plainly(samples, from, to) {
  let [low, high] = [Infinity, -Infinity];
  for (let k = Math.max(0, from); k < Math.min(to, samples.length); ++k) {
    low = Math.min(low, samples[k]);
    high = Math.max(high, samples[k]);
  }
  return [low, high];
}

test("extremes are those of the samples, for any span", () => {
  const next = random(2);
  for (const size of [1, 7, 8, 9, 63, 64, 65, 513, 5000]) {
    const samples = Float32Array.from({ length: size }, () => next() - 0.5);
    const tree = pyramid(samples);
    for (let round = 0; round < 300; ++round) {
      const from = Math.floor(next() * (size + 4)) - 2;
      const to = from + Math.floor(next() * (size + 4));
      assert.deepEqual(extremes(tree, from, to), plainly(samples, from, to), `${size}: ${from} to ${to}`);
    }
  }
});

test("a peak of one sample in a million is in the picture at any zoom", () => {
  const samples = new Float32Array(1_000_000);
  samples[654_321] = 5;
  const tree = pyramid(samples);
  for (const [from, to] of [
    [0, 1e6],
    [654_000.5, 655_000.25],
    [600_000, 700_000.7],
  ]) {
    const parts = columns(tree, from, to, 800);
    assert.equal(Math.max(...parts), 5);
  }
});

test("a view of a million samples takes well under a frame", () => {
  const samples = Float32Array.from({ length: 1_000_000 }, (_, k) => Math.sin(k));
  const tree = pyramid(samples);
  const began = performance.now();
  const views = 100;
  for (let k = 0; k < views; ++k) columns(tree, 1000 * k + 0.3, 1_000_000 - 1000 * k, 1600);
  assert.ok((performance.now() - began) / views < 16, "16 ms are a frame");
});

test("no samples have no extremes", () => {
  assert.deepEqual(extremes(pyramid(new Float32Array()), 0, 10), [Infinity, -Infinity]);
});
