import assert from "node:assert/strict";
import { test } from "node:test";
import { spawnSync } from "node:child_process";
import {
  chartDesign,
  command,
  fromFragment,
  overrides,
  toFragment,
  withoutKeys,
  withValues,
} from "../../../src/state/state.ts";
import { random } from "../random.mjs";

const axis = (parameter, from, to, scale = "linear") => ({ parameter, from, to, points: 64, scale });
const defaults = {
  design: { preset: "squeal", set: {} },
  x: axis("contact.preload", 2, 4000, "log"),
  y: axis("contact.kinetic_friction", 0, 0.8),
  figure: "category",
  direction: "going",
  view: "response",
  span: null,
  other: null,
  theme: "auto",
};

test("a state comes back from its fragment, whatever it holds", () => {
  const next = random(1);
  const pick = (list) => list[Math.floor(next() * list.length)];
  const number = () => pick([0.1 + 0.2, 1e-7, 123456.789, 1e7, -0.1, next() * 1000, next() * 1e-9]);
  for (let round = 0; round < 2000; ++round) {
    const set = Object.fromEntries(
      ["contact.preload", "joint.incidence_angle", "joint.lip-2.contact.preload", "joint.Upper.mass", "drive.kind"]
        .filter(() => next() < 0.5)
        .map((key) => [key, key === "drive.kind" ? "constant" : String(number())]),
    );
    const from = Math.abs(number());
    const state = {
      design: { preset: pick(["squeal", "creak", "file"]), set },
      x: {
        parameter: "contact.preload",
        from,
        to: from * 3 + 1e-3,
        points: pick([2, 16, 64]),
        scale: pick(["linear", "log"]),
      },
      y: axis("joint.incidence_angle", -number() - 1e9, 1e9),
      figure: pick(["category", "frequency", "judged_slip"]),
      direction: pick(["going", "coming"]),
      view: pick(["response", "quiet", "library"]),
      span: next() < 0.5 ? null : [from, from + 1],
      other: pick([null, { library: 7 }, { design: { preset: "creak", set }, direction: "coming" }]),
      theme: pick(["auto", "dark"]),
    };
    assert.deepEqual(fromFragment(toFragment(state), defaults), state);
  }
});

test("an empty or spoilt fragment gives the defaults", () => {
  for (const text of [
    "",
    "#",
    "#x=1:2:3",
    "#x=contact.preload:9:1:64:log",
    "#x=contact.preload:0:1:64:log",
    "#y=contact.preload:1:2:64:linear",
    "#view=nothing&theme=pink",
    "#span=3:1",
    "#other=library:x",
    "#preset",
    "#%E0%A4%A&=&&==",
  ])
    assert.deepEqual(fromFragment(text, defaults), defaults, text);
});

test("a fragment that no page makes so long is left alone", () => {
  assert.deepEqual(fromFragment(`#preset=creak&contact.preload=${"1".repeat(9000)}`, defaults), defaults);
});

test("what a link leaves out is as on a page without a file", () => {
  const own = { ...defaults, figure: "frequency" };
  assert.equal(fromFragment("#preset=squeal", own).figure, "category");
  assert.equal(fromFragment("", own).figure, "frequency");
});

test("axes of absurd size or of equal parameters are refused", () => {
  const same = fromFragment("#x=contact.preload:1:2:64:log&y=contact.preload:1:3:64:log", defaults);
  assert.deepEqual([same.x, same.y], [defaults.x, defaults.y]);
  assert.equal(fromFragment("#x=contact.preload:1:2:100000:log", defaults).x.points, 64);
});

test("the fragment stays readable", () => {
  const state = { ...defaults, design: { preset: "squeal", set: { "contact.preload": "12.5" } } };
  assert.equal(
    toFragment(state),
    "preset=squeal&contact.preload=12.5&x=contact.preload:2:4000:64:log&y=contact.kinetic_friction:0:0.8:64:linear",
  );
});

test("a key that is no key of a field never reaches the design", () => {
  const { design } = fromFragment("#preset=squeal&__proto__=1&contact.preload=3&../x=1", defaults);
  assert.deepEqual(design.set, { "contact.preload": "3" });
});

test("the chart does not depend on the two values that its axes replace", () => {
  const set = { "contact.preload": "1", "contact.kinetic_friction": "0.2", "joint.mass": "2" };
  const state = { ...defaults, design: { preset: "squeal", set } };
  assert.deepEqual(chartDesign(state, () => true).set, { "joint.mass": "2" });
});

test("a key that the preset does not have stays in the chart's design, and does not follow the cell", () => {
  const has = (key) => key !== "contact.stribeck_velocity";
  const y = { ...defaults.y, parameter: "contact.stribeck_velocity", from: 0.005, to: 0.5 };
  for (const cell of ["0.01", "0.2"]) {
    const set = { "contact.friction": "stribeck", "contact.stribeck_velocity": cell, "contact.preload": "3" };
    assert.deepEqual(chartDesign({ ...defaults, y, design: { preset: "squeal", set } }, has).set, {
      "contact.friction": "stribeck",
      "contact.stribeck_velocity": "0.005",
    });
  }
});

test("a design as a command is what a shell takes", () => {
  const design = withValues(
    { preset: "squeal", set: {} },
    { "contact.preload": "1e-7", "contact.impact": "normal-only" },
  );
  assert.equal(
    command(design),
    "stridor init squeal | stridor simulate - --set contact.preload=1e-7 --set contact.impact=normal-only",
  );
  assert.equal(
    command(withValues({ preset: "file", set: {} }, { title: "a 'b'" })),
    "stridor simulate CASE.toml --set 'title=a '\\''b'\\'''",
  );
});

test("changing a design leaves the old one as it was", () => {
  const design = { preset: "squeal", set: { "joint.mass": "1" } };
  assert.deepEqual(overrides(withValues(design, { "joint.mass": "2" })), ["joint.mass=2"]);
  assert.deepEqual(overrides(withoutKeys(design, ["joint.mass"])), []);
  assert.deepEqual(overrides(design), ["joint.mass=1"]);
});

test("a command is one for a shell, whatever a link says", () => {
  const words = (text) =>
    spawnSync("bash", ["-c", `stridor() { printf '%s\\n' "$@" >&2; }; ${text}`], { encoding: "utf8" })
      .stderr.split("\n")
      .slice(0, -1);
  const hostile = [
    "x & touch /tmp/x",
    "$(id)",
    "`id`",
    "a'b",
    'a"b',
    "a b",
    "-x",
    "~",
    "*",
    "\\",
    "&& id",
    "|id",
    "=ls",
    "#x",
    "!x",
  ];
  for (const text of hostile) {
    const design = fromFragment(
      `#preset=${encodeURIComponent(text)}&drive.kind=${encodeURIComponent(text)}`,
      defaults,
    ).design;
    const wanted = ["init", text, "simulate", "-", "--set", `drive.kind=${text}`].sort();
    assert.deepEqual(words(command(design)).sort(), wanted, text);
  }
  for (const text of ["x; touch /tmp/x", "a,=cmd", "a\nid\n", "\r", "\x1b[A", "\x7f", "\x9b1m", "\u202e", "\t"]) {
    assert.throws(() => command({ preset: text, set: {} }), /no command/);
    assert.throws(() => command({ preset: "squeal", set: { "drive.kind": text } }), /no command/);
  }
});

test("a value of all joints takes the place of each one's own, and stands last, as the program reads them", () => {
  const design = { preset: "file", set: {} };
  const own = withValues(design, { "joint.upper.contact.preload": "1", "joint.lip-2.mass": "2", "plate.mass": "3" });
  assert.deepEqual(overrides(withValues(own, { "contact.preload": "4" })), [
    "joint.lip-2.mass=2",
    "plate.mass=3",
    "contact.preload=4",
  ]);
  assert.deepEqual(Object.keys(withValues(own, { "joint.mass": "4" }).set), [
    "joint.upper.contact.preload",
    "plate.mass",
    "joint.mass",
  ]);
  const later = withValues(withValues(own, { "contact.preload": "4" }), { "joint.upper.contact.preload": "5" });
  assert.equal(Object.keys(later.set).at(-1), "joint.upper.contact.preload");
});
