// Runs a program of WebAssembly in node: node run_wasi.mjs PROGRAM.wasm FOLDER-THAT-IT-READS
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";

const [program, folder] = process.argv.slice(2);
const wasi = new WASI({ version: "preview1", args: [program], preopens: { [folder]: folder } });
const module = await WebAssembly.compile(await readFile(program));
process.exitCode = wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject()));
