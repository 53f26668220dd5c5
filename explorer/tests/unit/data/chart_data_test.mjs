import assert from "node:assert/strict";
import { test } from "node:test";
import { computedIn, isAwaited, merged, wordAt } from "../../../src/data/chart_data.ts";
import { table } from "../../../src/views/share.ts";

const coded = (numbers) => Buffer.from(numbers).toString("base64");
const axis = (parameter) => ({ parameter, from: 1, to: 2, points: 2, scale: "linear", unit: "N", values: [1, 2] });

/** A chart of two by two cells, of which the first is computed and quiet; the others take after it. */
const frame = (done) => ({
  ...{ x: axis("contact.preload"), y: axis("joint.mass"), directions: ["going"], done },
  category: coded([0, 0, 0, 0]),
  computed_mask: coded([1, 0, 0, 0]),
});

test("cells are awaited until the chart is finished", () => {
  const awaited = (data) => [0, 1, 2, 3].map((index) => isAwaited(data, index));
  assert.deepEqual(awaited(merged(null, frame(false), false)), [false, true, true, true]);
  assert.deepEqual(awaited(merged(null, frame(true), false)), [false, false, false, false], "inferred");
});

test("a cell is called what its picture shows, and nothing as long as it is not computed", () => {
  const codes = { ...frame(true), category: coded([6, 1, 5, 255]), computed_mask: coded([1, 0, 1, 0]) };
  const said = (done) => [0, 1, 2, 3].map((index) => wordAt(merged(null, { ...codes, done }, false), index));
  assert.deepEqual(said(true), ["locks", "squeal", "none (sticks)", "no result"]);
  assert.deepEqual(said(false), ["locks", "not computed yet", "none (sticks)", "not computed yet"]);
});

test("of each direction it is known how many cells were computed, also where there are none yet", () => {
  const both = {
    ...frame(false),
    directions: ["going", "coming"],
    category: coded([0, 0, 0, 0, 255, 255, 255, 255]),
    computed_mask: coded([1, 0, 1, 0, 0, 0, 0, 0]),
  };
  const data = merged(null, both, false);
  assert.deepEqual([computedIn(data, "going"), computedIn(data, "coming")], [2, 0]);
  assert.ok(isAwaited(data, 7));
  assert.equal(merged(data, { ...both, gaps: "mu_d exceeds mu_s" }, false).gaps, "mu_d exceeds mu_s");
});

test("the table of an unfinished chart calls no cell quiet that was not computed", () => {
  const rows = (done) =>
    table(merged(null, frame(done), false), "category", ["a"])
      .trim()
      .split("\n")
      .slice(2);
  assert.deepEqual(rows(false), [
    "1,1,going,none,slides,computed",
    ...["2,1", "1,2", "2,2"].map((at) => `${at},going,,,not_computed`),
  ]);
  assert.equal(rows(true)[3], "2,2,going,none,slides,inferred");
});
