// Bundles the page into dist/: what it opens with, and later.js, which it fetches when a view or a sheet of it is first
// asked for; microphone.js is of the microphone. Fails when any outgrows its budget.
import { build } from "esbuild";
import { copyFile, mkdir, readFile, readdir, rm } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

// bytes, gzip
const parts = [
  { name: "first load", budget: 43_000, files: ["index.html", "page.js", "chunk.js", "page.css"] },
  { name: "later", budget: 46_000, files: ["later.js"] },
  { name: "microphone", budget: 3_000, files: ["microphone.js"] },
];
const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "dist");

await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });
const options = {
  outdir: out,
  bundle: true,
  minify: true,
  format: "esm",
  target: ["es2022"],
  charset: "utf8",
  legalComments: "none",
  logLevel: "warning",
};
// shares nothing with the others, which would be a chunk more
const apart = {
  name: "apart",
  setup({ onResolve }) {
    onResolve({ filter: /\/microphone\.ts$/ }, () => ({ path: "./microphone.js", external: true }));
  },
};
await build({
  ...options,
  entryPoints: { page: join(here, "src/main.ts") },
  splitting: true, // later.js is its own, chunk.js what both use
  chunkNames: "[name]",
  plugins: [apart],
});
await build({ ...options, entryPoints: { microphone: join(here, "src/views/microphone.ts") } });
await copyFile(join(here, "src/index.html"), join(out, "index.html"));

const made = (await readdir(out)).sort().join(" ");
const wanted = parts
  .flatMap(({ files }) => files)
  .sort()
  .join(" ");
if (made !== wanted) throw new Error(`the bundle is ${made}, not ${wanted}`);

for (const { name, budget, files } of parts) {
  let total = 0;
  for (const file of files) {
    const bytes = await readFile(join(out, file));
    const packed = gzipSync(bytes, { level: 9 }).length;
    total += packed;
    console.log(`${file.padEnd(12)} ${String(bytes.length).padStart(7)} bytes  ${String(packed).padStart(6)} gzip`);
  }
  console.log(`${name.padEnd(12)} ${" ".repeat(14)} ${String(total).padStart(6)} gzip of ${budget}`);
  if (total > budget) {
    console.error("The page is larger than its budget.");
    process.exitCode = 1;
  }
}
