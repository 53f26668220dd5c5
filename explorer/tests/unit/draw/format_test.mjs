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
  setUnits,
  symbolParts,
  symbolText,
  title,
  toldApart,
  withUnit,
  writtenIn,
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

test("stiffness, mass, velocity and length are written as engineers do, where that is chosen", () => {
  const cases = [
    [1500, "N/m", "1.5 N/mm"],
    [1e7, "N/m", "10000 N/mm"],
    [0.0040012345, "kg", "4.001 g"],
    [2.5, "kg", "2.5 kg"],
    [0.12, "m/s", "120 mm/s"],
    [1.2, "m", "1200 mm"],
    [-2e-6, "m", "-0.002 mm"],
    [1, "N*s/m", "1 N·s/m"],
    [20, "N", "20 N"],
    [70, "deg", "70°"],
    [NaN, "N/m", "–"],
  ];
  setUnits("engineering");
  try {
    for (const [value, unit, text] of cases) assert.equal(quantity(value, unit), text);
    assert.deepEqual(writtenIn("kg", 0.4), { factor: 1e3, unit: "g" });
    assert.deepEqual(writtenIn("Hz", 400), { factor: 1, unit: "Hz" });
    // a number alone is in the unit that stands there, and the program reads it
    assert.equal(withUnit("4.0012345", "kg", 0.1), "4.0012345 g");
    assert.equal(withUnit("2.7", "kg", 2.5), "2.7");
    assert.equal(withUnit("5 kg", "kg", 0.1), "5 kg");
    assert.equal(withUnit("35", "N", 20), "35");
  } finally {
    setUnits("si");
  }
  assert.equal(quantity(1500, "N/m"), "1.5 kN/m");
  assert.equal(withUnit("4", "kg", 0.1), "4");
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
  assert.equal(inRow(["t = 5 ms", "N = 20 N"]), "t\u00a0=\u00a05\u00a0ms\u00a0· N\u00a0=\u00a020\u00a0N");
});

test("marks of a small span far from zero have the digits that tell them apart", () => {
  assert.deepEqual(toldApart([0.05001, 0.05002, 0.05003]), ["0.05001", "0.05002", "0.05003"]);
  assert.deepEqual(toldApart([1000000, 1000001]), ["1000000", "1000001"]);
  assert.deepEqual(toldApart([0, 0.2, 0.4]), ["0", "0.2", "0.4"]);
  assert.deepEqual(toldApart([7]), ["7"]);
  assert.deepEqual(toldApart([]), []);
});
