// Random cases, the same in every run: the native program and the core answer with the same bytes.
//
//     STRIDOR_RANDOM_CASES=200 node --test --test-name-pattern=chain tests/anywhere/random.test.mjs
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { program } from "../browser/session.mjs";
import { scratchFolder } from "../scratch.mjs";
import { random } from "../unit/random.mjs";
import { startCore } from "./core.mjs";
import { compare, startServed } from "./served.mjs";

const cases = Number(process.env.STRIDOR_RANDOM_CASES ?? 40);

/** What the cases are made of: the paper's stiff joints, soft parts, friction that falls, joints, structures. */
const kinds = ["", "weatherstrip", "glass-run", "wiper", "clip", "wiper-wet", "two-lips", "chain", "string"];

/**
 * Two of them simulated in less time, and no less of a motion: the chain a hundred times as quick, for some twenty of
 * its periods; of the string a quarter of the modes, for sixty periods.
 */
const quicker = {
  chain: {
    stiffness: '"1e4 N/m"',
    coupling: '"1.2e4 N/m"',
    preload: '"200 N"',
    duration: '"1 s"',
    window: '"1 s"',
  },
  string: { modes: "10", duration: '"0.6 s"', window: '"0.3 s"' },
};

/** The case (TOML) of a kind. */
function caseOf(kind) {
  let toml = execFileSync(program, ["init", kind], { encoding: "utf8" });
  for (const [key, value] of Object.entries(quicker[kind] ?? {})) {
    const line = new RegExp(`^${key} = .*$`, "m");
    assert.match(toml, line, kind);
    toml = toml.replace(line, `${key} = ${value}`);
  }
  return toml;
}

/** A few quantities, each within its usual range. */
function randomSet(ranges, number) {
  const keys = Object.keys(ranges);
  const chosen = new Set(
    Array.from({ length: 1 + Math.floor(number() * 5) }, () => Math.floor(number() * keys.length)),
  );
  const set = [...chosen].map((index) => {
    const key = keys[index];
    const { from, to, scale } = ranges[key];
    const at = number();
    const value = scale === "log" ? from * (to / from) ** at : from + at * (to - from);
    return `${key}=${value.toPrecision(1 + Math.floor(number() * 15))}`;
  });
  return set;
}

const folder = scratchFolder();

const questions = {
  "/api/simulate": {},
  "/api/motion": { from: 0.05, to: 0.15 },
  "/api/stability": { over: { key: "contact.kinetic_friction", from: 0, to: 0.8 } },
  "/api/toml": {},
  "/api/share": {},
  "/api/friction": { visited: true },
  "/api/modal": { of: "joint" },
};
const seldom = {
  "/api/sound": { seconds: 0.5 },
  "/api/analysis": { seconds: 1 },
  "/api/design": { around: false },
};

const seen = { 200: 0, 400: 0 };

for (const [k, kind] of kinds.entries()) {
  const share = Math.floor(cases / kinds.length) + (k < cases % kinds.length ? 1 : 0);
  const name = `${share} random cases of ${kind || "the paper's"} have answers of the same bytes`;
  test(name, { timeout: 3_600_000 }, async (t) => {
    const number = random(37 + k);
    const [toml, earlier] = [kind ? caseOf(kind) : "", seen[200]];
    const file = join(folder, `${kind}.toml`);
    if (kind) await writeFile(file, toml);
    const [served, core] = [await startServed(kind ? [file] : []), await startCore()];
    t.after(() => served.stop());
    if (kind) assert.equal((await core.open(toml)).status, 200);
    const { presets } = JSON.parse(core.ask("/api/start", "").bytes);
    const differing = [];
    for (let n = 0; n < share; ++n) {
      const { name: preset, ranges } = kind ? presets[0] : presets[n % presets.length];
      const set = randomSet(ranges, number);
      const asked = n % 4 === 0 ? { ...questions, ...seldom } : questions;
      for (const [path, body] of Object.entries(asked)) {
        const status = await compare(served, core, path, { preset, set, ...body }).catch(({ message }) => {
          differing.push(message);
        });
        if (path === "/api/simulate" && status) ++seen[status];
      }
    }
    t.diagnostic(`${seen[200] - earlier} were simulated`);
    assert.deepEqual(differing, []);
  });
}

test("most random cases are simulated, few refused", () => {
  assert.ok(seen[200] > 0.6 * (seen[200] + seen[400]), `${seen[200]} simulated, ${seen[400]} refused`);
});
