import assert from "node:assert/strict";
import { test } from "node:test";
import { namePlaces, spread } from "../../../src/data/regions.ts";

test("a name stands in the middle of the largest square of its category", () => {
  const category = Uint8Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, 1]);
  assert.deepEqual(namePlaces(category, 4, 4), [
    { d: 0, category: 0, x: 1.5, y: 1.5, cells: 3 },
    { d: 0, category: 1, x: 3.5, y: 0.5, cells: 1 },
  ]);
});

test("squares do not reach round the edge of a row nor into the other direction", () => {
  const places = namePlaces(new Uint8Array(2 * 3 * 3), 3, 3);
  assert.deepEqual(
    places.map(({ d, cells }) => [d, cells]),
    [
      [0, 3],
      [1, 3],
    ],
  );
});

test("figures spread to cells that were not computed, and only there", () => {
  const figure = Float32Array.from([5, NaN, NaN, NaN, 7, NaN]);
  const computed = Uint8Array.from([1, 0, 0, 0, 1, 1]);
  assert.deepEqual([...spread(figure, computed, 3, 2)], [5, 5, NaN, 5, 7, NaN]);
  assert.deepEqual([...spread(figure, null, 3, 2)], [...figure]);
});

test("figures do not spread into the other direction", () => {
  const result = spread(Float32Array.from([1, NaN, NaN, 2]), Uint8Array.from([1, 0, 0, 1]), 1, 2);
  assert.deepEqual([...result], [1, 1, 2, 2]);
});
