/** The page in one file: the program's answers come from a module inside it, and nothing leaves the machine. */
import {
  beginAnew,
  caseToBegin,
  compiledCore,
  fileWithCase,
  FirstAnswers,
  textOfFile,
  workerMaker,
} from "./anywhere/parts.ts";
import { chosen, openedIn, textOf, withNamedFiles } from "./anywhere/opened.ts";
import { Pool } from "./anywhere/pool.ts";
import { Recordings } from "./anywhere/recordings.ts";
import { openable, sentence } from "./data/api.ts";
import { carryInside } from "./data/carrier.ts";
import { fragment, hasAddress, visit } from "./state/place.ts";
import { body, designIn, ownPreset, paperPreset } from "./state/state.ts";

const fewest = 2; // workers: a chart does not keep a verdict waiting

/** What is missing here to run the page, in a sentence; empty: nothing. */
function missing(): string {
  if (typeof WebAssembly === "undefined")
    return "This browser runs no WebAssembly (it is switched off, or the browser is old). Open the file in another?";
  if (typeof Worker === "undefined" || typeof DecompressionStream === "undefined")
    return "This browser is too old for the page. Open the file in Firefox 113, Chrome 103, Safari 16.4 or later.";
  return "";
}

const recordings = new Recordings();

/** A case begins the page anew; recordings are heard as B. */
async function open(files: readonly File[]): Promise<void> {
  if (Recordings.are(files)) {
    const number = await recordings.take(files);
    visit(`${fragment().replace(/&(view|other)=[^&]*/g, "")}&view=listen&other=library:${number}`);
    return;
  }
  const text = textOf(await chosen(files));
  await openable(text);
  beginAnew(text);
}

/** Opens what is dropped anywhere on the page; without this the browser would leave the page for it. */
function takeDrops(): void {
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length === 0) return;
    open(files).catch((error: unknown) => {
      const said = document.querySelector<HTMLElement>("#complaint");
      said?.replaceChildren(sentence(error));
      if (said) said.hidden = false;
    });
  });
}

/** A frame in a report that is closed, or far down a notebook, costs nothing before somebody sees it. */
function seen(): Promise<void> {
  if (hasAddress) return Promise.resolve();
  return new Promise((take) => {
    const watcher = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      watcher.disconnect();
      take();
    });
    watcher.observe(document.documentElement);
  });
}

/** Workers with the core. */
async function poolOf(opened: string | null): Promise<Pool> {
  const pool = new Pool(workerMaker(), Math.max(fewest, navigator.hardwareConcurrency || fewest));
  pool.prepare(fewest);
  const module = await compiledCore().catch((error: unknown) => {
    if (!/memory/i.test(sentence(error))) throw error;
    throw new Error("The browser gives this page no memory for the program in it. Close other tabs and reload it.");
  });
  pool.begin({ module, opened });
  return pool;
}

/** Says in place of the page why there is none. */
function giveUp(error: unknown): void {
  const said = document.createElement("p");
  said.className = "complaint";
  said.setAttribute("role", "alert");
  said.textContent = sentence(error);
  document.body.replaceChildren(said);
}

/** An answer that is known: a browser would read its text behind its first layout, 0.1 s later. */
function atHand(text: string): Response {
  return Object.assign(new Response(text), { json: async (): Promise<unknown> => JSON.parse(text) });
}

async function begin(): Promise<void> {
  const problem = missing();
  if (problem) throw new Error(problem);
  await seen();
  const opened = caseToBegin();
  const known = await FirstAnswers.read(opened);
  let pool: Promise<Pool> | null = null; // begins with the first question that is not known: a core takes both hands
  let hasCore = true; // or it is still on its way
  const ask = async (...asked: Parameters<Pool["carry"]>): Promise<Response> => {
    pool ??= poolOf(opened).catch((error: unknown) => {
      hasCore = false;
      giveUp(error);
      throw error;
    });
    return (await pool).carry(...asked);
  };
  const judged = JSON.stringify(body(designIn(fragment(), opened === null ? paperPreset : ownPreset)));
  let early: Promise<Response> | null = null; // while the page is laid out
  if (known.to("/api/simulate", judged) === null) early = ask("/api/simulate", { body: judged });
  early?.catch(() => {}); // told when it is asked for
  carryInside({
    carry(path, init) {
      const told = hasCore ? known.to(path, init.body) : null;
      if (told !== null) return Promise.resolve(atHand(told));
      if (path === "/api/simulate" && init.body === judged && early) {
        const answer = early;
        early = null;
        return answer;
      }
      // a case that cannot be opened says why in place of the page
      if (path === "/api/start" && opened !== null) return ask("/api/open", { body: opened });
      if (path === "/api/recording")
        return ask(path, { ...init, body: "microphone.wav" }, init.body as Uint8Array<ArrayBuffer>);
      const [, number, what] = /^\/api\/library\/(\d+)\/(audio|analysis)$/.exec(path) ?? [];
      const recording = recordings.at(Number(number));
      if (!recording) return ask(path, init);
      if (what === "audio") return Promise.resolve(new Response(recording.file));
      return ask("/api/recording", { ...init, body: recording.name }, recording.bytes);
    },
    recording: (number) => recordings.at(number)?.name ?? "",
    saved: (toml) => {
      const files = opened === null ? {} : openedIn(opened).files;
      return fileWithCase(textOfFile(), textOf(withNamedFiles({ toml, files })));
    },
    open,
  });
  takeDrops();
  await import("./main.ts");
}

begin().catch(giveUp);
