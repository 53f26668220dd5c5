import assert from "node:assert/strict";
import { test } from "node:test";
import {
  exact,
  inRow,
  level,
  number,
  percent,
  plain,
  quantity,
  symbolParts,
  symbolText,
  title,
} from "../../../src/draw/format.ts";
import { random } from "../random.mjs";

test("quantities are written as people write them", () => {
  const cases = [
    [20, "N", "20 N"],
    [1e7, "N/m", "10 MN/m"],
    [0.004, "m", "4 mm"],
    [70, "deg", "70°"],
    [0.6, "1", "0.6"],
    [0.1, "kg", "100 g"],
    [0, "N", "0 N"],
    [-0.1, "m/s", "-100 mm/s"],
    [999.96, "N", "1 kN"],
    [1e-6, "s", "1 µs"],
    [5.6e-16, "J", "5.6e-16 J"],
    [428.532, "Hz", "428.5 Hz"],
    [-10, "degC", "-10 °C"],
    [null, "N", "–"],
    [undefined, "N", "–"],
    [NaN, "N", "–"],
    [166.2, "dB", "166.2 dB"],
  ];
  for (const [value, unit, text] of cases) assert.equal(quantity(value, unit), text);
});

test("a number without a unit is read at once, all else is the program's to read", () => {
  for (const [text, value] of [
    ["20", 20],
    ["1e-3", 0.001],
    [" .5 ", 0.5],
    ["-1.", -1],
    ["+2E3", 2000],
  ])
    assert.equal(number(text), value, text);
  for (const text of ["", " ", "abc", "4 mm", "70°", "12,5", "10 %", "0x10", "1e", "--1", "1 2", "Infinity", "NaN"])
    assert.equal(number(text), null, text);
});

test("a velocity level is written as the program prints it, its reference as people say it", () => {
  assert.equal(level(169.4963), "169.5 dB");
  assert.equal(level(null), "–");
  assert.equal(quantity(166.2, "dB re 1e-9 m/s"), "166.2 dB re 1 nm/s");
});

test("the server gets the very number", () => {
  const next = random(5);
  for (let round = 0; round < 1000; ++round) {
    const value = (next() - 0.5) * 10 ** (next() * 40 - 20);
    assert.equal(Number(exact(value)), value);
  }
});

test("symbols have their letters and what stands below", () => {
  assert.deepEqual(symbolParts("mu_d"), ["μ", "d"]);
  assert.deepEqual(symbolParts("k1i"), ["k", "1i"]);
  assert.deepEqual(symbolParts("A_exc"), ["A", "exc"]);
  assert.deepEqual(symbolParts("alpha"), ["α", ""]);
  assert.deepEqual(symbolParts("theta"), ["θ", ""]);
  assert.deepEqual(symbolParts("F"), ["F", ""]);
  assert.equal(symbolText("m1"), "m₁");
});

test("names alone would be ambiguous where two parts have them", () => {
  assert.equal(title("joint.mass"), "joint mass");
  assert.equal(title("plate.stiffness"), "plate stiffness");
  assert.equal(title("contact.preload"), "preload");
  assert.equal(title("temperature.value"), "temperature");
  assert.equal(title("joint.lip2.contact.preload"), "lip2: preload");
  assert.equal(title("joint.lip2.mass"), "lip2: mass");
});

test("numbers keep few digits and never lie about nothing", () => {
  assert.equal(plain(0.1 + 0.2), "0.3");
  assert.equal(plain(123456), "123500");
  assert.equal(plain(1.5e-7, 2), "1.5e-7");
  assert.equal(percent(0.6786), "67.9 %");
  assert.equal(percent(null), "–");
});

test("a row of values wraps between them alone", () => {
  assert.equal(inRow(["t = 5 ms", "N = 20 N"]), "t\u00a0=\u00a05\u00a0ms · N\u00a0=\u00a020\u00a0N");
});
