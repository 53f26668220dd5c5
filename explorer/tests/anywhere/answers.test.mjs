// Each kind of answer by the native program and by the core in WebAssembly: the same bytes, but for the commit.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { program } from "../browser/session.mjs";
import { startCore } from "./core.mjs";
import { compare, startServed } from "./served.mjs";

const ready = ["weatherstrip", "two-lips", "chain", "string"];
let folder;

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "stridor-anywhere-"));
});

after(() => rm(folder, { recursive: true, force: true }));

const axis = (parameter, from, to) => ({ parameter, from, to, points: 5, scale: "linear" });
const chart = {
  x: axis("contact.preload", 2, 60),
  y: axis("contact.kinetic_friction", 0.1, 0.7),
  refine: 1,
};

const questions = {
  "/api/simulate": {},
  "/api/motion": { from: 0.1, to: 0.2 },
  "/api/stability": { over: { key: "contact.kinetic_friction", from: 0, to: 0.8 } },
  "/api/toml": {},
  "/api/sound": { seconds: 1 },
  "/api/analysis": { seconds: 1 },
  "/api/modal": { of: "joint" },
  "/api/design": { around: false },
  "/api/share": {},
  "/api/friction": { visited: true },
  "/api/chart": { chart, figure: "category" },
};

test("every answer on the paper's four cases has the same bytes", async (t) => {
  const [served, core] = [await startServed([]), await startCore()];
  t.after(() => served.stop());
  for (const preset of ["squeal", "squeak", "creak", "quiet"])
    for (const [path, body] of Object.entries(questions))
      await compare(served, core, path, { preset, set: [], ...body });
  await compare(served, core, "/api/value", { key: "contact.preload", text: "3 kN" });
  await compare(served, core, "/api/advice", { preset: "squeal", samples: 16, over: [{ key: "contact.preload" }] });
});

test("every answer on other kinds of cases has the same bytes", async (t) => {
  for (const name of ready) {
    const file = join(folder, `${name}.toml`);
    execFileSync(program, ["init", name, "-o", file]);
    const [served, core] = [await startServed([file]), await startCore()];
    t.after(() => served.stop());
    assert.equal(core.ask("/api/open", await readFile(file, "utf8")).status, 200);
    for (const path of ["/api/simulate", "/api/motion", "/api/toml", "/api/stability"])
      await compare(served, core, path, { preset: "file", set: [] });
  }
});

/** Cases that lean on other files, by what they lean on. */
const leaning = {
  "the samples of a drive": {
    toml: () =>
      execFileSync(program, ["init", "squeal"], { encoding: "utf8" }).replace(
        /\[drive\][^[]*/,
        '[drive]\nkind = "sampled"\nfile = "folder/speed.csv"\n\n',
      ),
    files: { "speed.csv": "time [s],velocity [m/s]\n0,0\n0.5,0.2\n1.5,-0.1\n5,0.1\n" },
  },
  "matrices and a table of contacts": {
    toml: () => `[structure]
stiffness = "k.csv"
mass = "folder/m.csv"
damping_ratio = "1 %"
contacts = "contacts.csv"
[contact]
preload = "5 N"
static_friction = 0.8
kinetic_friction = 0.3
[drive]
kind = "constant"
velocity = "20 mm/s"
`,
    files: {
      "k.csv": "1e5,-4e4\n-4e4,2e5\n",
      "m.csv": "0.1,0\n0,0.1\n",
      "contacts.csv": "name,normal,tangent\nfoot,2,1\n",
    },
  },
};

for (const [what, { toml, files }] of Object.entries(leaning))
  test(`a case that leans on ${what} is opened with it, and has the same answers`, async (t) => {
    const file = join(folder, "leaning.toml");
    await writeFile(file, toml());
    await mkdir(join(folder, "folder"), { recursive: true });
    for (const [name, text] of Object.entries(files))
      for (const place of [folder, join(folder, "folder")]) await writeFile(join(place, name), text);
    const [served, core] = [await startServed([file]), await startCore()];
    t.after(() => served.stop());
    const [first] = Object.keys(files);
    const lacking = core.open(toml(), Object.fromEntries(Object.entries(files).slice(1)));
    assert.equal(lacking.status, 400);
    assert.match(lacking.bytes.toString(), new RegExp(`${first}.*is not here`));
    assert.match(lacking.bytes.toString(), /Choose it together with the case/);
    const opened = core.open(toml(), files);
    assert.equal(opened.status, 200, opened.bytes.toString());
    for (const path of ["/api/simulate", "/api/motion", "/api/toml"])
      await compare(served, core, path, { preset: "file", set: [] });
    // and without it once it is read: a slider moves
    await compare(served, core, "/api/simulate", { preset: "file", set: ["contact.preload=31"] });
  });

test("a wrong question is refused in the same words", async (t) => {
  const [served, core] = [await startServed([]), await startCore()];
  t.after(() => served.stop());
  for (const set of [["contact.preload=-1"], ["contact.preload"], ["drive.file=/etc/passwd"], ["no.such=1"]])
    await compare(served, core, "/api/simulate", { preset: "squeal", set });
});

test("a case that is none leaves the core as it was", async () => {
  const core = await startCore();
  const before = core.ask("/api/start", "").bytes;
  for (const text of ["contact = 1", "[", "title = '</script>'", "\0", '[structure]\nfile = "/etc/passwd"\n'])
    assert.equal(core.ask("/api/open", text).status, 400, text);
  assert.deepEqual(core.ask("/api/start", "").bytes, before);
});
