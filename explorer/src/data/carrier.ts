/** How questions reach the program: over HTTP to `stridor explore`, or to a module inside a page in one file. */

export type Carrier = (path: string, init: RequestInit) => Promise<Response>;

/** A page in one file, without a program behind it. */
export interface OneFile {
  carry: Carrier;
  /** The bytes of the file with this case (TOML) in it. */
  saved(toml: string): Uint8Array<ArrayBuffer>;
  /** Begins anew with a case (TOML) and the files that it names, or hears recordings; fails with what is wrong. */
  open(files: readonly File[]): Promise<void>;
  /** The name of a recording that was opened; empty: there is none of this number. */
  recording(number: number): string;
}

let inside: OneFile | null = null;

/** From now on questions go to what the page holds itself. */
export function carryInside(file: OneFile): void {
  inside = file;
}

/** The file that this page is; null: a program serves it. */
export function oneFile(): OneFile | null {
  return inside;
}

/** The answer to a question, as `fetch` gives it. */
export function carry(path: string, init: RequestInit): Promise<Response> {
  return inside ? inside.carry(path, init) : fetch(path, { credentials: "same-origin", ...init });
}
