/**
 * The page's place in the browser: the fragment of its address, and what the browser keeps for it. A frame that another
 * page fills (a notebook's cell, a report) has no address of its own, and may have no storage: both are then variables.
 */

/** Whether a link can lead here. */
export const hasAddress = globalThis.location?.protocol !== "about:";

let ownFragment = "";
let visited: () => void = () => {};

/** The fragment with its "#", or nothing. */
export function fragment(): string {
  return hasAddress ? location.hash : ownFragment;
}

/** Writes the fragment; `push`: "back" undoes it, but not in a frame, where "back" is of the page around it. */
export function write(link: string, step: "push" | "replace"): void {
  if (!hasAddress) ownFragment = link;
  else if (step === "replace") history.replaceState(null, "", link);
  else if (link !== location.hash) history.pushState(null, "", link);
}

/** Goes where a link leads; who listens hears of it. */
export function visit(link: string): void {
  if (hasAddress) {
    location.hash = link;
    return;
  }
  ownFragment = link;
  visited();
}

/** Hears of each fragment that the page did not write itself. */
export function onVisit(heard: () => void): void {
  visited = heard;
  addEventListener("popstate", heard);
}

/** What the browser keeps under names; a frame with another site's rights keeps it as long as it stands. */
export interface Kept {
  get(name: string): string | null;
  set(name: string, text: string): void;
}

function keptIn(storage: () => Storage): Kept {
  try {
    const found = storage();
    return { get: (name) => found.getItem(name), set: (name, text) => found.setItem(name, text) };
  } catch {
    const own = new Map<string, string>();
    return { get: (name) => own.get(name) ?? null, set: (name, text) => void own.set(name, text) };
  }
}

/** For ever, and for the session of this tab. */
export const [kept, keptInTab] = [keptIn(() => localStorage), keptIn(() => sessionStorage)];
