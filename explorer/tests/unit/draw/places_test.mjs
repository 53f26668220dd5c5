import assert from "node:assert/strict";
import { test } from "node:test";
import { lastPlace, Places, roomy } from "../../../src/draw/places.ts";

const soft = { from: 0.0004, to: 0.04, scale: "log" }; // around a lip of 4 g
const random = (() => {
  let state = 7;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
})();

/** A slider as the page moves it: the hand is at a place, the value is set and shown. */
function moved(places, place, own, range) {
  places.place = place;
  const value = places.at(place);
  assert.equal(places.show(value, own, range), place);
  return value;
}

test("a hand that goes away and comes back finds the value, to the last digit", () => {
  for (const own of [0.004, 0.00412345678901, 0.0004, 0.04]) {
    const places = new Places(soft);
    const start = places.show(own, own, soft);
    for (let k = 0; k < 100; ++k) moved(places, Math.floor(random() * (lastPlace + 1)), own, soft);
    assert.equal(moved(places, start, own, soft), own);
  }
});

test("so does a value that was typed, and the case's own beside it", () => {
  const places = new Places(soft);
  const own = places.show(0.004, 0.004, soft);
  const typed = places.show(0.0123456789, 0.004, soft);
  moved(places, 3, 0.004, soft);
  assert.equal(moved(places, typed, 0.004, soft), 0.0123456789);
  assert.equal(moved(places, own, 0.004, soft), 0.004);
});

test("places next to each other differ, and by little", () => {
  const places = new Places(soft);
  places.show(0.004, 0.004, soft);
  for (let k = 1; k <= lastPlace; ++k) {
    const ratio = places.at(k) / places.at(k - 1);
    assert.ok(ratio > 1 && ratio < 1.006, `${k}: ${ratio}`);
  }
});

test("what was typed beyond the ends stretches them, and nothing jumps", () => {
  const places = new Places(soft);
  places.show(0.004, 0.004, soft);
  assert.equal(places.show(7, 0.004, soft), lastPlace);
  assert.equal(places.at(lastPlace), 7);
  assert.ok(moved(places, lastPlace - 1, 0.004, soft) > 6.9);
  assert.equal(moved(places, lastPlace, 0.004, soft), 7);
});

test("another case has its own ends", () => {
  const places = new Places(soft);
  places.show(0.004, 0.004, soft);
  const hard = { from: 0.01, to: 1, scale: "log" };
  assert.equal(places.show(0.1, 0.1, hard), lastPlace / 2);
  assert.equal(places.at(0), 0.01);
});

test("the sign stays as it is, and zero is found again on a log scale", () => {
  const speeds = { from: 0.005, to: 0.5, scale: "log" };
  const places = new Places(speeds);
  assert.equal(places.show(-0.05, -0.05, speeds), lastPlace / 2);
  assert.equal(places.at(lastPlace), -0.5);
  assert.equal(moved(places, lastPlace / 2, -0.05, speeds), -0.05);
  const dampings = new Places({ from: 0.1, to: 300, scale: "log" });
  assert.equal(dampings.show(0, 0, null), 0);
  moved(dampings, 500, 0, null);
  assert.equal(moved(dampings, 0, 0, null), 0);
});

test("fifty steps up and fifty down from a value at the end of its range are the value", () => {
  const usual = { from: 0, to: 1.2, scale: "linear" };
  const range = roomy(usual, 1.2, null);
  assert.ok(range.to >= 1.5 * 1.2);
  assert.deepEqual(roomy(usual, 0.3, null), usual, "there is room");
  assert.equal(roomy({ ...usual, to: 1 }, 0.9, 1).to, 1, "it cannot be larger");
  const places = new Places(usual);
  places.show(1.2, 1.2, range);
  for (const step of [1, -1])
    for (let k = 0; k < 50; ++k) moved(places, Math.min(Math.max(places.place + step, 0), lastPlace), 1.2, range);
  assert.equal(places.at(places.place), 1.2);
});
