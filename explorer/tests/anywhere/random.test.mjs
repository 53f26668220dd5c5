// Random cases, the same in every run: the native program and the core answer with the same bytes.
//
//     STRIDOR_RANDOM_CASES=200 node --test tests/anywhere/random.test.mjs
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { program } from "../browser/session.mjs";
import { random } from "../unit/random.mjs";
import { startCore } from "./core.mjs";
import { compare, startServed } from "./served.mjs";

const cases = Number(process.env.STRIDOR_RANDOM_CASES ?? 40);

/** What the cases are made of: the paper's stiff joints, soft parts, friction that falls, joints, structures. */
const kinds = ["", "weatherstrip", "glass-run", "wiper", "clip", "wiper-wet", "two-lips", "chain", "string"];

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

test(`${cases} random cases have answers of the same bytes`, { timeout: 3_600_000 }, async (t) => {
  const folder = await mkdtemp(join(tmpdir(), "stridor-random-"));
  t.after(() => rm(folder, { recursive: true, force: true }));
  const number = random(37);
  const seen = { 200: 0, 400: 0 };
  const differing = [];
  for (const [k, kind] of kinds.entries()) {
    const file = join(folder, `${kind || "none"}.toml`);
    if (kind) execFileSync(program, ["init", kind, "-o", file]);
    const [served, core] = [await startServed(kind ? [file] : []), await startCore()];
    t.after(() => served.stop());
    if (kind) assert.equal((await core.open(await readFile(file, "utf8"))).status, 200);
    const { presets } = JSON.parse(core.ask("/api/start", "").bytes);
    const share = Math.floor(cases / kinds.length) + (k < cases % kinds.length ? 1 : 0);
    for (let n = 0; n < share; ++n) {
      const { name: preset, ranges } = kind ? presets[0] : presets[n % presets.length];
      const set = randomSet(ranges, number);
      const asked = n % 4 === 0 ? { ...questions, ...seldom } : questions;
      for (const [path, body] of Object.entries(asked)) {
        const status = await compare(served, core, path, { preset, set, ...body }).catch((error) =>
          differing.push(`${kind}: ${error.message}`),
        );
        if (path === "/api/simulate") ++seen[status];
      }
    }
    t.diagnostic(`${kind || "the paper's"}: ${share} cases`);
  }
  t.diagnostic(`${seen[200]} cases were simulated, ${seen[400]} refused`);
  assert.deepEqual(differing, []);
  assert.ok(seen[200] > 0.6 * cases, `only ${seen[200]} of ${cases} cases were none that is refused`);
});
