import assert from "node:assert/strict";
import { test } from "node:test";
import {
  contrast,
  dark,
  fillOf,
  light,
  lightness,
  paleOf,
  sequential,
  silenceOf,
  textOn,
  wordOf,
} from "../../../src/draw/colours.ts";

for (const palette of [light, dark]) {
  test(`${palette.name}: text reads on its grounds (WCAG AA)`, () => {
    for (const ground of [palette.page, palette.panel, palette.field]) {
      assert.ok(contrast(palette.ink, ground) >= 7);
      assert.ok(contrast(palette.muted, ground) >= 4.5);
      assert.ok(contrast(palette.accent, ground) >= 4.5);
      assert.ok(contrast(palette.warn, ground) >= 4.5);
    }
    assert.ok(contrast(palette.onAccent, palette.accent) >= 4.5);
  });

  test(`${palette.name}: curves and states stand out of the panel`, () => {
    for (const colour of palette.traces) assert.ok(contrast(colour, palette.panel) >= 3, colour);
    for (const colour of Object.values(palette.state)) assert.ok(contrast(colour, palette.panel) >= 1.7, colour);
  });

  test(`${palette.name}: categories differ in lightness, so in grey as well`, () => {
    const shades = ["none", "squeak", "squeal", "creak"]
      .map((name) => lightness(fillOf(palette, name).ground))
      .sort((a, b) => a - b);
    for (let k = 1; k < shades.length; ++k) assert.ok(shades[k] - shades[k - 1] >= 12, shades.join(" "));
  });

  test(`${palette.name}: what is not computed is paler than any category, and never looks quiet`, () => {
    const panel = lightness(palette.panel);
    const quiet = Math.abs(lightness(fillOf(palette, "none").ground) - panel);
    for (const name of ["none", "none (sticks)", "squeak", "squeal", "creak"]) {
      const pale = Math.abs(lightness(paleOf(palette, name).ground) - panel);
      assert.ok(pale < 0.5 * Math.abs(lightness(fillOf(palette, name).ground) - panel), `${name} ${pale}`);
      assert.equal(paleOf(palette, name).texture, "plain");
    }
    assert.ok(Math.abs(lightness(paleOf(palette, "none").ground) - panel) < quiet - 4);
  });

  test(`${palette.name}: each noise has a texture of its own`, () => {
    const textures = ["none", "squeak", "squeal", "creak"].map((name) => fillOf(palette, name).texture);
    assert.equal(new Set(textures).size, 4);
  });
}

test("the light palette is that of the figures", () => {
  const grounds = ["none", "squeak", "squeal", "creak"].map((name) => fillOf(light, name).ground);
  assert.deepEqual(grounds, ["#E6E6E6", "#DDAA33", "#BB5566", "#004488"]);
});

test("the scale of figures grows in lightness", () => {
  const hex = (rgb) => "#" + rgb.map((value) => value.toString(16).padStart(2, "0")).join("");
  let last = -1;
  for (let k = 0; k <= 20; ++k) {
    const shade = lightness(hex(sequential(k / 20)));
    assert.ok(shade > last);
    last = shade;
  }
  assert.deepEqual(sequential(-1), sequential(0));
  assert.deepEqual(sequential(2), sequential(1));
});

test("text on a ground is whichever reads better", () => {
  assert.equal(textOn("#DDAA33"), "#1B1F24");
  assert.equal(textOn("#004488"), "#FFFFFF");
});

test("an unknown category is drawn as no result, never as quiet", () => {
  for (const name of [undefined, null, "what"]) assert.equal(fillOf(light, name).texture, "crossed");
});

test("a verdict says once that it locks, and why it is quiet beside none", () => {
  const said = (quiet_because) => {
    const verdict = { category: "none", quiet_because };
    return [wordOf(verdict), silenceOf(verdict)].filter(Boolean).join(" ");
  };
  assert.equal(said("locks"), "locks");
  assert.equal(said("sticks"), "none sticks");
});
