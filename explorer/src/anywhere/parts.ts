/** What the file of the page holds besides the page: the core, the workers' script, and perhaps a case. */

import { noWorkers } from "./pool.ts";
import { hasAddress, keptInTab, write } from "../state/place.ts";

const openedKept = "stridor-opened"; // in the session's storage: a case that was opened in the page

/** The text of an inert element of the file. */
function partOf(id: string): string {
  return document.getElementById(id)?.textContent ?? "";
}

/** The case to begin with (opened.ts): what was opened in this tab, or what is in the file; null: the paper's cases. */
export function caseToBegin(): string | null {
  const opened = hasAddress ? keptInTab.get(openedKept) : null; // the tab of a frame is another page's
  if (opened !== null) return opened;
  const text = partOf("stridor-case").trim();
  return text === "" || text === "null" ? null : text;
}

/** Loads the page anew with another case (opened.ts). */
export function beginAnew(opened: string): void {
  if (!hasAddress)
    throw new Error("In a frame the page keeps its case. Save this page, and open the case in the file.");
  try {
    keptInTab.set(openedKept, opened);
  } catch {
    throw new Error("This case is too large for the page (a browser keeps some 5 MB). Open it with stridor explore.");
  }
  write("#", "replace");
  location.reload();
}

/** Gives the whole text of the file as it stands now, whatever the page changes until it is wanted. */
export function textOfFile(): () => string {
  const whole = document.documentElement.cloneNode(true) as Element;
  return () => `<!doctype html>\n${whole.outerHTML}\n`;
}

/** The bytes of the letters in the file's encoding, windows-1252; of others that of "?". */
const byteOf = new Uint8Array(0x10000).fill(63);
const letters = new TextDecoder("windows-1252").decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
for (let byte = 0; byte < letters.length; ++byte) byteOf[letters.charCodeAt(byte)] = byte;

/** The bytes of the file with a case (opened.ts) in it; no text ends the element that holds it. */
export function fileWithCase(file: string, opened: string): Uint8Array<ArrayBuffer> {
  const begin = '<script type="application/json" id="stridor-case">';
  const from = file.indexOf(begin) + begin.length;
  const to = file.indexOf("</script>", from);
  const json = opened.replace(
    /[<\u0080-\uffff]/g,
    (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, "0")}`,
  );
  const text = file.slice(0, from) + json + file.slice(to);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = byteOf[text.charCodeAt(k)] as number;
  return bytes;
}

const escape = "=".charCodeAt(0);

/** The bytes that build_page.mjs wrote as letters: `=` and another letter are one that HTML would change. */
export function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(text.length);
  let length = 0;
  for (let k = 0; k < text.length; ++k) {
    const isEscaped = text.charCodeAt(k) === escape;
    if (isEscaped) ++k;
    bytes[length++] = (byteOf[text.charCodeAt(k)] as number) - (isEscaped ? 64 : 0);
  }
  return bytes.subarray(0, length);
}

/** The core, compiled. */
export async function compiledCore(): Promise<WebAssembly.Module> {
  const packed = new Blob([bytesOf(partOf("stridor-core"))]);
  const unpacked = packed.stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(unpacked, { headers: { "Content-Type": "application/wasm" } }));
}

/** Makes workers that run the script in the file; the first ones, so many, load while the core is unpacked. */
export function workerMaker(first: number): () => Worker {
  const url = URL.createObjectURL(new Blob([partOf("stridor-worker")], { type: "text/javascript" }));
  const made = (): Worker => {
    try {
      return new Worker(url);
    } catch {
      throw new Error(noWorkers);
    }
  };
  const waiting = new Set(Array.from({ length: first }, made));
  // one that fails before anybody asks it is made anew for who asks, and tells him why
  for (const worker of waiting) worker.onerror = () => waiting.delete(worker);
  return () => {
    const [worker] = waiting;
    if (!worker) return made();
    waiting.delete(worker);
    return worker;
  };
}
