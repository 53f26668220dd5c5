// The core as the page runs it, for tests in node.
import { build } from "esbuild";
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const explorer = join(dirname(fileURLToPath(import.meta.url)), "../..");
export const built = process.env.STRIDOR_CORE ?? join(explorer, "../build-page");

/** A core that answers: `ask(path, body)` gives {status, bytes}. */
export async function startCore() {
  const { outputFiles } = await build({
    entryPoints: [join(explorer, "src/anywhere/module.ts")],
    bundle: true,
    write: false,
    format: "esm",
    logLevel: "warning",
  });
  const url = `data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`;
  const { Core } = await import(url);
  const core = new Core(await WebAssembly.compile(await readFile(join(built, "core.wasm"))));
  return {
    ask(path, body) {
      const parts = [];
      let status = 0;
      core.ask(path, typeof body === "string" ? body : JSON.stringify(body), {
        head: (head) => (status = head.status),
        part: (bytes) => parts.push(bytes),
      });
      return { status, bytes: Buffer.concat(parts) };
    },
    size: () => core.size,
  };
}
