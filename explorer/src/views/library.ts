/** The recordings of the library: listed, heard, seen, and put beside the simulation. */
import * as api from "../data/api.ts";
import type { Library, LibraryEntry } from "../data/answer_types.ts";
import { button, h, setText } from "../draw/dom.ts";
import { quantity, words } from "../draw/format.ts";
import { onLook, paintSwatch } from "../draw/theme.ts";
import type { Store } from "../state/store.ts";
import { Asked } from "./asked.ts";
import { describe } from "./listen.ts";
import { SoundSlot } from "./sound_slot.ts";
import type { Context, ViewPart } from "./views.ts";

const shownFields = ["file", "system", "denomination", "recorded", "preload", "velocity", "temperature", "humidity"];

export class LibraryView implements ViewPart {
  readonly element: HTMLElement;
  private readonly body_ = h("tbody");
  private readonly head_ = h("tr");
  private readonly slot_ = new SoundSlot("recording");
  private readonly search_: HTMLInputElement;
  private readonly asked_ = new Asked<null, Library>(
    (_, signal) => api.library(signal),
    () => this.list_(),
    "Opening the library …",
  );
  private chosen_: number | null = null;

  constructor(private readonly store_: Store) {
    this.search_ = h("input", {
      "type": "text",
      "placeholder": "filter",
      "aria-label": "Filter the recordings",
      "oninput": () => this.list_(),
    });
    this.slot_.clear();
    onLook(() => this.list_());
    this.element = h(
      "div",
      { class: "library" },
      h(
        "div",
        { class: "list" },
        h("div", { class: "bar" }, this.search_, this.asked_.note),
        h("table", { id: "library" }, h("thead", {}, this.head_), this.body_),
      ),
      h(
        "div",
        { class: "detail" },
        this.slot_.element,
        button("Compare with the simulation", () => this.compare_(), { id: "compare" }),
      ),
    );
  }

  show(_: Context): void {
    this.asked_.ask(null);
  }

  hide(): void {
    this.slot_.pause();
  }

  private compare_(): void {
    if (this.chosen_ !== null) this.store_.update({ other: { library: this.chosen_ }, view: "listen" });
  }

  private list_(): void {
    const library = this.asked_.answer;
    if (!library) return;
    const wanted = this.search_.value.toLowerCase();
    const entries = library.entries.filter((entry) => JSON.stringify(entry).toLowerCase().includes(wanted));
    const fields = shownFields.filter((name) => entries.some((entry) => entry[name] !== undefined));
    this.head_.replaceChildren(...["", "id", ...fields, "level"].map((name) => h("th", { scope: "col" }, words(name))));
    this.body_.replaceChildren(...entries.map((entry) => this.row_(entry, fields, library)));
    setText(this.asked_.note, `${entries.length} of ${library.entries.length} recordings`);
    const first = entries[0];
    if (this.chosen_ === null && first) this.choose_(first);
  }

  private row_(entry: LibraryEntry, fields: string[], library: Library): HTMLElement {
    const swatch = h("span", { class: "swatch", title: `by ear: ${entry.category ?? "unknown"}` });
    paintSwatch(swatch, entry.category ?? "failed");
    const cell = (name: string): HTMLElement => {
      const value = entry[name];
      const text = typeof value === "number" ? quantity(value, library.units[name] ?? "") : String(value ?? "");
      return h("td", {}, text);
    };
    const level = quantity(entry.figures?.level, library.units["figures.level"] ?? "");
    const open = button(String(entry.id), () => this.choose_(entry), {
      "class": "quiet",
      "aria-label": `Open recording ${entry.id}: ${describe(entry)}`,
    });
    return h(
      "tr",
      {
        "data-entry": entry.id,
        "aria-selected": String(entry.id === this.chosen_),
        "onclick": () => this.choose_(entry),
      },
      h("td", {}, swatch),
      h("td", {}, open),
      ...fields.map(cell),
      h("td", { class: "number" }, level),
    );
  }

  private choose_(entry: LibraryEntry): void {
    if (this.chosen_ === entry.id) return;
    this.chosen_ = entry.id;
    for (const row of this.body_.querySelectorAll<HTMLElement>("tr"))
      row.setAttribute("aria-selected", String(row.dataset.entry === String(entry.id)));
    this.slot_.show(`recording ${entry.id}: ${describe(entry)}`, { library: entry.id });
  }
}
