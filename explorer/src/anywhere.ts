/** The page in one file: the program's answers come from a module inside it, and nothing leaves the machine. */
import { beginAnew, caseToBegin, compiledCore, fileWithCase, textOfFile, workerMaker } from "./anywhere/parts.ts";
import { Pool } from "./anywhere/pool.ts";
import { openable } from "./data/api.ts";
import { carryInside } from "./data/carrier.ts";

const fewest = 2; // workers: a chart does not keep a verdict waiting

/** What is missing here to run the page, in a sentence; empty: nothing. */
function missing(): string {
  if (typeof WebAssembly === "undefined")
    return "This browser runs no WebAssembly (it is switched off, or the browser is old). Open the file in another?";
  if (typeof Worker === "undefined" || typeof DecompressionStream === "undefined")
    return "This browser is too old for the page. Open the file in Firefox 113, Chrome 103, Safari 16.4 or later.";
  return "";
}

async function begin(): Promise<void> {
  const problem = missing();
  if (problem) throw new Error(problem);
  const file = textOfFile();
  const module = await compiledCore();
  const most = Math.max(fewest, navigator.hardwareConcurrency || fewest);
  const opened = caseToBegin();
  const pool = new Pool(workerMaker(), { module, opened }, most);
  carryInside({
    // a case that cannot be opened says why in place of the page
    carry: (path, init) =>
      path === "/api/start" && opened !== null ? pool.carry("/api/open", { body: opened }) : pool.carry(path, init),
    saved: (toml) => fileWithCase(file, toml),
    async open(toml) {
      await openable(toml);
      beginAnew(toml);
    },
  });
  await import("./main.ts");
}

begin().catch((error: unknown) => {
  const said = document.createElement("p");
  said.className = "complaint";
  said.setAttribute("role", "alert");
  said.textContent = error instanceof Error ? error.message : String(error);
  document.body.replaceChildren(said);
});
