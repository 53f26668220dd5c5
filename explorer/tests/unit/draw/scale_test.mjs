import assert from "node:assert/strict";
import { test } from "node:test";
import { at, holds, moved, nearest, rows, share, stretched, ticks, widened, zoomed } from "../../../src/draw/scale.ts";
import { cellAt, place, shareAt } from "../../../src/draw/map.ts";
import { random } from "../random.mjs";

const axis = { parameter: "contact.preload", from: 2, to: 4000, points: 64, scale: "log", unit: "N" };

test("a value and its place on an axis belong to each other", () => {
  for (const scale of ["linear", "log"])
    for (const value of [2, 3.7, 150, 4000])
      assert.ok(Math.abs(at(share(value, 2, 4000, scale), 2, 4000, scale) - value) < 1e-9 * value);
});

test("ticks are round, ascending and within the ends", () => {
  const next = random(6);
  for (let round = 0; round < 2000; ++round) {
    const scale = round % 2 ? "log" : "linear";
    const from = scale === "log" ? 10 ** (next() * 8 - 4) : next() * 100 - 50;
    const to = scale === "log" ? from * 10 ** (next() * 5 + 0.01) : from + 10 ** (next() * 6 - 3);
    const found = ticks(from, to, scale, 6);
    assert.ok(found.length <= 26, `${found.length} ticks`);
    found.forEach((value, k) => {
      assert.ok(value >= from - 1e-6 * (to - from) && value <= to + 1e-6 * (to - from));
      if (k > 0) assert.ok(value > found[k - 1]);
    });
  }
  assert.deepEqual(ticks(2, 4000, "log"), [10, 100, 1000]);
  assert.deepEqual(ticks(0, 0.8, "linear", 4), [0, 0.2, 0.4, 0.6, 0.8]);
  assert.deepEqual(ticks(1, 1, "linear"), []);
});

test("a zoom lies within its axis and holds what was marked", () => {
  const next = random(7);
  for (let round = 0; round < 2000; ++round) {
    const [a, b] = [next() * 1.2 - 0.1, next() * 1.2 - 0.1];
    const zoom = zoomed(axis, a, b);
    assert.ok(zoom.from >= axis.from && zoom.to <= axis.to && zoom.from < zoom.to);
  }
  assert.deepEqual(zoomed(axis, 1, 0), axis);
});

test("zooming again and again ends, and never in an empty axis", () => {
  let zoom = { ...axis, scale: "linear" };
  for (let k = 0; k < 60; ++k) zoom = zoomed(zoom, 0.4, 0.6);
  assert.ok(zoom.from < zoom.to);
});

test("a span of time stays within its limits and keeps its width when moved", () => {
  assert.deepEqual(moved([0.2, 0.4], 5, [0, 1]), [0.8, 1]);
  assert.deepEqual(moved([0.2, 0.4], -5, [0, 1]), [0, 0.2]);
  const [from, to] = stretched([0.2, 0.4], 0.3, 0.5, [0, 1]);
  assert.ok(Math.abs(from - 0.25) < 1e-12 && Math.abs(to - 0.35) < 1e-12);
  assert.deepEqual(stretched([0, 1], 0.5, 10, [0, 1]), [0, 1]);
});

test("the nearest grid value is nearest as the axis measures", () => {
  assert.equal(nearest([1, 10, 100], 31, "log"), 1);
  assert.equal(nearest([1, 10, 100], 60, "linear"), 2);
});

test("the middle of a cell is its value, and a click on it finds it", () => {
  const values = Array.from({ length: 64 }, (_, k) => at(k / 63, axis.from, axis.to, axis.scale));
  const data = { x: { ...axis, values }, y: { ...axis, values } };
  const box = { left: 50, top: 20, width: 400, height: 300 };
  values.forEach((value, k) => {
    const part = place(value, axis);
    assert.ok(Math.abs(part - (k + 0.5) / 64) < 1e-12);
    assert.ok(Math.abs(shareAt(part, 64) - k / 63) < 1e-12);
    assert.deepEqual(cellAt(box, data, box.left + part * box.width, box.top + (1 - part) * box.height), {
      ix: k,
      iy: k,
    });
  });
  assert.equal(cellAt(box, data, 10, 100), null);
});

test("an axis is widened until it holds the design, and no further than its quantity goes", () => {
  const next = random(9);
  for (let round = 0; round < 2000; ++round) {
    const scale = round % 2 ? "log" : "linear";
    const from = scale === "log" ? 10 ** (next() * 4 - 2) : next() * 10;
    const before = { ...axis, scale, from, to: from * (1.1 + 10 * next()) };
    const value = 10 ** (next() * 8 - 4);
    const limits = { low: 0, high: next() < 0.5 ? null : 10 ** 4 };
    const after = widened(before, value, limits);
    assert.ok(holds(after, value), `${value} in ${JSON.stringify(after)}`);
    assert.ok(after.from <= before.from && after.to >= before.to && after.from >= 0);
    if (holds(before, value)) assert.deepEqual(after, before);
  }
});

test("an axis widened to zero is linear, one to a limit ends there", () => {
  assert.deepEqual(widened({ ...axis, from: 500 }, 0, { low: 0, high: null }), { ...axis, scale: "linear", from: 0 });
  assert.deepEqual(widened({ ...axis, from: 2, to: 89, scale: "linear" }, 99, { low: 0, high: 100 }).to, 100);
});

test("labels that would lie on each other stand in rows", () => {
  const rowOf = rows();
  const labels = [
    [0, 30],
    [20, 30],
    [31, 10],
    [45, 10],
    [46, 5],
  ];
  assert.deepEqual(
    labels.map(([left, width]) => rowOf(left, width)),
    [0, 1, 0, 0, 2],
  );
});
