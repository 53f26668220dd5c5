/** One sound: a player, its spectrogram and what is heard in it. It never starts by itself. */
import * as api from "../data/api.ts";
import type { Analysis, SoundOptions } from "../data/answer_types.ts";
import { h, setText } from "../draw/dom.ts";
import { Spectrogram } from "../draw/spectrogram.ts";
import type { Design } from "../state/state.ts";
import { Asked } from "./asked.ts";

/** What can be heard: a simulated design, or a recording of the library. */
export type Source = { design: Design; options: SoundOptions } | { library: number };

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
  private readonly spectrogram_: Spectrogram;
  private readonly asked_ = new Asked<Source, Heard>(hear, (heard) => this.take_(heard), "Rendering …");

  constructor(private readonly name_: string) {
    this.audio = h("audio", {
      "controls": true,
      "preload": "auto",
      "id": `audio-${name_}`,
      "aria-label": `Sound ${name}`,
    });
    this.spectrogram_ = new Spectrogram(`Spectrogram of ${name_}`);
    this.element = h(
      "div",
      { "class": "card slot", "data-slot": name_ },
      this.heading_,
      this.audio,
      this.verdict_,
      this.asked_.note,
      this.spectrogram_.element,
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
    const { category, reasons } = analysis.verdict;
    setText(this.verdict_, `by ear: ${category ?? "unknown"}${reasons.length ? ` (${reasons.join("; ")})` : ""}`);
    this.spectrogram_.show(analysis.spectrogram, `${this.name_}, ${this.heading_.textContent ?? ""}`);
  }
}
