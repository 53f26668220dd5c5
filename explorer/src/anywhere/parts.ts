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

/** The whole text of the file; to be taken before the page changes it. */
export function textOfFile(): string {
  return `<!doctype html>\n${document.documentElement.outerHTML}\n`;
}

/** The letters of the file's encoding, windows-1252, in which each byte is one. */
const letters = new TextDecoder("windows-1252").decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
const byteOf = new Map([...letters].map((letter, byte) => [letter, byte]));

/** The bytes of the file with a case (opened.ts) in it; no text ends the element that holds it. */
export function fileWithCase(file: string, opened: string): Uint8Array<ArrayBuffer> {
  const begin = '<script type="application/json" id="stridor-case">';
  const from = file.indexOf(begin) + begin.length;
  const to = file.indexOf("</script>", from);
  const json = opened.replace(
    /[<\u0080-\uffff]/g,
    (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, "0")}`,
  );
  return Uint8Array.from(file.slice(0, from) + json + file.slice(to), (letter) => byteOf.get(letter) ?? 63);
}

/** The bytes that build_page.mjs wrote as letters: `=` and another letter are one that HTML would change. */
export function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(text.length);
  let length = 0;
  for (let k = 0; k < text.length; ++k) {
    const isEscaped = text[k] === "=";
    if (isEscaped) ++k;
    bytes[length++] = (byteOf.get(text[k] as string) as number) - (isEscaped ? 64 : 0);
  }
  return bytes.subarray(0, length);
}

/** The core, compiled. */
export async function compiledCore(): Promise<WebAssembly.Module> {
  const packed = new Blob([bytesOf(partOf("stridor-core"))]);
  const unpacked = packed.stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

/** Makes workers that run the script in the file. */
export function workerMaker(): () => Worker {
  const url = URL.createObjectURL(new Blob([partOf("stridor-worker")], { type: "text/javascript" }));
  return () => {
    try {
      return new Worker(url);
    } catch {
      throw new Error(noWorkers);
    }
  };
}
