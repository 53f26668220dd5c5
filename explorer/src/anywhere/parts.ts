/** What the file of the page holds besides the page: the core, the workers' script, and perhaps a case. */

const openedKept = "stridor-opened"; // in the session's storage: a case that was opened in the page

/** The text of an inert element of the file. */
function partOf(id: string): string {
  return document.getElementById(id)?.textContent ?? "";
}

/** The case to begin with, as TOML: what was opened in this tab, or what is in the file; null: the paper's cases. */
export function caseToBegin(): string | null {
  const opened = sessionStorage.getItem(openedKept);
  if (opened !== null) return opened;
  const text: unknown = JSON.parse(partOf("stridor-case") || "null");
  return typeof text === "string" ? text : null;
}

/** Loads the page anew with another case. */
export function beginAnew(toml: string): void {
  try {
    sessionStorage.setItem(openedKept, toml);
  } catch {
    throw new Error("This case is too large for the page (a browser keeps some 5 MB). Open it with stridor explore.");
  }
  history.replaceState(null, "", "#");
  location.reload();
}

/** The whole text of the file; to be taken before the page changes it. */
export function textOfFile(): string {
  return `<!doctype html>\n${document.documentElement.outerHTML}\n`;
}

/** The text of the file with a case (TOML) in it; no text ends the element that holds it. */
export function fileWithCase(file: string, toml: string): string {
  const begin = '<script type="application/json" id="stridor-case">';
  const from = file.indexOf(begin) + begin.length;
  const to = file.indexOf("</script>", from);
  return file.slice(0, from) + JSON.stringify(toml).replaceAll("<", "\\u003c") + file.slice(to);
}

/** Bytes from base64, four letters for three. */
export function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const letters = atob(base64.trim());
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; ++k) bytes[k] = letters.charCodeAt(k);
  return bytes;
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
  return () => new Worker(url);
}
