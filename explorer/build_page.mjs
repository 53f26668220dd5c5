// Puts the page in one file together: page, styles, the scripts of workers and of the microphone, and the core, as
// explorer/core builds it.
//
//     node build_page.mjs CORE.wasm OUT.html COMMIT
//
// `stridor page` writes a case into it and, if it is of the core's commit, what the page asks first with the answers.
// Fails when the file outgrows its budget.
import { build } from "esbuild";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const budget = 1_600_000; // bytes
const [core, out, commit] = process.argv.slice(2);
if (!core || !out || !commit) throw new Error("usage: node build_page.mjs CORE.wasm OUT.html COMMIT");
const source = join(dirname(fileURLToPath(import.meta.url)), "src");

async function bundle(entry) {
  const { outputFiles } = await build({
    entryPoints: [join(source, entry)],
    outdir: "/",
    bundle: true,
    write: false,
    minify: true,
    format: "iife",
    target: ["es2022"],
    charset: "ascii",
    legalComments: "none",
    logLevel: "warning",
  });
  const of = (ending) => outputFiles.find(({ path }) => path.endsWith(ending))?.text ?? "";
  return { script: of(".js"), style: of(".css") };
}

/** A text within an element of HTML that holds no markup. */
function inert(text) {
  if (/<\/(script|style)|<!--/i.test(text)) throw new Error("a part of the page would end its element");
  return text;
}

/**
 * Bytes as letters of windows-1252, one each: base64 would be a third longer. What HTML changes (NUL, a carriage
 * return), what could be markup and the escape itself are `=` and the byte 64 further on.
 */
function lettersOf(bytes) {
  const escaped = new Set([0x00, 0x0d, 0x3c, 0x3d]);
  return Buffer.from([...bytes].flatMap((byte) => (escaped.has(byte) ? [0x3d, byte + 64] : [byte]))).toString("latin1");
}

const hashOf = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

const page = await bundle("anywhere.ts");
const worker = await bundle("anywhere/worker.ts");
// as gzip unpacks it, 4 % smaller than gzip packs it
const packed = lettersOf(execFileSync("zopfli", ["-c", "--i5", core], { maxBuffer: 1e8 }));
const policy = [
  "default-src 'none'",
  `script-src ${hashOf(page.script)} 'wasm-unsafe-eval'`,
  `style-src ${hashOf(page.style)}`,
  "worker-src blob:",
  "img-src blob: data:",
  "media-src blob:",
  "connect-src 'none'",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");
const html = `<!doctype html>
<html lang="en">
<head>
<meta charset="windows-1252">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Stridor</title>
<link rel="icon" href="data:,">
<style>${inert(page.style)}</style>
</head>
<body>
<p>Stridor</p>
<noscript>This page needs JavaScript.</noscript>
<script type="application/json" id="stridor-case">null</script>
<script type="text/plain" id="stridor-first" data-commit="${commit}"></script>
<script type="text/plain" id="stridor-worker">${inert(worker.script)}</script>
<script type="text/plain" id="stridor-core">${packed}</script>
<script>${inert(page.script)}</script>
</body>
</html>
`;
await writeFile(out, html, "latin1");
const sizes = { page: page.script.length + page.style.length, worker: worker.script.length, core: packed.length };
console.log(`${out}: ${html.length} bytes of ${budget} (${JSON.stringify(sizes)})`);
if (html.length > budget) {
  console.error("The page is larger than its budget.");
  process.exitCode = 1;
}
