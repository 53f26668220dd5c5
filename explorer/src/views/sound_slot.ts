/** One sound: a player, its spectrogram and what is heard in it. It never starts by itself. */
import * as api from "../data/api.ts";
import type { Analysis, SoundOptions } from "../data/answer_types.ts";
import { h, setText } from "../draw/dom.ts";
import { plain } from "../draw/format.ts";
import { Spectrogram } from "../draw/spectrogram.ts";
import type { Design } from "../state/state.ts";
import { Asked } from "./asked.ts";

/** What can be heard: a simulated design, or a recording of the library. */
export type Source = { design: Design; options: SoundOptions } | { library: number };

const mostTold = 3; // segments whose reasons are said

interface Heard {
  audio: Blob;
  analysis: Analysis;
}

async function hear(source: Source, signal: AbortSignal): Promise<Heard> {
  const [audio, analysis] =
    "library" in source
      ? await Promise.all([api.recording(source.library, signal), api.recordingAnalysis(source.library, signal)])
      : await Promise.all([
          api.sound(source.design, source.options, signal),
          api.analysis(source.design, source.options, signal),
        ]);
  return { audio, analysis };
}

export class SoundSlot {
  readonly element: HTMLElement;
  readonly audio: HTMLAudioElement;
  private readonly heading_ = h("h3", {});
  private readonly verdict_ = h("p", { class: "muted" });
  private readonly reasons_ = h("ul", { class: "note" });
  private readonly spectrogram_: Spectrogram;
  private readonly impulses_: Spectrogram;
  private readonly legend_ = h(
    "p",
    { class: "note" },
    "Ticks: onsets. Red: the strongest tone. Below: the loudest passage through frames of 5 ms.",
  );
  private readonly asked_ = new Asked<Source, Heard>(hear, (heard) => this.take_(heard), "Rendering …");

  constructor(private readonly name_: string) {
    this.audio = h("audio", {
      "controls": true,
      "preload": "auto",
      "id": `audio-${name_}`,
      "aria-label": `Sound ${name}`,
    });
    this.spectrogram_ = new Spectrogram(`Spectrogram of ${name_}`);
    this.impulses_ = new Spectrogram(`The loudest passage of ${name_} through frames of 5 ms`);
    this.legend_.hidden = this.impulses_.element.hidden = true;
    this.element = h(
      "div",
      { "class": "card slot", "data-slot": name_ },
      this.heading_,
      this.audio,
      this.verdict_,
      this.reasons_,
      this.asked_.note,
      this.spectrogram_.element,
      this.legend_,
      this.impulses_.element,
    );
  }

  show(title: string, source: Source): void {
    setText(this.heading_, title);
    this.element.hidden = false;
    this.asked_.ask(source);
  }

  clear(): void {
    this.element.hidden = true;
    this.audio.pause();
    this.asked_.forget();
  }

  pause(): void {
    this.audio.pause();
  }

  private take_({ audio, analysis }: Heard): void {
    const playing = !this.audio.paused;
    if (this.audio.src) URL.revokeObjectURL(this.audio.src);
    this.audio.src = URL.createObjectURL(audio);
    this.element.dataset.bytes = String(audio.size);
    if (playing) void this.audio.play();
    this.judge_(analysis.verdict);
    const title = `${this.name_}, ${this.heading_.textContent ?? ""}`;
    const { impulses, tracks, verdict } = analysis;
    this.spectrogram_.show(analysis.spectrogram, title, { ...tracks, segments: verdict.segments });
    this.legend_.hidden = this.impulses_.element.hidden = impulses === null;
    // the pitch is drawn where it can be told, over the long frames
    if (impulses)
      this.impulses_.show(impulses, `${title}, the loudest passage through frames of 5 ms`, {
        onsets: tracks.onsets,
        segments: verdict.segments,
      });
  }

  private judge_(verdict: Analysis["verdict"]): void {
    const { category, probability, segments } = verdict;
    setText(this.verdict_, byEar(verdict));
    const told = probability === null ? [] : segments.filter((each) => each.category === category).slice(0, mostTold);
    this.reasons_.replaceChildren(
      ...told.map(({ from, to, reasons: why }) =>
        h("li", {}, `${plain(from, 3)} to ${plain(to, 3)} s: ${why.join("; ")}`),
      ),
    );
    this.reasons_.hidden = told.length === 0;
  }
}

/** A verdict on a sound, and why. */
export function byEar({ category, reasons }: Analysis["verdict"]): string {
  return `by ear: ${category}${reasons.length ? ` (${reasons.join("; ")})` : ""}`;
}
