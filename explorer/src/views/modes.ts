/** Complex eigenvalues of steady sliding over the friction coefficient: where modes couple and grow. */
import * as api from "../data/api.ts";
import type { Stability, StabilityDirection } from "../data/answer_types.ts";
import type { QuantityField, Start } from "../data/types.ts";
import { h, select, setOptions, setText } from "../draw/dom.ts";
import { plain, quantity, symbolText, title, unitText, writtenIn } from "../draw/format.ts";
import { Plot, type Curve } from "../draw/plot.ts";
import type { Design } from "../state/state.ts";
import { Asked } from "./asked.ts";
import { quantityOf, rangesOf, variedIn } from "./parameters.ts";
import type { Context, ViewPart } from "./views.ts";

const most = 4; // branches that are drawn

interface Wish {
  design: Design;
  over: { key: string; from: number; to: number };
}

export class Modes implements ViewPart {
  readonly element: HTMLElement;
  private readonly frequency_ = new Plot("Frequencies of steady sliding");
  private readonly growth_ = new Plot("Growth rates of steady sliding");
  private readonly verdict_ = h("p", { class: "readout", id: "modes-readout" });
  private readonly over_: HTMLSelectElement;
  private readonly asked_ = new Asked<Wish, Stability>(
    ({ design, over }, signal) => api.stability(design, over, signal),
    () => this.paint_(),
  );
  private key_ = "contact.kinetic_friction";
  private last_: Context | null = null;

  constructor(private readonly start_: Start) {
    this.over_ = select(
      "Over which parameter",
      [],
      (key) => {
        this.key_ = key;
        if (this.last_) this.show(this.last_);
      },
      { id: "modes-over" },
    );
    this.element = h(
      "div",
      { class: "modes" },
      h(
        "div",
        { class: "bar" },
        h("label", {}, h("span", { class: "muted" }, "over "), this.over_),
        this.verdict_,
        this.asked_.note,
      ),
      h("div", { class: "two" }, this.frequency_.element, this.growth_.element),
    );
  }

  show(context: Context): void {
    this.last_ = context;
    const { simulation, state } = context;
    if (!simulation || context.step === "drag") return;
    const ranges = rangesOf(this.start_, state.design.preset);
    const varied = variedIn(simulation.case, this.start_.fields, ranges);
    const known = varied.filter(({ key }) => !key.startsWith("drive."));
    if (!known.some(({ key }) => key === this.key_)) this.key_ = known[0]?.key ?? this.key_;
    setOptions(
      this.over_,
      known.map(({ key, symbol }) => [key, title(key) + (symbol ? ` ${symbolText(symbol)}` : "")]),
    );
    this.over_.value = this.key_;
    const range = known.find(({ key }) => key === this.key_)?.range ?? { from: 0, to: 1 };
    let { to } = range;
    // mu_d may not exceed mu_s
    if (this.key_ === "contact.kinetic_friction")
      to = Math.min(to, quantityOf(state, simulation.case, "contact.static_friction"));
    let { from } = range;
    if (this.key_ === "contact.static_friction")
      from = Math.max(from, quantityOf(state, simulation.case, "contact.kinetic_friction"));
    this.asked_.ask({ design: state.design, over: { key: this.key_, from, to } });
    this.paint_();
  }

  private paint_(): void {
    const { answer } = this.asked_;
    if (!answer || !this.last_?.simulation) return;
    const { state, simulation } = this.last_;
    const direction = answer.directions.find((each) => each.direction === state.direction) ?? answer.directions[0];
    if (!direction || direction.points.length === 0) return;
    const field = this.start_.fields.find(({ key }) => key === this.key_) as QuantityField | undefined;
    const written = writtenIn(field?.unit ?? "", direction.points.at(-1)?.value ?? 0);
    const unit = unitText(written.unit);
    const x = direction.points.map(({ value }) => value * written.factor);
    const xTitle = title(this.key_) + (unit ? ` [${unit}]` : "");
    const marks = [
      { x: quantityOf(state, simulation.case, this.key_), label: "now" },
      ...direction.boundaries.map(({ value, above }) => ({ x: value, label: above })),
    ].map((mark) => ({ ...mark, x: mark.x * written.factor }));
    this.frequency_.show({ x, xTitle, yTitle: "frequency [Hz]", marks, curves: branches(direction, "frequency") });
    this.growth_.show({
      x,
      xTitle,
      yTitle: "growth rate [1/s]",
      marks,
      zeroLine: true,
      curves: branches(direction, "growth"),
    });
    const onset = direction.boundaries
      .map(({ value, below, above }) => `${below} → ${above} at ${quantity(value, field?.unit ?? "", 4)}`)
      .join("; ");
    const lifted = direction.open ? `; steady sliding lifts ${direction.open.join(", ")} off` : "";
    setText(
      this.verdict_,
      `${direction.direction}: ${onset || `${direction.points[0]?.kind ?? ""} all along`}${lifted}`,
    );
    const largest = Math.max(...direction.points.map(({ growth }) => growth));
    this.growth_.describe(`${this.verdict_.textContent}; largest growth rate ${plain(largest)} 1/s`);
  }
}

/** The modes of every point, in the order of their frequency: a branch each. */
function branches(direction: StabilityDirection, name: "frequency" | "growth"): Curve[] {
  const count = Math.min(most, Math.max(...direction.points.map(({ modes }) => modes.length)));
  return Array.from({ length: count }, (_, k) => ({
    label: `mode ${k + 1}`,
    colour: ([0, 1, 2, 3] as const)[k] ?? 0,
    width: 1.8,
    values: direction.points.map(({ modes }) => {
      const sorted = [...modes].sort((a, b) => a.frequency - b.frequency || a.growth - b.growth);
      return sorted[k]?.[name] ?? null;
    }),
  }));
}
