// Bundles the page into dist/: index.html, page.js, page.css. Fails when it outgrows its budget.
import { build } from "esbuild";
import { copyFile, mkdir, readFile, rm } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const budget = 60_000; // bytes, gzip, all files together
const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "dist");

// Ways of drawing that the page has no use for, and that nothing else in uPlot needs.
const unused = [
  "(paths.stepped = stepped);",
  "(paths.bars    = bars);",
  "(paths.spline  = monotoneCubic);",
  "uPlot.join = join;",
  "uPlot.tzDate  = tzDate;",
  "uPlot.rangeAsinh = rangeAsinh;",
  "uPlot.assign = assign;",
  "uPlot.fmtNum = fmtNum;",
  "uPlot.orient   = orient;",
  "uPlot.fmtDate = fmtDate;",
  "uPlot.addGap = addGap;",
  "uPlot.clipGaps = clipGaps;",
];
const slimPlots = {
  name: "slim-plots",
  setup(bundler) {
    bundler.onLoad({ filter: /uPlot\.esm\.js$/ }, async ({ path }) => {
      let contents = await readFile(path, "utf8");
      for (const line of unused) {
        if (!contents.includes(line)) throw new Error(`uPlot has changed: no "${line}"`);
        contents = contents.replace(line, "");
      }
      return { contents };
    });
  },
};

await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });
await build({
  entryPoints: { page: join(here, "src/main.ts") },
  outdir: out,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2022"],
  charset: "utf8",
  legalComments: "none",
  logLevel: "warning",
  mangleProps: /[a-z]_$/, // private members
  plugins: [slimPlots],
});
await copyFile(join(here, "src/index.html"), join(out, "index.html"));

let total = 0;
for (const name of ["index.html", "page.js", "page.css"]) {
  const bytes = await readFile(join(out, name));
  const packed = gzipSync(bytes, { level: 9 }).length;
  total += packed;
  console.log(`${name.padEnd(12)} ${String(bytes.length).padStart(7)} bytes  ${String(packed).padStart(6)} gzip`);
}
console.log(`${"all".padEnd(12)} ${" ".repeat(14)} ${String(total).padStart(6)} gzip of ${budget}`);
if (total > budget) {
  console.error("The page is larger than its budget.");
  process.exit(1);
}
