/** A worker of the page in one file: it answers one question after the other with a core of its own. */
import type { Begin, Letter, Question } from "./letters.ts";
import { Core, type Told } from "./module.ts";

const muchMemory = 1e9; // [bytes]: a core that has so much and fails was refused more

let core: Core | null = null;

function write(letter: Letter): void {
  const scope = self as unknown as { postMessage(letter: Letter, moved: Transferable[]): void };
  scope.postMessage(letter, letter.kind === "part" ? [letter.bytes.buffer] : []);
}

function begin({ module, opened }: Begin): Core {
  const begun = new Core(module);
  // what is wrong with the case is told when the page asks for it (/api/open)
  if (opened !== null) begun.open(opened, { head() {}, part() {} });
  return begun;
}

addEventListener("message", ({ data }: MessageEvent<Begin | Question>) => {
  try {
    if ("module" in data) {
      core = begin(data);
      return;
    }
    if (!core) throw new Error("the core has not begun");
    const { path, body, recording, shared, tasks } = data;
    const told: Told = {
      head: ({ status, type }) => write({ kind: "head", status, type }),
      part: (bytes) => write({ kind: "part", bytes }),
    };
    if (shared) core.share(path, body, shared.results, shared.helpers, told);
    else if (tasks) core.help(path, body, tasks, told);
    else if (path === "/api/open") core.open(body, told);
    else if (recording) core.hear(body, recording, told);
    else core.ask(path, body, told);
    write({ kind: "end", size: core.size });
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    write({ kind: "failed", why, lacksMemory: /memory/i.test(why) || (core?.size ?? 0) > muchMemory });
  }
});
