import assert from "node:assert/strict";
import { test } from "node:test";
import { fromFragment, toFragment } from "../../../src/state/state.ts";
import { beginAt, pointOf, withStart } from "../../../src/views/own_start.ts";

const box = { left: 54, top: 8, width: 400, height: 300 };
const portrait = [box, -1e-3, 1e-3, -0.5, 0.5];
const near = (a, b, most) => assert.ok(Math.abs(a - b) <= most, `${a} is not ${b}`);

test("a point of a portrait is a place and a velocity: right is ahead, up is faster", () => {
  const middle = pointOf(portrait, 254, 158);
  near(middle.x, 0, 1e-18);
  near(middle.v, 0, 1e-15);
  const corner = pointOf(portrait, 454, 8);
  near(corner.x, 1e-3, 1e-18);
  near(corner.v, 0.5, 1e-15);
});

test("beside its frame there is no point", () => {
  for (const [x, y] of [
    [53, 100],
    [455, 100],
    [100, 7],
    [100, 309],
  ])
    assert.equal(pointOf(portrait, x, y), null);
});

test("a start of one's own takes the place of the one before, and comes back from a fragment", () => {
  const before = {
    preset: "squeal",
    set: { "contact.preload": "30", "joint.initial_normal": "1e-5", "contact.initial_state": "stick" },
  };
  const design = withStart(before, "", 1.23456789e-6, -0.04);
  assert.deepEqual(design.set, {
    "contact.preload": "30",
    "run.initial": "given",
    "joint.initial_tangential": "0.00000123457",
    "joint.initial_tangential_velocity": "-0.04",
  });
  const axis = { parameter: "contact.preload", from: 2, to: 4000, points: 64, scale: "log" };
  const state = {
    ...{ design, x: axis, y: { ...axis, parameter: "contact.kinetic_friction" }, figure: "category" },
    ...{ direction: "going", view: "response", span: null, other: null, theme: "auto" },
  };
  const empty = { ...state, design: { preset: "squeal", set: {} } };
  assert.deepEqual(fromFragment(`#${toFragment(state)}`, empty).design, design);
});

test("a start of one of several joints is that joint's alone", () => {
  const first = withStart({ preset: "two-lips", set: {} }, "upper", 2e-6, 0.1);
  assert.equal(first.set["joint.upper.initial_tangential"], "0.000002");
  const second = withStart(first, "lower", 3e-6, 0.2);
  assert.deepEqual(Object.keys(second.set), [
    "run.initial",
    "joint.lower.initial_tangential",
    "joint.lower.initial_tangential_velocity",
  ]);
});

const storeOf = (design) => ({ state: { design }, update: (change) => (storeOf.changed = change) });
const stays = (name) => ({ name, from: new Float64Array([0, 1]), state: ["slip"] });
const click = { offsetX: 454, offsetY: 158 };

test("a click begins the motion of the joint that is shown", () => {
  const columns = new Map([["y_plate", {}]]);
  const motion = { columns, contacts: [stays("upper"), stays("lower")] };
  beginAt(storeOf({ preset: "two-lips", set: {} }), click, portrait, motion, 1);
  assert.equal(storeOf.changed.design.set["joint.lower.initial_tangential"], "0.001");
});

test("a click on the portrait of a structure of one's own changes nothing", () => {
  storeOf.changed = null;
  const motion = { columns: new Map(), contacts: [stays("bow")] };
  beginAt(storeOf({ preset: "bow", set: {} }), click, portrait, motion, 0);
  assert.equal(storeOf.changed, null);
});
