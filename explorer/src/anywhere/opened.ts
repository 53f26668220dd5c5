/** A case with the files beside it, as a text: of one without files the TOML, as a string of JSON. */

import { isZip, unzipped } from "./zip.ts";

export interface Opened {
  toml: string;
  /** By name; base64. Those of an archive have its name before theirs: "k.npz/data.npy". */
  files: Record<string, string>;
}

const largest = 4.5e6 * 0.7; // [bytes]: a browser keeps some 5 MB of letters for a tab
const tooLarge = "These files are too large for the page (3 MB in all, unpacked). Open them with stridor explore.";

export function openedIn(text: string): Opened {
  const held = JSON.parse(text) as string | Opened;
  return typeof held === "string" ? { toml: held, files: {} } : held;
}

export function textOf({ toml, files }: Opened): string {
  return JSON.stringify(Object.keys(files).length > 0 ? { toml, files } : toml);
}

/** The same design with the files alone that its case still names: the numbers of others stand in it. */
export function withNamedFiles({ toml, files }: Opened): Opened {
  return {
    toml,
    files: Object.fromEntries(Object.entries(files).filter(([name]) => toml.includes(name.split("/", 1)[0] as string))),
  };
}

/** The bytes of a file that is held as base64. */
export function bytesOfText(content: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
}

function contentOf(bytes: Uint8Array): string {
  let letters = "";
  const part = 32_768; // [1] arguments of a call
  for (let at = 0; at < bytes.length; at += part) letters += String.fromCharCode(...bytes.subarray(at, at + part));
  return btoa(letters);
}

/** A file by its name, and what an archive holds behind its first bytes, which tell that it is one. */
export async function unpacked(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<[string, Uint8Array][]> {
  if (!isZip(bytes)) return [[name, bytes]];
  try {
    const held = [...(await unzipped(bytes, largest))];
    return [
      [name, bytes.subarray(0, 4)],
      ...held.map(([each, content]) => [`${name}/${each}`, content] as [string, Uint8Array]),
    ];
  } catch (error) {
    const isLarge = error instanceof Error && error.message === "too large";
    throw new Error(isLarge ? tooLarge : `${name} is no whole zip archive. Write it anew, or use stridor explore.`);
  }
}

/** What was chosen or dropped together: one case, and the files beside it. */
export async function chosen(files: readonly File[]): Promise<Opened> {
  const isCase = ({ name }: File): boolean => /\.toml$/i.test(name);
  if (files.reduce((sum, { size }) => sum + size, 0) > largest) throw new Error(tooLarge);
  const opened: Opened = { toml: "", files: {} };
  let cases = files.filter(isCase);
  // a file of pairs of materials stands beside a case
  if (cases.length > 1) {
    const texts = await Promise.all(cases.map((file) => file.text()));
    cases = cases.filter(({ name }) => !texts.some((text) => text.includes(name)));
  }
  const [only] = cases;
  if (!only || cases.length > 1)
    throw new Error(
      only
        ? "These are several cases. Choose one, with the files that it names."
        : "There is no case (.toml) among these files. Choose it together with them.",
    );
  opened.toml = await only.text();
  let whole = only.size;
  for (const file of files.filter((each) => each !== only))
    for (const [name, bytes] of await unpacked(file.name, new Uint8Array(await file.arrayBuffer()))) {
      whole += bytes.length;
      if (whole > largest) throw new Error(tooLarge);
      opened.files[name] = contentOf(bytes);
    }
  return opened;
}
