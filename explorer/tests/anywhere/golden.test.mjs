// The golden results in WebAssembly: the same hashes as the native program has in tests/golden/golden.txt.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readdir, readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { firefox, openFirefox } from "../browser/firefox.mjs";
import { lacking } from "../browser/needs.mjs";
import { openPage } from "../browser/session.mjs";
import { runInPage } from "./browser_wasi.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const source = join(here, "../../..");
const built = process.env.STRIDOR_CORE ?? join(source, "build-page");

/** Results whose bits differ, with the reason; one that becomes equal must leave this list. */
const different = {};

function linesOf(text) {
  const lines = text.split("\n").filter((line) => line && !/^(#|results_version)/.test(line));
  return new Map(lines.map((line) => [line.split(" ")[0], line.split(" ")[1]]));
}

const saidLines = async () => linesOf(await readFile(join(source, "tests/golden/golden.txt"), "utf8"));

function compare(said, printed) {
  const found = linesOf(printed);
  assert.deepEqual([...found.keys()].sort(), [...said.keys()].sort(), printed.slice(0, 300));
  const moved = [...said.keys()].filter((name) => said.get(name) !== found.get(name));
  assert.deepEqual(moved.sort(), Object.keys(different).sort());
}

test("every golden result has the same bits in WebAssembly", async () => {
  const said = await saidLines();
  const run = spawnSync(
    process.execPath,
    ["--no-warnings", "--stack-size=4000", join(here, "run_wasi.mjs"), join(built, "golden.wasm"), source],
    { encoding: "utf8" },
  );
  assert.equal(run.status, 0, run.stderr);
  compare(said, run.stdout);
});

/** The cases that the program reads, by their path below the source. */
async function files() {
  const folder = join(source, "cases");
  const names = (await readdir(folder, { recursive: true })).filter((name) => name.endsWith(".toml"));
  return Object.fromEntries(
    await Promise.all(names.map(async (name) => [`cases/${name}`, await readFile(join(folder, name), "utf8")])),
  );
}

test("every golden result has the same bits in Chromium", { timeout: 600_000 }, async (t) => {
  const { page, close } = await openPage({ origin: "about:blank", link: () => "about:blank" });
  t.after(close);
  const given = [(await readFile(join(built, "golden.wasm"))).toString("base64"), source, await files()];
  const printed = await page.evaluate(`(${runInPage})(...${JSON.stringify(given)})`);
  compare(await saidLines(), printed);
});

test(
  "every golden result has the same bits in Firefox",
  { skip: lacking(firefox, "Firefox", "firefox-esr"), timeout: 600_000 },
  async (t) => {
    const browser = await openFirefox(firefox);
    t.after(() => browser.close());
    await browser.goto("about:blank");
    const given = [(await readFile(join(built, "golden.wasm"))).toString("base64"), source, await files()];
    const noted = "(text) => (window.printed = text), (error) => (window.failed = String(error))";
    const script = `(${runInPage})(...arguments).then(${noted});`;
    await browser.run(script, ...given);
    const printed = await browser.wait("return window.printed ?? window.failed ?? null;");
    compare(await saidLines(), printed);
  },
);
