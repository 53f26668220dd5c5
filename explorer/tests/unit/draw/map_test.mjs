import assert from "node:assert/strict";
import { test } from "node:test";
import { paintBoundaries } from "../../../src/draw/map.ts";
import { chartKinds } from "../../../src/program/words.ts";

// the lines drawn, each from its begin to its end, on a box of one unit to a cell
function linesOf(kinds, direction) {
  const lines = [];
  const pen = { save() {}, restore() {}, beginPath() {}, stroke() {} };
  pen.moveTo = (x, y) => lines.push([x, y]);
  pen.lineTo = (x, y) => lines.at(-1).push(x, y);
  const [nx, ny] = [kinds[0][0].length, kinds[0].length];
  const category = Uint8Array.from(
    kinds.flatMap((rows) => [...rows].reverse().flat()).map((k) => chartKinds.indexOf(k)),
  );
  const data = { x: { points: nx }, y: { points: ny }, directions: ["going", "coming"], category, figure: null };
  const box = { left: 0, top: 0, width: nx, height: ny };
  paintBoundaries({ pen, ratio: 1 }, box, data, direction, { palette: { ink: "black" } });
  return lines.sort();
}

test("boundaries lie on the edges of cells whose verdicts differ, in their own direction", () => {
  const going = [
    ["none", "squeal"],
    ["none", "none"],
  ];
  const coming = [
    ["creak", "creak"],
    ["squeak", "squeak"],
  ];
  assert.deepEqual(linesOf([going, coming], "going"), [
    [1, 1, 1, 0],
    [1, 1, 2, 1],
  ]);
  assert.deepEqual(linesOf([going, coming], "coming"), [
    [0, 1, 1, 1],
    [1, 1, 2, 1],
  ]);
});

test("no boundary lies between what slides and what sticks", () => {
  const going = [["none", "none (sticks)", "locks"]];
  assert.deepEqual(linesOf([going, going], "going"), [[2, 1, 2, 0]]);
});
