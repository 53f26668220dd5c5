// The golden results in WebAssembly: the same hashes as the native program has in tests/golden/golden.txt.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const source = join(here, "../../..");
const built = process.env.STRIDOR_CORE ?? join(source, "build-page");

/** Results whose bits differ, with the reason; one that becomes equal must leave this list. */
const different = {};

function linesOf(text) {
  const lines = text.split("\n").filter((line) => line && !/^(#|results_version)/.test(line));
  return new Map(lines.map((line) => [line.split(" ")[0], line.split(" ")[1]]));
}

test("every golden result has the same bits in WebAssembly", async () => {
  const said = linesOf(await readFile(join(source, "tests/golden/golden.txt"), "utf8"));
  const run = spawnSync(
    process.execPath,
    ["--no-warnings", "--stack-size=4000", join(here, "run_wasi.mjs"), join(built, "golden.wasm"), source],
    { encoding: "utf8" },
  );
  assert.equal(run.status, 0, run.stderr);
  const found = linesOf(run.stdout);
  assert.deepEqual([...found.keys()].sort(), [...said.keys()].sort());
  const moved = [...said.keys()].filter((name) => said.get(name) !== found.get(name));
  assert.deepEqual(moved.sort(), Object.keys(different).sort());
});
