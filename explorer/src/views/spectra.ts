/** What the motion sounds like, seen: spectrum, spectrogram and level of one direction. */
import * as api from "../data/api.ts";
import { heardIn } from "../data/cases.ts";
import { nearestPeak, peaksOf, type Peak } from "../data/peaks.ts";
import type { Analysis, ModalLines, SoundOptions } from "../data/answer_types.ts";
import type { Case } from "../data/types.ts";
import { h, select, setOptions, setText } from "../draw/dom.ts";
import { inRow, percent, plain, quantity, unitText } from "../draw/format.ts";
import { Plot } from "../draw/plot.ts";
import { Spectrogram } from "../draw/spectrogram.ts";
import type { Design } from "../state/state.ts";
import { Asked } from "./asked.ts";
import type { Context, ViewPart } from "./views.ts";

export const soundDefaults: SoundOptions = {
  direction: "whole",
  of: "joint",
  quantity: "velocity",
  rate: 48000,
  seconds: 2,
};

/** Which of the motion is looked at or heard; the direction goes with the page's. */
export class SoundPicker {
  readonly element: HTMLElement;
  options: SoundOptions = { ...soundDefaults };
  private readonly of_: HTMLSelectElement;

  constructor(changed: () => void) {
    const pick = <Key extends "of" | "quantity" | "direction">(
      key: Key,
      label: string,
      values: SoundOptions[Key][],
    ): HTMLSelectElement =>
      select(
        label,
        values.map((value) => [value, value]),
        (value) => {
          this.options = { ...this.options, [key]: value };
          changed();
        },
        { "data-sound": key },
      );
    this.of_ = pick("of", "Which part", ["joint", "plate"]);
    this.element = h(
      "span",
      { class: "bar" },
      this.of_,
      pick("quantity", "Which quantity", ["velocity", "acceleration"]),
      pick("direction", "Which direction", ["whole", "going", "coming"]),
    );
  }
  /** Offers what of a case can be heard; what was chosen and is not there any more gives way to the first. */
  offer(resolved: Case): void {
    const heard = heardIn(resolved);
    setOptions(this.of_, heard);
    if (!heard.some(([name]) => name === this.options.of))
      this.options = { ...this.options, of: heard[0]?.[0] ?? soundDefaults.of };
    this.of_.value = this.options.of;
  }
}

const mostPeaks = 5; // that are told

export class Spectra implements ViewPart {
  readonly element: HTMLElement;
  private readonly log_ = h("input", { type: "checkbox", id: "log-frequency", onchange: () => this.paint_() });
  private readonly readout_ = h("p", { class: "readout", id: "peaks", role: "status" });
  private readonly picker_ = new SoundPicker(() => this.last_ && this.show(this.last_));
  private readonly spectrum_ = new Plot("Spectrum");
  private readonly level_ = new Plot("Level over time");
  private readonly spectrogram_ = new Spectrogram("Spectrogram");
  private readonly asked_ = new Asked<{ design: Design; options: SoundOptions }, Analysis>(
    ({ design, options }, signal) => api.analysis(design, options, signal),
    () => this.paint_(),
  );
  private readonly modes_ = h("ul", { class: "lines", id: "modal-lines" });
  private readonly askedModes_ = new Asked<{ design: Design; of: string }, ModalLines>(
    ({ design, of }, signal) => api.modalLines(design, of, signal),
    ({ lines }) =>
      this.modes_.replaceChildren(
        ...(lines.length > 0 ? lines.map(modalLine) : [h("li", {}, "none: it does not vibrate")]),
      ),
    "Taking it apart into free modes …",
  );
  private last_: Context | null = null;

  constructor() {
    this.log_.checked = true;
    this.element = h(
      "div",
      { class: "spectra" },
      h(
        "div",
        { class: "bar" },
        this.picker_.element,
        h("label", { class: "check" }, this.log_, "log frequency"),
        this.readout_,
        this.asked_.note,
      ),
      h("div", { class: "three" }, this.spectrum_.element, this.spectrogram_.element, this.level_.element),
      h(
        "details",
        { class: "modal", ontoggle: () => this.last_ && this.show(this.last_) },
        h("summary", {}, "Which free modes carry the lines of the velocity"),
        this.askedModes_.note,
        this.modes_,
      ),
    );
  }

  show(context: Context): void {
    this.last_ = context;
    if (context.step === "drag") return;
    if (context.simulation) this.picker_.offer(context.simulation.case);
    const { design } = context.state;
    this.asked_.ask({ design, options: this.picker_.options });
    if (this.element.querySelector("details")?.open) this.askedModes_.ask({ design, of: this.picker_.options.of });
  }

  private paint_(): void {
    const { answer } = this.asked_;
    if (!answer) return;
    const { spectrum, level } = answer;
    const scale = this.log_.checked ? "log" : "linear";
    const first = scale === "log" && spectrum.frequency[0] === 0 ? 1 : 0;
    const peaks = peaksOf(spectrum.frequency, spectrum.level, mostPeaks);
    const unit = unitText(spectrum.unit);
    const tell = (told: readonly Peak[], word: string): void =>
      setText(this.readout_, told.length > 0 ? `${word} [${unit}]: ${inRow(told.map(peakText))}` : "no peaks");
    this.spectrogram_.show(answer.spectrogram, undefined, undefined, scale);
    this.spectrum_.show({
      x: spectrum.frequency.slice(first),
      xTitle: "frequency [Hz]",
      xScale: scale,
      yTitle: unit,
      yRange: yRangeOf(spectrum.level),
      curves: [{ label: "level", colour: 0, values: spectrum.level.slice(first) }],
      marks: peaks.slice(0, 1).map((peak) => ({ x: peak.frequency, label: peakText(peak) })),
      point: (x) => {
        const near = x === null ? undefined : nearestPeak(peaks, x);
        tell(near ? [near] : peaks, near ? "peak here" : "peaks");
      },
    });
    tell(peaks, "peaks");
    this.spectrum_.describe(this.readout_.textContent ?? "");
    this.level_.show({
      x: level.time,
      xTitle: "time [s]",
      yTitle: unitText(level.unit),
      curves: [{ label: "level", colour: 1, values: level.decibels }],
    });
  }
}

/** "430 Hz: mode 2 (503 Hz) 94 %, mode 3 (1592 Hz) 6 %" */
function modalLine({ frequency, shares }: ModalLines["lines"][number]): HTMLElement {
  const parts = shares.map((each) => `mode ${each.mode} (${quantity(each.frequency, "Hz")}) ${percent(each.share, 0)}`);
  return h("li", {}, h("b", {}, quantity(frequency, "Hz")), `: ${parts.join(", ")}`);
}

/** The levels that matter: what lies more than 100 dB below the highest is not heard beside it. */
function yRangeOf(levels: readonly (number | null)[]): [number, number] {
  const known = levels.filter((level) => level !== null);
  const top = 10 * Math.ceil((Math.max(...known, 0) + 5) / 10);
  return [Math.max(top - 110, Math.min(...known, top - 10)), top];
}

/** "428.5 Hz 166.2 dB" */
function peakText({ frequency, level }: Peak): string {
  return `${plain(frequency)} Hz ${level.toFixed(1)} dB`;
}
