/** Hear the cell, and beside it another cell that was kept, or a recording of the library. */
import * as api from "../data/api.ts";
import type { LibraryEntry } from "../data/answer_types.ts";
import { oneFile } from "../data/carrier.ts";
import type { Start } from "../data/types.ts";
import { button, h, select, setOptions, setText } from "../draw/dom.ts";
import { quantity, symbolText } from "../draw/format.ts";
import type { Direction } from "../program/words.ts";
import type { Design, Other } from "../state/state.ts";
import type { Store } from "../state/store.ts";
import { byEar, SoundSlot } from "./sound_slot.ts";
import type { Microphone } from "./microphone.ts";
import { Spectrogram } from "../draw/spectrogram.ts";
import { SoundPicker } from "./spectra.ts";
import type { Context, ViewPart } from "./views.ts";

export class Listen implements ViewPart {
  readonly element: HTMLElement;
  private readonly a_ = new SoundSlot("A");
  private readonly b_ = new SoundSlot("B");
  private readonly picker_ = new SoundPicker(() => this.last_ && this.show(this.last_));
  private readonly hint_ = h(
    "p",
    { class: "note" },
    "Keep this cell as B, then choose another one on the chart: A is always the chosen cell.",
  );
  private readonly flip_: HTMLButtonElement;
  private readonly recordings_: HTMLSelectElement;
  private entries_: LibraryEntry[] | null = null;
  private last_: Context | null = null;
  private microphone_: Microphone | null = null;

  constructor(
    private readonly store_: Store,
    private readonly start_: Start,
  ) {
    this.flip_ = button("A ⇄ B", () => this.switch(), {
      id: "flip",
      class: "primary",
      title: "Hear the other one from the same place on (x)",
    });
    this.recordings_ = select("Recording as B", [["", "a recording as B …"]], (id) => {
      if (id) store_.update({ other: { library: Number(id) } });
    });
    this.element = h(
      "div",
      { class: "listen" },
      h(
        "div",
        { class: "bar" },
        this.picker_.element,
        button("Keep this cell as B", () => this.keep_(), { id: "keep" }),
        start_.library ? this.recordings_ : null,
        this.flip_,
        button("Microphone", () => void this.listen_(), { id: "microphone", title: "Judge what is heard here" }),
        button("Forget B", () => store_.update({ other: null }), { id: "forget", class: "quiet" }),
      ),
      this.hint_,
      h("div", { class: "two" }, this.a_.element, this.b_.element),
    );
  }

  show(context: Context): void {
    this.last_ = context;
    const { state } = context;
    if (context.step === "drag") return;
    if (context.simulation) this.picker_.offer(context.simulation.case);
    const { options } = this.picker_;
    this.a_.show(`A: ${this.nameOf_(state.design, options.direction === "whole" ? null : options.direction)}`, {
      design: state.design,
      options,
    });
    this.showOther_(state.other);
    if (this.start_.library) void this.loadRecordings_();
  }

  hide(): void {
    this.microphone_?.stop();
    this.a_.pause();
    this.b_.pause();
  }

  /** From A to B or back, at the same place of the sound. */
  switch(): void {
    const [from, to] = this.b_.audio.paused ? [this.a_.audio, this.b_.audio] : [this.b_.audio, this.a_.audio];
    if (!to.src || this.b_.element.hidden) return;
    const place = from.currentTime;
    from.pause();
    to.currentTime = to.duration > 0 ? place % to.duration : 0;
    void to.play();
  }

  private async listen_(): Promise<void> {
    try {
      const { Microphone } = await import("./microphone.ts");
      // what it would otherwise bring along once more
      const questions = { heard: api.heard, sentence: api.sentence, isAbort: api.isAbort };
      const tools = { h, button, setText, byEar, Spectrogram, ...questions };
      this.microphone_ ??= new Microphone(tools, oneFile() ? "in this tab" : "by the stridor that serves this page");
      this.b_.element.after(this.microphone_.element);
      await this.microphone_.start();
    } catch (error) {
      setText(this.hint_, api.sentence(error));
    }
  }

  private keep_(): void {
    const { design, direction } = this.store_.state;
    this.store_.update({ other: { design, direction } });
  }

  private showOther_(other: Other | null): void {
    this.flip_.disabled = other === null;
    this.hint_.hidden = other !== null;
    if (!other) {
      this.b_.clear();
    } else if ("library" in other) {
      const entry = this.entries_?.find(({ id }) => id === other.library);
      const known = oneFile()?.recording(other.library) || (entry && describe(entry));
      this.b_.show(`B: recording ${other.library}${known ? ` (${known})` : ""}`, { library: other.library });
    } else {
      this.b_.show(`B: ${this.nameOf_(other.design, null)}`, { design: other.design, options: this.picker_.options });
    }
  }

  private nameOf_(design: Design, direction: Direction | null): string {
    const changes = Object.entries(design.set).map(([key, value]) => {
      const field = this.start_.fields.find((each) => each.key === key);
      const number = Number(value);
      const text = field?.kind === "quantity" && Number.isFinite(number) ? quantity(number, field.unit) : value;
      return `${field?.symbol ? symbolText(field.symbol) : key} = ${text}`;
    });
    return [design.preset, ...changes, direction ?? ""].filter(Boolean).join(", ");
  }

  private async loadRecordings_(): Promise<void> {
    if (this.entries_) return;
    try {
      this.entries_ = (await api.library()).entries;
      const options = this.entries_.map((entry) => [String(entry.id), `${entry.id}: ${describe(entry)}`] as const);
      setOptions(this.recordings_, [["", "a recording as B …"], ...options]);
    } catch (error) {
      setText(this.hint_, api.sentence(error));
    }
  }
}

/** A recording in a few words. */
export function describe(entry: LibraryEntry): string {
  const known = ["title", "name", "system", "denomination"]
    .map((name) => entry[name])
    .filter((value) => typeof value === "string");
  return known.join(", ") || `entry ${entry.id}`;
}
