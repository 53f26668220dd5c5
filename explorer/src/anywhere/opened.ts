/** A case with the files beside it, as a text: of one without files the TOML, as a string of JSON. */

export interface Opened {
  toml: string;
  /** By name; base64. */
  files: Record<string, string>;
}

const largest = 4.5e6; // [letters]: a browser keeps some 5 MB for a tab

export function openedIn(text: string): Opened {
  const held = JSON.parse(text) as string | Opened;
  return typeof held === "string" ? { toml: held, files: {} } : held;
}

export function textOf({ toml, files }: Opened): string {
  return JSON.stringify(Object.keys(files).length > 0 ? { toml, files } : toml);
}

/** The same design with the files alone that its case still names: the numbers of others stand in it. */
export function withNamedFiles({ toml, files }: Opened): Opened {
  return { toml, files: Object.fromEntries(Object.entries(files).filter(([name]) => toml.includes(name))) };
}

/** The bytes of a file that is held as base64. */
export function bytesOfText(content: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
}

async function contentOf(file: Blob): Promise<string> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let letters = "";
  const part = 32_768; // [1] arguments of a call
  for (let at = 0; at < bytes.length; at += part) letters += String.fromCharCode(...bytes.subarray(at, at + part));
  return btoa(letters);
}

/** What was chosen or dropped together: one case, and the files beside it. */
export async function chosen(files: readonly File[]): Promise<Opened> {
  const isCase = ({ name }: File): boolean => /\.toml$/i.test(name);
  const whole = files.reduce((sum, { size }) => sum + size, 0);
  if (whole > largest * 0.7)
    throw new Error("These files are too large for the page (3 MB in all). Open them with stridor explore.");
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
  for (const file of files) if (file !== only) opened.files[file.name] = await contentOf(file);
  return opened;
}
