import assert from "node:assert/strict";
import { test } from "node:test";
import { motionOf } from "../../../src/data/frames.ts";
import { columnOf, laneSpecs, lanesOf } from "../../../src/draw/lane_specs.ts";
import { bandsHeight, contactAt, sharesOf } from "../../../src/draw/bands.ts";
import { leastHeight, mostLanes, paintLanes, Pyramids } from "../../../src/draw/lanes.ts";

const perContact = ["normal_force", "friction_force", "gap"];

/** As the program names them: the first joint's are those of a motion of one. */
function placesOf(joints) {
  return joints.map((name, k) => (k === 0 ? ["x1", "y1"] : [`x_${name}`, `y_${name}`]));
}

/** The answer of /api/motion to a run of one second in which each contact sticks, then slips. */
function answer(names) {
  const joints = names.length > 1 ? names : [];
  const columns = joints.length
    ? ["surface_velocity", "y2", ...placesOf(joints).flatMap(([x, y]) => [x, y, `${x}_velocity`])]
    : ["surface_velocity", "x1", "y1", "y2", "x1_velocity"];
  names.forEach((_, k) => columns.push(...perContact.map((name) => (joints.length ? `${name}_${k + 1}` : name))));
  const header = JSON.stringify({
    schema: "stridor.explorer.motion/1",
    samples: 8,
    start: 0,
    interval: 0.125,
    columns: columns.map((name) => ({ name, unit: name.includes("force") ? "N" : "m", sentence: "" })),
    contacts: names.map((name) => ({ name, intervals: 2 })),
    states: ["stick", "slip", "separation"],
  });
  const begin = Math.ceil((4 + header.length) / 8) * 8;
  const each = 3 * 8 + 8; // three instants, two states
  const buffer = new ArrayBuffer(begin + columns.length * 32 + names.length * each);
  new Uint8Array(buffer).fill(32, 4, begin).set(new TextEncoder().encode(header), 4);
  new DataView(buffer).setUint32(0, begin - 4, true);
  columns.forEach((_, k) => new Float32Array(buffer, begin + 32 * k, 8).fill(k));
  names.forEach((_, k) => {
    const at = begin + columns.length * 32 + k * each;
    new Float64Array(buffer, at, 3).set([0, 0.25 * (k + 1), 1]);
    new Uint8Array(buffer, at + 24, 2).set([0, 1]);
  });
  return motionOf(buffer);
}

/** A pen that writes down what it is told, and the surface it draws on. */
function recorder() {
  const [texts, boxes] = [[], []];
  const pen = new Proxy(
    {},
    {
      get: (told, name) => {
        if (name === "measureText") return (text) => ({ width: 6 * text.length });
        if (name === "fillText") return (text, x, y) => texts.push({ text, x, y });
        if (name === "fillRect")
          return (x, y, width, height) => boxes.push({ x, y, width, height, colour: told.fillStyle });
        return name in told ? told[name] : () => undefined;
      },
      set: (told, name, value) => ((told[name] = value), true),
    },
  );
  return { surface: { pen, width: 1000, height: 600, ratio: 1 }, texts, boxes };
}

const palette = {
  muted: "muted",
  grid: "grid",
  line: "line",
  ink: "ink",
  panel: "panel",
  accent: "accent",
  traces: ["a", "b", "c", "d"],
  state: { stick: "stick", slip: "slip", separation: "separation" },
};

function painted(motion, wanted) {
  const paper = recorder();
  paintLanes(paper.surface, new Pyramids(motion), {
    span: [0, 1],
    lanes: lanesOf(motion, new Set(wanted)),
    playhead: 0.5,
    hover: null,
    palette,
  });
  return paper;
}

test("one contact has its lanes without a name", () => {
  const motion = answer(["joint"]);
  const all = new Set(laneSpecs.map(({ name }) => name));
  assert.deepEqual(lanesOf(motion, all), laneSpecs);
  const { texts } = painted(motion, ["velocity", "force"]);
  const written = texts.map(({ text }) => text);
  assert.equal(written.filter((text) => text === "stick").length, 1);
  assert.ok(written.includes("force [N]") && !written.includes("joint"));
});

test("several contacts have a band and lanes each, with the joints' names", () => {
  const motion = answer(["upper", "lower"]);
  const { texts, boxes } = painted(motion, ["force"]);
  const written = texts.map(({ text }) => text);
  assert.equal(written.filter((text) => text === "stick").length, 2);
  for (const text of ["upper", "lower", "upper: force [N]", "lower: force [N]"])
    assert.ok(written.includes(text), text);
  // the stick of a band ends where its contact's does: at a quarter, at a half of the width
  const inner = 1000 - 62 - 10;
  const sticks = boxes.filter(({ colour }) => colour === "stick").map(({ width }) => Math.round((8 * width) / inner));
  assert.deepEqual(sticks, [2, 4]);
  // each band lies below the one before, and the lanes below them all
  const tops = ["upper", "lower", "upper: force [N]", "lower: force [N]"].map(
    (name) => texts.find(({ text }) => text === name).y,
  );
  assert.deepEqual(
    tops,
    [...tops].sort((a, b) => a - b),
  );
});

test("every curve of every lane is a column of the answer", () => {
  for (const names of [["joint"], ["upper", "lower"], ["a", "b", "c"]]) {
    const motion = answer(names);
    const lanes = lanesOf(motion, new Set(laneSpecs.map(({ name }) => name)));
    assert.equal(lanes.length, laneSpecs.length * names.length);
    for (const { title, curves } of lanes)
      for (const { column } of curves) assert.ok(motion.columns.has(column), `${title}: ${column}`);
  }
});

test("each of several contacts has its own columns, the first those of a motion of one", () => {
  const motion = answer(["upper", "lower"]);
  for (const [contact, x] of ["x1", "x_lower"].entries()) {
    assert.equal(columnOf(motion, "x1", contact), x);
    assert.equal(columnOf(motion, "x1_velocity", contact), `${x}_velocity`);
    assert.equal(columnOf(motion, "gap", contact), `gap_${contact + 1}`);
    for (const column of ["x1", "y1", "y2", "x1_velocity", "surface_velocity", "normal_force"])
      assert.ok(motion.columns.has(columnOf(motion, column, contact)), `${column} of ${contact}`);
    for (const lane of lanesOf(motion, new Set(laneSpecs.map(({ name }) => name))))
      for (const { column } of lane.curves) assert.ok(motion.columns.has(column), column);
  }
  assert.equal(columnOf(answer(["joint"]), "x1", 0), "x1");
});

/** A motion of a structure of one's own, as far as lanes look at it. */
function ofStructure(count, outputs = []) {
  const names = Array.from({ length: count }, (_, k) => `n${k + 1}`);
  const ending = (name, k) => (count > 1 ? `_${name}` : String(k + 1));
  const columns = names.flatMap((name, k) => ["x", "y"].map((axis) => axis + ending(name, k)));
  const values = { unit: "m", sentence: "", values: new Float32Array(2) };
  return {
    samples: 2,
    start: 0,
    interval: 1,
    columns: new Map(
      [...columns, ...columns.map((name) => `${name}_velocity`), ...outputs].map((name) => [name, values]),
    ),
    contacts: names.map((name) => ({ name, from: new Float64Array([0, 1]), state: ["stick"] })),
    outline: [],
  };
}

test("of many contacts the chosen one has lanes, and each a row of states", () => {
  const motion = ofStructure(12);
  const lanes = lanesOf(motion, new Set(["velocity"]), 7);
  assert.deepEqual(
    lanes.map(({ title }) => title),
    ["n8: velocity"],
  );
  assert.equal(lanes[0].curves[1].column, "x_n8_velocity");
  const height = 400;
  const rows = bandsHeight(motion, height);
  assert.ok(rows < 0.6 * height);
  const met = new Set();
  for (let y = 0; y < height; ++y) met.add(contactAt(motion, height, y));
  assert.equal(met.size, 13); // each of them, and none
  assert.equal(contactAt(motion, height, rows + 10), null);
  assert.ok(bandsHeight(ofStructure(300), height) < 0.6 * height);
  assert.equal(contactAt(ofStructure(1), height, 10), null);
});

test("a structure has a surface and contacts, no plate and joint, and its outputs below", () => {
  const lanes = lanesOf(ofStructure(1, ["velocity_ear"]), new Set(["velocity", "displacement"]));
  assert.deepEqual(
    lanes.map(({ curves }) => curves.map(({ label }) => label)),
    [["surface V", "contact ẋ"], ["x", "y"], ["ear"]],
  );
});

test("the shares of a row's parts add up to the time that was seen", () => {
  const stays = { name: "", from: new Float64Array([0, 0.25, 0.5, 2]), state: ["stick", "slip", "separation"] };
  const [separation, stick, slip] = sharesOf(stays, [0, 1], 10);
  for (let k = 0; k < 10; ++k) assert.ok(Math.abs(separation[k] + stick[k] + slip[k] - 1) < 1e-6);
  assert.ok(Math.abs(stick[2] - 0.5) < 1e-6 && Math.abs(slip[2] - 0.5) < 1e-6 && separation[9] === 1);
});

test("where there is no room for the lanes of all contacts those of the chosen one are shown", () => {
  const motion = answer(["upper", "middle", "lower"]);
  const titles = (height, chosen) =>
    lanesOf(motion, new Set(["velocity", "force"]), chosen, mostLanes(motion, height)).map(({ title }) => title);
  assert.equal(titles(560, 0).length, 6);
  assert.deepEqual(titles(260, 1), ["middle: velocity", "middle: force"]);
});

test("a canvas of the least height has room for its lanes", () => {
  for (const count of [1, 2, 3, 4, 12, 300])
    for (const lanes of [1, 2, 4]) {
      const motion = ofStructure(count);
      assert.equal(mostLanes(motion, leastHeight(motion, lanes)), lanes, `${count} contacts, ${lanes} lanes`);
    }
});
