// The running program's answers against the types that the page reads them with (src/data, src/program). Each answer
// becomes a literal of its type, and the compiler says which key or word is missing in the one or the other.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { scratchFolder } from "../scratch.mjs";
import { program, startExplorer } from "./session.mjs";

const page = join(dirname(fileURLToPath(import.meta.url)), "../..");
const files = ["data/types.ts", "data/answer_types.ts", "program/words.ts"].map((name) => join(page, "src", name));

const folder = scratchFolder();
let explorer;
let cookie;
const answers = []; // {type, answer}

before(async () => {
  const [file, sound, library] = ["seal.toml", "sound.wav", "noises.sqlite"].map((name) => join(folder, name));
  execFileSync(program, ["init", "weatherstrip", "--output", file]);
  execFileSync(program, ["listen", "-", "--out", sound], { input: execFileSync(program, ["init", "creak"]) });
  execFileSync(program, ["library", "add", sound, "--library", library, "--system", "seal"], { stdio: "ignore" });
  explorer = await startExplorer([file, "--library", library]);
  const opened = await fetch(explorer.link(), { redirect: "manual" });
  cookie = opened.headers.get("set-cookie").split(";")[0];
});

after(async () => {
  assert.equal(await explorer?.stop(), 0);
});

async function ask(path, body, session = { origin: explorer.origin, cookie }) {
  const headers = { "Cookie": session.cookie, "Origin": session.origin, "Content-Type": "application/json" };
  const content = body && { method: "POST", body: JSON.stringify(body) };
  return fetch(session.origin + path, { headers, ...content });
}

// two contacts of which the first, where it slides, lifts the second off
const structure = `
[structure]
mass = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
stiffness = [[2, 0, 0, -1.2], [0, 2, 0, 0], [0, 0, 2, 0], [-1.2, 0, 0, 2]]
[[structure.contact]]
name = "a"
normal = "u2"
tangent = "u1"
preload_share = 10
interface = "lip"
position = [0, 0, 0]
[[structure.contact]]
name = "b"
normal = "u4"
tangent = "u3"
preload_share = 1
interface = "lip"
position = [0, 0, 0.01]
[contact]
preload = 11
static_friction = 0.6
kinetic_friction = 0.5
[drive]
kind = "constant"
velocity = 0.1
[run]
duration = 20
`;

const stribeck = ["contact.friction=stribeck", "contact.stribeck_velocity=0.05"];

/** An answer, which is held against its type in the end. */
async function answerOf(type, path, body) {
  const response = await ask(path, body);
  const text = await response.text();
  assert.equal(response.status, type === "Refusal" ? 400 : 200, `${path}: ${text}`);
  return kept(type, JSON.parse(text));
}

function kept(type, answer) {
  answers.push({ type, answer });
  return answer;
}

/** Held against its type with nothing left out: what is optional there must be here. */
function keptWhole(type, answer) {
  kept(`Required<${type}>`, answer);
}

function without(object, keys) {
  return Object.fromEntries(Object.entries(object).filter(([key]) => !keys.includes(key)));
}

/** What a value looks like: of two items of a list that look alike the compiler sees one. */
function look(value) {
  if (Array.isArray(value)) return `[${[...new Set(value.map(look))].join()}]`;
  if (value !== null && typeof value === "object")
    return `{${Object.entries(value).map(([key, each]) => `${key}:${look(each)}`)}}`;
  if (typeof value === "string") return /^[a-z_]{1,15}$/.test(value) ? value : "text";
  return value === null ? "null" : typeof value;
}

function shortened(value) {
  if (Array.isArray(value)) return [...new Map(value.map((each) => [look(each), shortened(each)])).values()];
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, shortened(each)]));
}

/** What the compiler says of answers that are written down as literals of their types; empty if they fit. */
async function complaints(written) {
  const names = new Set(written.map(({ type }) => /(\w+)>?$/.exec(type)[1]));
  const lines = [];
  for (const file of files) {
    const source = await readFile(file, "utf8");
    const here = [...names].filter((name) => new RegExp(`^export (interface|type) ${name}\\b`, "m").test(source));
    if (here.length > 0) lines.push(`import type { ${here.join(", ")} } from ${JSON.stringify(file)};`);
  }
  written.forEach(({ type, answer }, k) =>
    lines.push(`export const answer${k}: ${type} = ${JSON.stringify(shortened(answer), null, 1)};`),
  );
  const options = { extends: join(page, "tsconfig.json"), include: [], files: ["answers.ts"] };
  await writeFile(join(folder, "answers.ts"), lines.join("\n"));
  await writeFile(join(folder, "tsconfig.json"), JSON.stringify(options));
  const compiler = join(page, "node_modules/typescript/bin/tsc");
  const { status, stdout } = spawnSync(process.execPath, [compiler, "--project", folder], { encoding: "utf8" });
  assert.equal(status === 0, stdout === "");
  return stdout;
}

test("what the page begins with", async () => {
  const start = await answerOf("Start", "/api/start");
  keptWhole("Preset", start.presets[0]); // with the chart of its file
  keptWhole(
    "QuantityField",
    start.fields.find(({ usual }) => usual),
  );
});

test("simulations of every ending", async () => {
  const designs = [
    { preset: "squeal", set: [] },
    { preset: "squeal", set: ["run.engine=beta_2"] },
    { preset: "squeal", set: ["run.engine=moreau", "run.step=1e-5"] },
    { preset: "squeal", set: ["run.engine=auto", "run.step=1e-5", ...stribeck, "contact.stribeck_exponent=1.5"] },
    { preset: "quiet", set: ["drive.kind=constant", "drive.velocity=1"] }, // proven to be silent
    { preset: "squeal", set: ["drive.kind=constant", "drive.velocity=1"] }, // a limit cycle
    { preset: "file", set: [] },
  ];
  const simulations = [];
  for (const design of designs) simulations.push(await answerOf("Simulation", "/api/simulate", design));
  keptWhole("Margin", simulations[0].phases[0].verdict.margins[0]);
  keptWhole("Engine", Object.assign({}, ...simulations.slice(1, 4).map(({ engine }) => engine)));
  keptWhole("Verdict", simulations[2].phases[0].verdict);
  keptWhole("Outcome", Object.assign({}, ...simulations.map(({ outcome }) => outcome)));
});

test("laws of friction", async () => {
  const law = await answerOf("FrictionLaw", "/api/friction", { preset: "squeal", set: stribeck, visited: true });
  keptWhole("Grip", law.grips[0]);
  const rows = ["contact.friction=table", "contact.friction_table=0: 0.8, 0.3: 0.5"];
  const measured = await answerOf("FrictionLaw", "/api/friction", { preset: "squeal", set: rows, reach: 0.2 });
  assert.equal(measured.rows.length, 2);
  const smooth = ["contact.friction=tanh", "contact.regularisation=0.01", "run.engine=moreau", "run.step=1e-5"];
  await answerOf("FrictionLaw", "/api/friction", { preset: "squeal", set: smooth });
});

test("the header of a motion", async () => {
  const bytes = await (await ask("/api/motion", { preset: "squeal", set: [], from: 0, to: 0.01 })).arrayBuffer();
  const length = new DataView(bytes).getUint32(0, true);
  kept("MotionHeader", JSON.parse(new TextDecoder().decode(bytes.slice(4, 4 + length))));
});

test("structures of one's own", async () => {
  const own = join(folder, "own.toml");
  const string = join(folder, "string.toml");
  await writeFile(own, structure);
  execFileSync(program, ["init", "string", "--output", string]);
  for (const file of [own, string]) {
    const server = await startExplorer([file]);
    try {
      const opened = await fetch(server.link(), { redirect: "manual" });
      const session = { origin: server.origin, cookie: opened.headers.get("set-cookie").split(";")[0] };
      const body = { preset: "file", set: ["run.duration=2"] };
      const simulation = kept("Simulation", await (await ask("/api/simulate", body, session)).json());
      const bytes = await (await ask("/api/motion", { ...body, to: 0.01 }, session)).arrayBuffer();
      const length = new DataView(bytes).getUint32(0, true);
      const header = kept("MotionHeader", JSON.parse(new TextDecoder().decode(bytes.slice(4, 4 + length))));
      if (file === string) {
        keptWhole("MotionHeader", header);
        continue;
      }
      keptWhole("PhaseResult", simulation.phases[0]);
      keptWhole("OwnContact", simulation.case.structure.contacts[0]);
      const stability = kept("Stability", await (await ask("/api/stability", body, session)).json());
      keptWhole(
        "SlidingStability",
        without(
          stability.directions.find(({ open }) => open),
          ["direction", "points", "boundaries"],
        ),
      );
    } finally {
      assert.equal(await server.stop(), 0);
    }
  }
});

test("the frames of a chart", async () => {
  const axis = (parameter, from, to) => ({ parameter, from, to, points: 12, scale: "linear" });
  const chart = { x: axis("contact.preload", 1, 80), y: axis("contact.kinetic_friction", 0, 0.8), refine: 1 };
  for (const figure of ["category", "joint_level"]) {
    const body = { preset: "squeal", set: [], chart, preview: true, figure };
    const frames = (await (await ask("/api/chart", body)).text()).trim().split("\n");
    for (const frame of frames) kept("ChartFrame", JSON.parse(frame));
    if (figure !== "category") keptWhole("ChartFrame", Object.assign({}, ...frames.map((frame) => JSON.parse(frame))));
  }
});

test("stability", async () => {
  await answerOf("Stability", "/api/stability", { preset: "squeal", set: [] });
  const over = { key: "contact.kinetic_friction", from: 0, to: 2, points: 21 };
  const body = { preset: "squeal", set: ["contact.static_friction=2"], over };
  keptWhole("Stability", await answerOf("Stability", "/api/stability", body));
});

test("advice", async () => {
  const tolerance = [{ key: "contact.preload", relative: 0.1 }];
  const over = [
    { key: "contact.preload", from: 1, to: 80 },
    { key: "contact.kinetic_friction", from: 0.1, to: 2 }, // more than the static one: the scan ends
  ];
  const body = { preset: "squeal", set: [], over, tolerance, samples: 16 };
  const advice = await answerOf("Advice", "/api/advice", body);
  const ends = advice.margins.flatMap(({ end_below, end_above }) => [end_below, end_above]);
  keptWhole(
    "ScanEnd",
    ends.find(({ reason }) => reason),
  );
  await answerOf("Advice", "/api/advice", { preset: "quiet", set: [], over: [{ key: "contact.preload" }] });
});

test("sounds and recordings", async () => {
  const options = { direction: "whole", of: "joint", quantity: "velocity", rate: 16000, seconds: 0.3 };
  await answerOf("Analysis", "/api/analysis", { preset: "squeal", set: [], ...options });
  const modal = await answerOf("ModalLines", "/api/modal", { preset: "squeal", set: [], of: "joint" });
  assert.ok(modal.lines.length > 2 && modal.lines.some(({ shares }) => shares[0].share > 0.9));
  const library = await answerOf("Library", "/api/library");
  await answerOf("Analysis", `/api/library/${library.entries[0].id}/analysis`);
  keptWhole("LibraryEntry", library.entries[0]);
});

test("values, shared cases, refusals", async () => {
  await answerOf("Value", "/api/value", { key: "contact.preload", text: "2 kN" });
  await answerOf("Shared", "/api/share", { preset: "squeal", set: ["contact.preload=35"] });
  await answerOf("DesignAnswer", "/api/design", { preset: "quiet", set: [], around: true });
  const set = ["contact.preload=1e9", "joint.mass=-1"];
  const { error } = await answerOf("Refusal", "/api/simulate", { preset: "squeal", set });
  keptWhole("ServerError", error);
});

test("every answer fits its type", async () => {
  assert.equal(await complaints(answers), "");
});

test("every type with keys that may be missing was met with all of them", async () => {
  const source = (await Promise.all(files.map((file) => readFile(file, "utf8")))).join("\n");
  const optional = [...source.matchAll(/interface (\w+)[^{]*\{([^]*?)\n\}/g)].filter(([, , body]) => /\?:/.test(body));
  const met = answers.map(({ type }) => type);
  assert.ok(optional.length > 5);
  for (const [, name] of optional) assert.ok(met.includes(`Required<${name}>`), name);
});

test("a key more and a key less are told", async () => {
  const { answer } = answers.find(({ type }) => type === "Simulation");
  const [first, ...rest] = answer.phases;
  const { period: _, ...less } = first.verdict;
  const more = { ...first.verdict, loudness: 1 };
  const changed = (verdict) => ({ ...answer, phases: [{ ...first, verdict }, ...rest] });
  assert.match(await complaints([{ type: "Simulation", answer: changed(less) }]), /'period' is missing/);
  assert.match(await complaints([{ type: "Simulation", answer: changed(more) }]), /"loudness"' does not exist/);
  const other = { ...first.verdict, category: "hiss" };
  assert.match(await complaints([{ type: "Simulation", answer: changed(other) }]), /"hiss"/);
});
