/**
 * What the page can do without at first: every view but the response, with its line plots,
 * the sheet of keys, the ways out, the tour.
 */
import type { Start } from "./data/types.ts";
import type { Store } from "./state/store.ts";
import style from "./style/later.css" with { type: "text" };
import { Energy } from "./views/energy.ts";
import { Friction } from "./views/friction.ts";
import { Help } from "./views/help.ts";
import { LibraryView } from "./views/library.ts";
import { Listen } from "./views/listen.ts";
import { Modes } from "./views/modes.ts";
import type { Chart } from "./views/chart.ts";
import { Quiet } from "./views/quiet.ts";
import { Spectra } from "./views/spectra.ts";
import { Share } from "./views/share.ts";
import { Tour } from "./views/tour.ts";
import type { LaterParts } from "./views/views.ts";

const sheet = new CSSStyleSheet();
sheet.replaceSync(style);
document.adoptedStyleSheets.push(sheet);

export function viewsOf(store: Store, start: Start): LaterParts {
  return {
    spectra: new Spectra(),
    modes: new Modes(start),
    energy: new Energy(),
    friction: new Friction(store),
    listen: new Listen(store, start),
    quiet: new Quiet(store, start),
    library: new LibraryView(store),
  };
}

/** The ways out of the page. */
export function share(store: Store, start: Start, chart: Chart): HTMLElement {
  return new Share(store, start, chart).element;
}

/** The tour, not yet begun. */
export function tour(store: Store): Tour {
  const made = new Tour(store);
  document.body.append(made.element);
  return made;
}

let keys: Help | null = null;

/** Opens or closes the sheet of keys. */
export function help({ presets }: Start): void {
  if (!keys) {
    keys = new Help(presets.map(({ name }) => name));
    document.body.append(keys.element);
  }
  keys.toggle();
}
export { beginAt } from "./views/own_start.ts";
export { paintStructure } from "./draw/structure_drawing.ts";
