import assert from "node:assert/strict";
import { test } from "node:test";
import { companions, dependants, needsFile } from "../../../src/views/companions.ts";

const quantity = (key, belongs_to, value) => ({ key, kind: "quantity", belongs_to, default: value });
// as GET /api/start lists them
const fields = [
  quantity("contact.static_friction", {}, 0.8),
  quantity("contact.static_friction_coming", { "contact.friction": ["directional"] }, 0.8),
  quantity("contact.restitution", { "contact.impact": ["restitution"] }, 0.5),
  { key: "drive.kind", kind: "choice", belongs_to: {}, choices: ["sinusoidal", "constant", "sampled", "trapezoidal"] },
  quantity("drive.amplitude", { "drive.kind": ["sinusoidal"] }, 0.004),
  quantity("drive.frequency", { "drive.kind": ["sinusoidal", "trapezoidal"] }, 5),
  quantity("drive.velocity", { "drive.kind": ["constant", "trapezoidal"] }, 0.1),
  quantity("drive.ramp", { "drive.kind": ["trapezoidal"] }, 0.02),
  { key: "drive.file", kind: "text", belongs_to: { "drive.kind": ["sampled"] } },
  { key: "verdict.settling", kind: "quantity", belongs_to: { "drive.kind": ["sinusoidal", "sampled", "trapezoidal"] } },
  { key: "run.step", kind: "quantity", belongs_to: { "run.engine": ["beta_2"] } },
];
const of = (known) => (key) => known[key] ?? NaN;

test("what a choice decides of goes with it", () => {
  assert.deepEqual(dependants(fields, "contact.impact"), ["contact.restitution"]);
  assert.ok(dependants(fields, "drive.kind").includes("verdict.settling"));
  assert.deepEqual(dependants(fields, "drive.file"), []);
});

test("another drive is as fast", () => {
  const sinusoidal = of({ "drive.amplitude": 0.01, "drive.frequency": 2 });
  assert.deepEqual(companions(fields, "drive.kind", "constant", sinusoidal, "coming"), { "drive.velocity": "-0.126" });
  const constant = of({ "drive.velocity": -0.5 });
  assert.deepEqual(companions(fields, "drive.kind", "sinusoidal", constant, "going"), {
    "drive.amplitude": "0.0159",
    "drive.frequency": "5",
  });
});

test("what the present case has is kept, what it has not begins as the program's default", () => {
  const sinusoidal = of({ "drive.amplitude": 0.01, "drive.frequency": 2 });
  assert.deepEqual(companions(fields, "drive.kind", "trapezoidal", sinusoidal, "going"), {
    "drive.frequency": "2",
    "drive.velocity": "0.126",
    "drive.ramp": "0.02",
  });
  assert.deepEqual(companions(fields, "contact.impact", "restitution", of({}), "going"), {
    "contact.restitution": "0.5",
  });
  const friction = of({ "contact.static_friction": 0.9 });
  assert.deepEqual(companions(fields, "contact.friction", "directional", friction, "going"), {
    "contact.static_friction_coming": "0.9",
  });
  assert.deepEqual(companions(fields, "run.engine", "beta_2", of({}), "going"), {}); // a case may leave it out
});

test("a drive from a file cannot be chosen on the page", () => {
  assert.ok(needsFile(fields, "drive.kind", "sampled"));
  assert.ok(!needsFile(fields, "drive.kind", "trapezoidal"));
});
