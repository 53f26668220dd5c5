/**
 * What the page can do without at first: every view but the response, with its line plots,
 * the sheet of keys, the tour.
 */
import { Energy } from "./energy.ts";
import { Help } from "./help.ts";
import { LibraryView } from "./library.ts";
import { Listen } from "./listen.ts";
import { Modes } from "./modes.ts";
import { Quiet } from "./quiet.ts";
import { Spectra } from "./spectra.ts";
import type { Store } from "./store.ts";
import { Tour } from "./tour.ts";
import type { Start } from "./types.ts";
import type { Parts } from "./views.ts";

export function viewsOf(store: Store, start: Start): Parts {
  return {
    spectra: new Spectra(),
    modes: new Modes(start),
    energy: new Energy(),
    listen: new Listen(store, start),
    quiet: new Quiet(store, start),
    library: new LibraryView(store),
  };
}

/** The tour, not yet begun. */
export function tour(store: Store): Tour {
  const made = new Tour(store);
  document.body.append(made.element);
  return made;
}

let sheet: Help | null = null;

/** Opens or closes the sheet of keys. */
export function help(): void {
  if (!sheet) {
    sheet = new Help();
    document.body.append(sheet.element);
  }
  sheet.toggle();
}
