/** What the file of the page holds besides the page: the core, the workers' script, and perhaps a case. */

import { noWorkers } from "./pool.ts";
import { hasAddress, keptInTab, write } from "../state/place.ts";

const openedKept = "stridor-opened"; // in the session's storage: a case that was opened in the page

let whole: Element | null = null;

/** The file as it was when it was first asked for, whatever the page changes. */
function file(): Element {
  return (whole ??= document.documentElement.cloneNode(true) as Element);
}

/** The text of an inert element of the file. */
function partOf(id: string): string {
  return file().querySelector(`#${id}`)?.textContent ?? "";
}

function caseInFile(): string | null {
  const text = partOf("stridor-case").trim();
  return text === "" || text === "null" ? null : text;
}

/** The case to begin with (opened.ts): what was opened in this tab, or what is in the file; null: the paper's cases. */
export function caseToBegin(): string | null {
  const opened = hasAddress ? keptInTab.get(openedKept) : null; // the tab of a frame is another page's
  return opened ?? caseInFile();
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

/** The whole text of the file. */
export function textOfFile(): string {
  return `<!doctype html>\n${file().outerHTML}\n`;
}

/** The bytes of the letters in the file's encoding, windows-1252; of others that of "?". */
const byteOf = new Uint8Array(0x10000).fill(63);
const letters = new TextDecoder("windows-1252").decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
for (let byte = 0; byte < letters.length; ++byte) byteOf[letters.charCodeAt(byte)] = byte;

/** The text of the file with another text in one of its inert elements, if it has that one. */
function withPart(file: string, id: string, text: string): string {
  const place = file.indexOf(`id="${id}"`);
  if (place < 0) return file;
  const from = file.indexOf(">", place) + 1;
  return file.slice(0, from) + text + file.slice(file.indexOf("</script>", from));
}

/** The bytes of the file with a case (opened.ts) in it; no text ends the element that holds it. */
export function fileWithCase(file: string, opened: string): Uint8Array<ArrayBuffer> {
  const json = opened.replace(
    /[<\u0080-\uffff]/g,
    (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, "0")}`,
  );
  const text = withPart(withPart(file, "stridor-case", json), "stridor-first", ""); // its answers are of another case
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

function unpacked(id: string, format: CompressionFormat): ReadableStream<Uint8Array<ArrayBuffer>> {
  return new Blob([bytesOf(partOf(id))]).stream().pipeThrough(new DecompressionStream(format));
}

/** The core, compiled. */
export async function compiledCore(): Promise<WebAssembly.Module> {
  const headers = { "Content-Type": "application/wasm" };
  return WebAssembly.compileStreaming(new Response(unpacked("stridor-core", "gzip"), { headers }));
}

/** A value with the keys of each object in their alphabet: what says the same has the same text. */
function sorted(value: unknown): unknown {
  if (typeof value !== "object" || value === null || Array.isArray(value)) return value;
  return Object.fromEntries(
    Object.entries(value)
      .sort(([one], [other]) => (one < other ? -1 : 1))
      .map(([key, held]) => [key, sorted(held)]),
  );
}

/** What the program that wrote the file answered beforehand. */
export class FirstAnswers {
  private constructor(private readonly known_: ReadonlyMap<string, string>) {}

  /** Of another case than the file's: none. */
  static async read(opened: string | null): Promise<FirstAnswers> {
    if (partOf("stridor-first") === "" || opened !== caseInFile()) return new FirstAnswers(new Map());
    const text = await new Response(unpacked("stridor-first", "deflate-raw")).text();
    const all = JSON.parse(text) as { path: string; body: unknown; answer: string }[];
    return new FirstAnswers(new Map(all.map(({ path, body, answer }) => [FirstAnswers.key_(path, body), answer])));
  }

  /** The answer to a question; null: it must be asked. */
  to(path: string, body: unknown): string | null {
    const isJson = typeof body === "string" && body.startsWith("{");
    return this.known_.get(FirstAnswers.key_(path, isJson ? JSON.parse(body) : "")) ?? null;
  }

  private static key_(path: string, body: unknown): string {
    return path + JSON.stringify(sorted(body));
  }
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
