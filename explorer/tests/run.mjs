// Bundles the unit tests, since node does not read TypeScript everywhere, and runs them. They lie in folders as what
// they test does.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdtemp, readdir, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const folder = join(dirname(fileURLToPath(import.meta.url)), "unit");
const out = await mkdtemp(join(tmpdir(), "stridor-explorer-"));
const names = (await readdir(folder, { recursive: true })).filter((name) => name.endsWith("_test.mjs"));
await build({
  entryPoints: names.map((name) => join(folder, name)),
  outdir: out,
  outExtension: { ".js": ".mjs" },
  bundle: true,
  platform: "node",
  format: "esm",
  logLevel: "warning",
});
const { status } = spawnSync(process.execPath, ["--test", ...names.map((name) => join(out, name))], {
  stdio: "inherit",
});
await rm(out, { recursive: true, force: true });
process.exit(status ?? 1);
