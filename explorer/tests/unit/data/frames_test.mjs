import assert from "node:assert/strict";
import { test } from "node:test";
import {
  bytesOf,
  floatsOf,
  lastAtMost,
  Lines,
  motionOf,
  shownContact,
  stateAt,
  valueAt,
} from "../../../src/data/frames.ts";
import { random } from "../random.mjs";

/** A motion as /api/motion sends it. */
export function packed(header, columns, from, states) {
  const text = new TextEncoder().encode(JSON.stringify(header));
  const aligned = (offset) => Math.ceil(offset / 8) * 8;
  const begin = aligned(4 + text.length);
  const size =
    columns.reduce((offset, column) => aligned(offset + 4 * column.length), begin) + 8 * from.length + states.length;
  const buffer = new ArrayBuffer(size);
  const bytes = new Uint8Array(buffer);
  bytes.fill(32, 4, begin);
  new DataView(buffer).setUint32(0, begin - 4, true);
  bytes.set(text, 4);
  let offset = begin;
  for (const column of columns) {
    new Float32Array(buffer, offset, column.length).set(column);
    offset = aligned(offset + 4 * column.length);
  }
  new Float64Array(buffer, offset, from.length).set(from);
  bytes.set(states, offset + 8 * from.length);
  return buffer;
}

const header = (samples, intervals) => ({
  schema: "stridor.explorer.motion/1",
  samples,
  start: 0.5,
  interval: 0.25,
  columns: [
    { name: "x1", unit: "m", sentence: "" },
    { name: "gap", unit: "m", sentence: "" },
  ],
  contacts: [{ name: "joint", intervals }],
  states: ["stick", "slip", "separation"],
});

test("a motion is read as it was packed, odd lengths too", () => {
  for (const samples of [1, 2, 3, 8, 9]) {
    const x = Array.from({ length: samples }, (_, k) => k);
    const gap = x.map((value) => -value);
    const motion = motionOf(packed(header(samples, 3), [x, gap], [0.5, 0.75, 1, 1.5], [1, 2, 0]));
    assert.deepEqual([...motion.columns.get("x1").values], x);
    assert.deepEqual(
      [...motion.columns.get("gap").values].map((value) => value + 0),
      gap.map((value) => value + 0),
    );
    assert.deepEqual([...motion.contacts[0].from], [0.5, 0.75, 1, 1.5]);
    assert.deepEqual(motion.contacts[0].state, ["slip", "separation", "stick"]);
  }
});

test("a motion that is cut short is an error, not a picture", () => {
  const whole = packed(
    header(5, 1),
    [
      [1, 2, 3, 4, 5],
      [1, 2, 3, 4, 5],
    ],
    [0.5, 1.5],
    [1],
  );
  assert.throws(() => motionOf(whole.slice(0, whole.byteLength - 12)));
});

test("state and value are those of the time asked for", () => {
  const motion = motionOf(
    packed(
      header(4, 2),
      [
        [0, 1, 4, 9],
        [0, 0, 0, 0],
      ],
      [0.5, 1, 1.25],
      [0, 1],
    ),
  );
  assert.equal(stateAt(shownContact(motion), 0), "stick");
  assert.equal(stateAt(shownContact(motion), 0.99), "stick");
  assert.equal(stateAt(shownContact(motion), 1), "slip");
  assert.equal(stateAt(shownContact(motion), 99), "slip");
  assert.equal(valueAt(motion, "x1", 0), 0);
  assert.equal(valueAt(motion, "x1", 0.875), 2.5);
  assert.equal(valueAt(motion, "x1", 99), 9);
  assert.equal(valueAt(motion, "nothing", 1), 0);
});

test("lines come out whole however they were cut", () => {
  const text = '{"a":1}\n{"b":"ü"}\n\n{"c":3}';
  const next = random(3);
  for (let round = 0; round < 200; ++round) {
    const lines = new Lines();
    const found = [];
    for (let at = 0; at < text.length;) {
      const size = 1 + Math.floor(next() * 7);
      found.push(...lines.add(text.slice(at, at + size)));
      at += size;
    }
    found.push(...lines.end());
    assert.deepEqual(found, ['{"a":1}', '{"b":"ü"}', '{"c":3}']);
  }
});

test("base64 gives back bytes and floats", () => {
  assert.deepEqual([...bytesOf(Buffer.from([0, 1, 255]).toString("base64"))], [0, 1, 255]);
  const floats = new Float32Array([1.5, -2, NaN]);
  assert.deepEqual([...floatsOf(Buffer.from(floats.buffer).toString("base64"))], [1.5, -2, NaN]);
});

test("the place in an ascending list is found", () => {
  const values = [1, 2, 2, 5];
  assert.deepEqual(
    [0, 1, 2, 3, 5, 9].map((value) => lastAtMost(values, value)),
    [-1, 0, 2, 2, 3, 3],
  );
  assert.equal(lastAtMost([], 1), -1);
});
