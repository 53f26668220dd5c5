// The page in one file in Chromium, for the tests: the program writes it, a new profile opens it from the disk.
import { execFileSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";
import { openPage, program } from "../browser/session.mjs";

export { settled } from "../browser/session.mjs";

/** A case (TOML) of a kind. */
export const ready = (kind) => execFileSync(program, ["init", kind], { encoding: "utf8" });

/** Writes the page to `file`, with a case (TOML) where one is given. */
export function write(file, toml) {
  execFileSync(program, ["page", ...(toml ? ["-"] : []), "-o", file], { input: toml ?? "" });
  return file;
}

/**
 * Opens a file until the test ends, offline: what would be asked of a network fails, and is a sin.
 * `init` runs in the page before all else; what else is given are options of the browser.
 */
export async function openFile(t, file, { fragment = "", init, ...options } = {}) {
  const origin = pathToFileURL(file).href;
  const browser = await openPage({ origin, link: () => origin }, { offline: true, ...options });
  t.after(() => browser.close());
  if (init) await browser.page.addInitScript(init);
  await browser.goto(fragment);
  return browser;
}

/** The category of a direction. */
export const verdict = (page, direction = "going") => page.locator("#verdict").getAttribute(`data-${direction}`);

/** The bytes that a page hands to the browser to save, after `click`. */
export async function saved(page, click) {
  const download = page.waitForEvent("download");
  await click();
  return readFile(await (await download).path());
}

/** Lets go of files above the page, as a hand does; `files` are texts by name. */
export function drop(page, files) {
  return page.evaluate((texts) => {
    const held = new DataTransfer();
    for (const [name, text] of Object.entries(texts)) held.items.add(new File([text], name));
    const options = { dataTransfer: held, bubbles: true, cancelable: true };
    document.querySelector("main").dispatchEvent(new DragEvent("drop", options));
  }, files);
}
