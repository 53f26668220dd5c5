import assert from "node:assert/strict";
import { test } from "node:test";
import { lawAt, placeOf, pointsOf } from "../../../src/draw/law_points.ts";

const law = {
  schema: "stridor.explorer.friction/1",
  friction: "stribeck",
  speeds: [0, 1],
  curves: [{ way: "both directions", limit: 0.8, friction: [0.8, 0.4] }],
  grips: [],
  rows: [],
  visited: null,
};
const grip = { key: "contact.kinetic_friction", speed: 1, friction: 0.4, along: "friction", way: "both directions" };

test("a place on the canvas is a point of the law, and back", () => {
  const frame = { box: { left: 54, top: 8, width: 400, height: 300 }, speed: 0.5, friction: 1 };
  assert.deepEqual(placeOf(frame, { speed: 0.25, friction: 0.5 }), [254, 158]);
  assert.deepEqual(lawAt(frame, 254, 158), [0.25, 0.5]);
});

test("a point sets its quantity within its bounds", () => {
  const [point] = pointsOf({ ...law, grips: [{ ...grip, low: 0.1, high: 0.9, origin: -0.1, rate: 1 }] });
  assert.equal(point.name, "kinetic friction");
  assert.deepEqual(point.at(7, 0.5), { "contact.kinetic_friction": "0.4" });
  assert.deepEqual(point.at(7, 2), { "contact.kinetic_friction": "0.8" });
  assert.deepEqual(point.at(7, -1), { "contact.kinetic_friction": "0" });
});

test("a point that moves along the speed has no end where none is given", () => {
  const [point] = pointsOf({ ...law, grips: [{ ...grip, along: "speed", low: 0.01, high: null, origin: 0, rate: 1 }] });
  assert.deepEqual(point.at(7, 0.5), { "contact.kinetic_friction": "7" });
  assert.deepEqual(point.at(0, 0.5), { "contact.kinetic_friction": "0.01" });
});

test("a row of a table stays between its neighbours, the first one at rest, the last one has none behind it", () => {
  const rows = [
    { speed: 0, friction: 0.8 },
    { speed: 0.01, friction: 0.5 },
    { speed: 0.2, friction: 0.6 },
  ];
  const [first, middle, last] = pointsOf({ ...law, rows });
  const set = (point, speed, friction) => point.at(speed, friction)["contact.friction_table"];
  assert.equal(set(first, 0.005, 0.7), "0: 0.7, 0.01: 0.5, 0.2: 0.6");
  assert.equal(set(middle, 0.02, 0.55), "0: 0.8, 0.02: 0.55, 0.2: 0.6");
  const [, beyond] = set(middle, 0.5, 0.55).split(", ");
  assert.ok(Number(beyond.split(":")[0]) < 0.2, beyond);
  assert.equal(set(last, 0.3, -1), "0: 0.8, 0.01: 0.5, 0.3: 0");
});
