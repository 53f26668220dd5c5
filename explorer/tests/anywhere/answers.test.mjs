// Each kind of answer by the native program and by the core in WebAssembly: the same bytes, but for the commit.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { before, test } from "node:test";
import { program } from "../browser/session.mjs";
import { scratchFolder } from "../scratch.mjs";
import { random } from "../unit/random.mjs";
import { npyOf, zipOf } from "../unit/zip_writer.mjs";
import { startCore } from "./core.mjs";
import { compare, startServed } from "./served.mjs";

const ready = ["weatherstrip", "two-lips", "chain", "string"];
const folder = scratchFolder();

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

const ofMatrices = (stiffness, mass) => `[structure]
stiffness = "${stiffness}"
mass = "${mass}"
damping_ratio = "1 %"
contacts = "contacts.csv"
[contact]
preload = "5 N"
static_friction = 0.8
kinetic_friction = 0.3
[drive]
kind = "constant"
velocity = "20 mm/s"
`;

/** Cases that lean on other files, by what they lean on. */
const leaning = {
  "the samples of a drive": {
    toml: () =>
      execFileSync(program, ["init", "squeal"], { encoding: "utf8" }).replace(
        /\[drive\][^]*?\n(?=\[run\])/,
        '[drive]\nkind = "sampled"\nfile = "folder/speed.csv"\n\n',
      ),
    files: { "speed.csv": "time [s],velocity [m/s]\n0,0\n0.5,0.2\n1.5,-0.1\n5,0.1\n" },
  },
  "matrices and a table of contacts": {
    toml: () => ofMatrices("k.csv", "folder/m.csv"),
    files: {
      "k.csv": "1e5,-4e4\n-4e4,2e5\n",
      "m.csv": "0.1,0\n0,0.1\n",
      "contacts.csv": "name,normal,tangent\nfoot,u2,u1\n",
    },
  },
  "a sparse and a dense matrix of NumPy": {
    toml: () => ofMatrices("k.npz", "folder/m.npy"),
    files: {
      "k.npz": zipOf({
        "indices.npy": npyOf("i4", "(4,)", [0, 1, 0, 1]),
        "indptr.npy": npyOf("i4", "(3,)", [0, 2, 4]),
        "format.npy": npyOf("S3", "()", "csr"),
        "shape.npy": npyOf("i8", "(2,)", [2, 2]),
        "data.npy": npyOf("f8", "(4,)", [1e5, -4e4, -4e4, 2e5]),
      }),
      "m.npy": npyOf("f8", "(2, 2)", [0.1, 0, 0, 0.1]),
      "contacts.csv": "name,normal,tangent\nfoot,2,1\n",
    },
  },
  "an archive of dense matrices": {
    toml: () => ofMatrices("folder/part.npz:K", "folder/part.npz:M"),
    files: {
      "part.npz": zipOf(
        { "K.npy": npyOf("f8", "(2, 2)", [1e5, -4e4, -4e4, 2e5]), "M.npy": npyOf("f8", "(2, 2)", [0.1, 0, 0, 0.1]) },
        { deflated: false },
      ),
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
    const lacking = await core.open(toml(), Object.fromEntries(Object.entries(files).slice(1)));
    assert.equal(lacking.status, 400);
    assert.match(lacking.bytes.toString(), new RegExp(`${first}.*is not here`));
    assert.match(lacking.bytes.toString(), /Choose it together with the case/);
    const opened = await core.open(toml(), files);
    assert.equal(opened.status, 200, opened.bytes.toString());
    for (const path of ["/api/simulate", "/api/motion", "/api/toml"])
      await compare(served, core, path, { preset: "file", set: [] });
    // and without it once it is read: a slider moves
    await compare(served, core, "/api/simulate", { preset: "file", set: ["contact.preload=31"] });
  });

/** A WAV file of a noise that buzzes; samples of `bits` bits, whole numbers or (32) floats. */
function buzz(bits, coding, seconds = 1.5) {
  const [rate, width] = [24_000, bits / 8];
  const bytes = Buffer.alloc(44 + Math.round(seconds * rate) * width);
  bytes.write("RIFF", 0);
  bytes.writeUInt32LE(bytes.length - 8, 4);
  bytes.write("WAVEfmt ", 8);
  bytes.writeUInt32LE(16, 16);
  bytes.writeUInt16LE(coding, 20);
  bytes.writeUInt16LE(1, 22);
  bytes.writeUInt32LE(rate, 24);
  bytes.writeUInt32LE(rate * width, 28);
  bytes.writeUInt16LE(width, 32);
  bytes.writeUInt16LE(bits, 34);
  bytes.write("data", 36);
  bytes.writeUInt32LE(bytes.length - 44, 40);
  const number = random(5);
  for (let k = 0; k < seconds * rate; ++k) {
    const sample = 0.4 * Math.sin((2 * Math.PI * 1234.5 * k) / rate) + 0.1 * (number() - 0.5);
    const at = 44 + k * width;
    if (coding === 3) bytes.writeFloatLE(sample, at);
    else if (bits === 8) bytes.writeUInt8(Math.round(sample * 100) + 128, at);
    else bytes.writeIntLE(Math.round(sample * (2 ** (bits - 1) - 1)), at, width);
  }
  return bytes;
}

test("a recording is heard as the program hears it, whatever its coding", async (t) => {
  const library = join(folder, "noises.sqlite");
  const codings = [[8, 1], [16, 1], [24, 1], [32, 1], [32, 3]]; // prettier-ignore
  const sounds = codings.map(([bits, coding]) => [`buzz-${bits}-${coding}.wav`, buzz(bits, coding)]);
  const rows = Array.from({ length: 6000 }, (_, k) => `${k / 8000},${Math.sin(k / 3)}`);
  sounds.push(["table.csv", Buffer.from(`time [s],pressure [Pa]\n${rows.join("\n")}\n`)]);
  for (const [name, bytes] of sounds) await writeFile(join(folder, name), bytes);
  for (const [name] of sounds)
    execFileSync(program, ["library", "add", "--library", library, join(folder, name)], { stdio: "pipe" });
  const [served, core] = [await startServed(["--library", library]), await startCore()];
  t.after(() => served.stop());
  for (const [k, [name, bytes]] of sounds.entries()) {
    const native = await served.get(`/api/library/${k + 1}/analysis`);
    assert.equal(native.status, 200, `${name}: ${native.bytes.subarray(0, 300)}`);
    const inside = core.hear(name, bytes);
    assert.equal(inside.status, 200, `${name}: ${inside.bytes.subarray(0, 300)}`);
    assert.ok(inside.bytes.equals(native.bytes), name);
  }
  const [, whole] = sounds[1];
  for (const [name, bytes] of [
    ["cut.wav", whole.subarray(0, 999)],
    ["none.wav", whole.subarray(0, 20)],
    ["a.mat", Buffer.from("MATLAB 5.0 MAT-file")],
  ]) {
    const refused = core.hear(name, bytes);
    assert.equal(refused.status, 400, name);
    assert.match(refused.bytes.toString(), /cut off|no whole WAV|is not read/);
  }
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
