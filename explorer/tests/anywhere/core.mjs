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
    stdin: {
      contents: 'export { Core } from "./module.ts"; export { unpacked } from "./opened.ts";',
      resolveDir: join(explorer, "src/anywhere"),
    },
    bundle: true,
    write: false,
    format: "esm",
    logLevel: "warning",
  });
  const url = `data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`;
  const { Core, unpacked } = await import(url);
  const core = new Core(await WebAssembly.compile(await readFile(join(built, "core.wasm"))));
  const heard = (asking) => {
    const parts = [];
    let status = 0;
    asking({ head: (head) => (status = head.status), part: (bytes) => parts.push(bytes) });
    return { status, bytes: Buffer.concat(parts) };
  };
  return {
    ask: (path, body) => heard((told) => core.ask(path, typeof body === "string" ? body : JSON.stringify(body), told)),
    /** Opens a case (TOML) with files beside it: bytes by name. */
    async open(toml, files = {}) {
      const each = Object.entries(files).map(([name, content]) =>
        unpacked(name, Uint8Array.from(Buffer.from(content))),
      );
      const held = (await Promise.all(each))
        .flat()
        .map(([name, bytes]) => [name, Buffer.from(bytes).toString("base64")]);
      return heard((told) => core.open(JSON.stringify({ toml, files: Object.fromEntries(held) }), told));
    },
    hear: (name, bytes) => heard((told) => core.hear(name, bytes, told)),
    size: () => core.size,
  };
}
