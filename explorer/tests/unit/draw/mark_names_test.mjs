import assert from "node:assert/strict";
import { test } from "node:test";
import { besideMarks, markRadius } from "../../../src/draw/mark_names.ts";

const box = { left: 0, top: 0, width: 300, height: 150 };
const isApart = (a, b) =>
  a.left >= b.left + b.width || b.left >= a.left + a.width || a.top >= b.top + b.height || b.top >= a.top + a.height;

/** Three lips as they lie on a chart at 1280 px. */
const lips = [
  { x: 148, y: 46 },
  { x: 106, y: 46 },
  { x: 172, y: 58 },
];

test("names lie neither on each other nor on another's mark", () => {
  const widths = [54, 42, 33];
  const placed = besideMarks(lips, widths, box);
  const rings = lips.map(({ x, y }) => ({
    left: x - markRadius,
    top: y - markRadius,
    width: 2 * markRadius,
    height: 2 * markRadius,
  }));
  placed.forEach((place, k) => {
    assert.equal(place.width, widths[k]);
    assert.ok(place.left >= 0 && place.top >= 0 && place.left + place.width <= 300);
    placed.forEach((other, of) => assert.ok(of === k || isApart(place, other), `${k} on ${of}`));
    rings.forEach((ring, of) => assert.ok(isApart(place, ring), `${k} on the mark of ${of}`));
  });
});

test("where there is no room for names there is none said, and a mark outside needs none", () => {
  const narrow = { left: 0, top: 0, width: 60, height: 30 };
  const close = [
    { x: 20, y: 15 },
    { x: 35, y: 15 },
  ];
  assert.equal(besideMarks(close, [54, 54], narrow), null);
  assert.ok(besideMarks(close, [7, 7], narrow));
  assert.deepEqual(besideMarks([{ x: -20, y: 15 }], [7], narrow), [null]);
});
