import assert from "node:assert/strict";
import { test } from "node:test";
import { exact, percent, plain, quantity, read, symbolParts, symbolText, title } from "../../src/format.ts";
import { random } from "./random.mjs";

test("quantities are written as people write them", () => {
  const cases = [
    [20, "N", "20 N"], [1e7, "N/m", "10 MN/m"], [0.004, "m", "4 mm"], [70, "deg", "70°"], [0.6, "1", "0.6"], [0.1, "kg", "100 g"],
    [0, "N", "0 N"], [-0.1, "m/s", "-100 mm/s"], [999.96, "N", "1 kN"], [1e-6, "s", "1 µs"], [5.6e-16, "J", "5.6e-16 J"], [428.532, "Hz", "428.5 Hz"],
    [null, "N", "–"], [undefined, "N", "–"], [NaN, "N", "–"], [166.2, "dB", "166.2 dB"],
  ];
  for (const [value, unit, text] of cases) assert.equal(quantity(value, unit), text);
});

test("what is written can be read back", () => {
  const next = random(4);
  for (const unit of ["N", "N/m", "m", "m/s", "kg", "Hz", "s", "deg", "1", "N*s/m"])
    for (let round = 0; round < 200; ++round) {
      const value = Number((10 ** (next() * 12 - 5)).toPrecision(4)) * (next() < 0.5 ? -1 : 1);
      const text = quantity(value, unit);
      const back = read(text, unit);
      assert.ok(back !== null && Math.abs(back - value) <= 5.1e-4 * Math.abs(value), `${value} ${unit}: ${text} gave ${back}`);
    }
});

test("round numbers with a prefix are read exactly", () => {
  for (const [text, unit, value] of [["4 mm", "m", 0.004], ["10MN/m", "N/m", 1e7], ["0.3 g", "kg", 0.0003], ["1e-3", "m", 0.001], ["70°", "deg", 70], ["12,5 N", "N", 12.5], ["10 %", "1", 0.1], [" .5 ", "1", 0.5]])
    assert.equal(read(text, unit), value, text);
});

test("what is no such quantity is refused", () => {
  for (const [text, unit] of [["", "N"], ["abc", "N"], ["4 mm", "N"], ["1 2", "N"], ["1e", "N"], ["--1", "N"], ["5 xN", "N"], ["Infinity", "N"], ["5 %", "N"], ["3 m", "1"]])
    assert.equal(read(text, unit), null, text);
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
  assert.deepEqual(symbolParts("F"), ["F", ""]);
  assert.equal(symbolText("m1"), "m₁");
});

test("names alone would be ambiguous where two parts have them", () => {
  assert.equal(title("joint.mass"), "joint mass");
  assert.equal(title("plate.stiffness"), "plate stiffness");
  assert.equal(title("contact.preload"), "preload");
});

test("numbers keep few digits and never lie about nothing", () => {
  assert.equal(plain(0.1 + 0.2), "0.3");
  assert.equal(plain(123456), "123500");
  assert.equal(plain(1.5e-7, 2), "1.5e-7");
  assert.equal(percent(0.6786), "67.9 %");
  assert.equal(percent(null), "–");
});
