/** The verdict on the present design: a chip per phase, announced to screen readers. */
import { jointsOf, rubbing, valueIn } from "../data/cases.ts";
import { worstFirst } from "../data/interfaces.ts";
import type { PhaseResult, Simulation } from "../data/types.ts";
import { kindOf, silenceOf, wordOf } from "../draw/colours.ts";
import { h, setText } from "../draw/dom.ts";
import { level, percent, quantity } from "../draw/format.ts";
import { paintSwatch } from "../draw/theme.ts";
import type { Direction } from "../program/words.ts";

/** Which direction a phase is: of a constant drive, that of its velocity. */
export function directionOf(result: PhaseResult, simulation: Simulation): Direction {
  if (result.phase !== "all") return result.phase;
  const velocity = Number(valueIn(simulation.case, "drive.velocity") ?? 0);
  return velocity < 0 ? "coming" : "going";
}

/** The phase of a direction; of a constant drive the one there is. */
export function phaseOf(simulation: Simulation, direction: Direction): PhaseResult | undefined {
  return simulation.phases.find(({ phase }) => phase === direction) ?? simulation.phases[0];
}

export class VerdictBar {
  readonly element: HTMLElement;
  private readonly chips_ = h("div", { "id": "verdict", "class": "verdict", "aria-busy": "true" });
  private readonly live_ = h("p", { "class": "unseen", "aria-live": "polite", "id": "announcement" });
  private readonly headline_ = h("p", { class: "headline", id: "headline", role: "status" });
  private last_: Simulation | null = null;

  constructor(private readonly choose_: (direction: Direction) => void) {
    const note = h("small", { class: "muted", id: "level-note" }, "dB re 1 nm/s: vibration, not sound pressure");
    this.element = h("section", { "class": "judged", "aria-label": "Verdict" }, this.chips_, this.headline_, note);
    this.element.append(this.live_);
  }

  /** Says how the design stands, both ways and from every start; the chips are of one run. */
  say(words: string): void {
    setText(this.headline_, words);
  }

  busy(): void {
    this.chips_.setAttribute("aria-busy", "true");
  }

  /** There is no verdict on the present design: the last one is not shown as if it were. */
  fail(): void {
    this.last_ = null;
    this.clear_();
    this.chips_.replaceChildren(h("span", { class: "note" }, "no result"));
    this.say("");
    this.chips_.setAttribute("aria-busy", "false");
  }

  private clear_(): void {
    for (const name of ["going", "coming", "all"]) delete this.chips_.dataset[name];
  }

  repaint(chosen: Direction): void {
    if (this.last_) this.show(this.last_, chosen);
  }

  show(simulation: Simulation, chosen: Direction): void {
    this.last_ = simulation;
    this.clear_();
    const chips = simulation.phases.map((result) => {
      const direction = directionOf(result, simulation);
      this.chips_.dataset[direction] = result.verdict.category;
      this.chips_.dataset[result.phase] = result.verdict.category;
      const loudest = jointsOf(simulation.case).length > 1 ? worstFirst(result)[0]?.name : undefined;
      return this.chip_(result, direction, chosen, loudest ?? rubbing(simulation.case));
    });
    this.chips_.replaceChildren(...chips);
    this.chips_.setAttribute("aria-busy", "false");
    setText(this.live_, simulation.phases.map(spoken).join("; "));
  }

  private chip_(result: PhaseResult, direction: Direction, chosen: Direction, what: string): HTMLElement {
    const { verdict } = result;
    const swatch = h("span", { "class": "swatch", "aria-hidden": "true" });
    paintSwatch(swatch, kindOf(verdict));
    const chip = h(
      "button",
      {
        "type": "button",
        "class": "chip",
        "data-phase": result.phase,
        "aria-pressed": String(direction === chosen),
        "title": [
          ...verdict.reasons,
          ...verdict.warnings.map((text) => `Warning: ${text}`),
          `${what}: its velocity level, dB re 1 nm/s; a vibration, not a sound pressure`,
          "(click: regard this direction)",
        ].join("\n"),
        "onclick": () => this.choose_(direction),
      },
      swatch,
      h("span", { class: "phase" }, result.phase === "all" ? "" : result.phase),
      h("strong", {}, wordOf(verdict)),
      h("span", { class: "detail" }, detail(result, what)),
      rates(result),
    );
    return chip;
  }
}

function detail(result: PhaseResult, rubs: string): string {
  const { verdict } = result;
  const what = verdict.category === "none" ? silenceOf(verdict) : quantity(verdict.frequency, "Hz");
  return [what, `${rubs} ${level(verdict.levels.joint.level)}`].filter(Boolean).join(" · ");
}

function rates(result: PhaseResult): HTMLElement {
  const shares = result.verdict.judged_rates;
  const text = (["slip", "stick", "separation"] as const)
    .map((state) => `${state} ${percent(shares[state])}`)
    .join(", ");
  const bar = h("span", {
    "class": "rates",
    "role": "img",
    "aria-label": text,
    "title": `of the judged time: ${text}`,
  });
  for (const state of ["slip", "stick", "separation"] as const) {
    const part = h("span", { class: `state-${state}` });
    part.style.flexGrow = String(Math.max(shares[state], 0));
    bar.append(part);
  }
  return bar;
}

function spoken(result: PhaseResult): string {
  const { verdict } = result;
  const name = result.phase === "all" ? "" : `${result.phase}: `;
  const silence = silenceOf(verdict) ? `no noise, it ${silenceOf(verdict)}` : "locks, which is no quiet design";
  const category = verdict.category === "none" ? silence : verdict.category;
  const pitch = verdict.category !== "none" && verdict.frequency ? ` at ${quantity(verdict.frequency, "Hz", 3)}` : "";
  return name + category + pitch;
}
