/**
 * How far the design is from noise or from quiet, along each parameter and in all,
 * and the smallest change that helps.
 */
import * as api from "../data/api.ts";
import { valueIn } from "../data/cases.ts";
import type { Advice, AdviceMargin } from "../data/answer_types.ts";
import type { QuantityField, Start } from "../data/types.ts";
import { button, h, select, setOptions, setText, symbol } from "../draw/dom.ts";
import { exact, number, percent, plain, quantity, symbolParts, title } from "../draw/format.ts";
import { share } from "../draw/scale.ts";
import { onLook, paintSwatch } from "../draw/theme.ts";
import { withValues, type Design } from "../state/state.ts";
import type { Store } from "../state/store.ts";
import { Asked } from "./asked.ts";
import { followsTemperature } from "./parameters.ts";
import type { Context, ViewPart } from "./views.ts";

interface Wish {
  design: Design;
  tolerance: { key: string; relative: number }[];
}

export class Quiet implements ViewPart {
  readonly element: HTMLElement;
  private readonly margins_ = h("div", { class: "margins", id: "margins" });
  private readonly change_ = h("div", { class: "card", id: "change" });
  private readonly chance_ = h("p", { id: "chance" });
  private readonly tolerances_ = h("div", { class: "tolerances" });
  private readonly asked_ = new Asked<Wish, Advice>(
    ({ design, tolerance }, signal) => api.advice(design, tolerance.length ? { tolerance } : {}, signal),
    (answer, { design }) => this.paint_(answer, design),
    "Looking for the nearest boundaries …",
  );
  private readonly quantities_: QuantityField[];
  private wanted_: { key: string; relative: number }[] = [];
  private last_: Context | null = null;

  constructor(
    private readonly store_: Store,
    start: Start,
  ) {
    this.quantities_ = start.fields.filter(
      (field): field is QuantityField => field.kind === "quantity" && field.usual !== null,
    );
    onLook(() => this.asked_.again());
    this.element = h(
      "div",
      { class: "quiet-view" },
      h(
        "div",
        { class: "wide" },
        h("h3", {}, "How far each parameter is from another verdict, the nearest first"),
        this.asked_.note,
        this.margins_,
      ),
      h(
        "div",
        { class: "side" },
        this.change_,
        h("div", { class: "card" }, h("h3", {}, "Chance of noise under tolerances"), this.tolerances_, this.chance_),
      ),
    );
  }

  show(context: Context): void {
    this.last_ = context;
    if (context.step === "drag" || !context.simulation) return;
    this.asked_.ask({ design: context.state.design, tolerance: this.wanted_ });
    this.showTolerances_();
  }

  private field_(key: string): QuantityField | undefined {
    return this.quantities_.find((field) => field.key === key);
  }

  private paint_(advice: Advice, design: Design): void {
    const order = [...advice.margins].sort((a, b) => rank(advice, a.key) - rank(advice, b.key));
    this.margins_.replaceChildren(...order.map((margin) => this.marginRow_(margin, advice)));
    this.paintChange_(advice, design);
    const { chance } = advice;
    setText(
      this.chance_,
      chance
        ? `${percent(chance.noise)} of such designs are noisy (${percent(chance.low)} to ${percent(chance.high)} ` +
            `with ${percent(chance.confidence, 0)} confidence, ${chance.samples} designs` +
            `${chance.usual ? ", within the usual tolerances of parts" : ""})`
        : "Say how far parameters may stray, and the chance of noise is estimated.",
    );
  }

  private marginRow_(margin: AdviceMargin, advice: Advice): HTMLElement {
    const field = this.field_(margin.key);
    const place = (value: number): number =>
      100 * Math.min(Math.max(share(value, margin.from, margin.to, margin.scale), 0), 1);
    const bar = h("div", { "class": "margin-bar", "aria-hidden": "true" });
    // each designs' verdict reaches half way to the next ones
    let end = 0;
    margin.scan.forEach(({ value, category }, at) => {
      const next = margin.scan[at + 1];
      if (next?.category === category) return;
      const part = h("span", { class: "band" });
      part.style.left = `${end}%`;
      end = next ? (place(value) + place(next.value)) / 2 : 100;
      part.style.width = `${end - parseFloat(part.style.left)}%`;
      paintSwatch(part, category);
      bar.append(part);
    });
    const here = advice.present.category;
    const needle = h("span", { class: "needle" });
    needle.style.left = `${place(margin.value)}%`;
    bar.append(needle);
    const say = (bound: AdviceMargin["below"], word: string): string =>
      bound ? `${bound.category} ${word} ${quantity(bound.value, margin.unit)}` : "";
    const text =
      [say(margin.below, "below"), say(margin.above, "above")].filter(Boolean).join(", ") ||
      `${here} at all ${margin.scan.length} values looked at`;
    const try_ = (bound: AdviceMargin["below"]): HTMLElement | null =>
      bound && bound.category === "none" && here !== "none"
        ? button(
            `go to ${quantity(bound.value, margin.unit, 3)}`,
            () => this.apply_([{ key: margin.key, to: bound.value }]),
            { class: "quiet" },
          )
        : null;
    return h(
      "div",
      { "class": "margin", "data-margin": margin.key },
      h("span", { class: "name" }, field?.symbol ? symbol(symbolParts(field.symbol)) : null, title(margin.key)),
      h("span", { class: "end muted" }, quantity(margin.from, margin.unit, 3)),
      bar,
      h("span", { class: "end muted" }, quantity(margin.to, margin.unit, 3)),
      h("span", { class: "says" }, text, try_(margin.below), try_(margin.above)),
    );
  }

  private paintChange_(advice: Advice, design: Design): void {
    const { change } = advice;
    const quietNow = advice.present.category === "none";
    const lines: (HTMLElement | null)[] = [
      h("h3", {}, quietNow ? "The design is quiet" : "The smallest change that keeps it quiet"),
      h("p", { id: "standing" }, advice.headline),
      advice.near?.turns.length ? h("ul", {}, ...advice.near.turns.map(turnLine)) : null,
    ];
    if (change) {
      const steps = change.set.map(({ key, from, to }) => {
        const unit = this.field_(key)?.unit ?? "";
        return h("li", {}, h("b", {}, title(key)), ` ${quantity(from, unit)} → ${quantity(to, unit)}`);
      });
      const verified = Object.entries(change.verified.phases)
        .map(([phase, category]) => `${phase}: ${category}`)
        .join(", ");
      lines.push(
        h("ul", {}, ...steps),
        h(
          "p",
          { class: "muted" },
          `verified by ${change.verified.runs} runs: ${verified}; ` + `${plain(change.distance, 3)} of the ranges away`,
        ),
        advice.changed ? h("p", { id: "changed" }, `With it: ${advice.changed.words}`) : null,
        button("Apply", () => this.apply_(change.set), { id: "apply-change", class: "primary" }),
        h("span", { class: "muted" }, " back undoes it"),
      );
    } else if (!quietNow) {
      lines.push(h("p", {}, "No change within the ranges beside the bars was verified to be quiet."));
    }
    const as = quietNow ? "noisy" : "quiet";
    const { nearest } = advice;
    lines.push(
      h(
        "p",
        { id: "nearest" },
        "All parameters together: " +
          (nearest ? `the nearest ${as} design is ${nearestText(nearest)}` : `no ${as} design was found`),
      ),
    );
    this.change_.dataset.preset = design.preset;
    this.change_.replaceChildren(...lines.filter((line): line is HTMLElement => line !== null));
  }

  private apply_(set: { key: string; to: number }[]): void {
    const values = Object.fromEntries(set.map(({ key, to }) => [key, exact(to)]));
    this.store_.update({ design: withValues(this.store_.state.design, values) });
  }

  private showTolerances_(): void {
    if (this.tolerances_.contains(document.activeElement)) return;
    const resolved = this.last_?.simulation?.case;
    const known = this.quantities_.filter(
      ({ key }) => resolved && valueIn(resolved, key) !== undefined && !followsTemperature(resolved, key),
    );
    const options = known.map(({ key }) => [key, title(key)] as const);
    const rows = this.wanted_.map((tolerance, at) => {
      const picker = select("Parameter", [], (key) => this.tolerate_(at, { ...tolerance, key }));
      setOptions(picker, options);
      picker.value = tolerance.key;
      const input = h("input", {
        "type": "text",
        "inputmode": "decimal",
        "value": `${plain(100 * tolerance.relative)} %`,
        "aria-label": "Tolerance, per cent",
      });
      input.addEventListener("change", () => {
        const relative = (number(input.value.replace("%", "").replace(",", ".")) ?? 0) / 100;
        input.setAttribute("aria-invalid", String(!(relative > 0)));
        if (relative > 0) this.tolerate_(at, { ...tolerance, relative });
      });
      return h(
        "div",
        { class: "ends" },
        picker,
        "±",
        input,
        button("×", () => this.tolerate_(at, null), { "class": "quiet", "aria-label": "Remove" }),
      );
    });
    const unused =
      known.find(({ key }) => !this.wanted_.some((tolerance) => tolerance.key === key) && key === "contact.preload") ??
      known.find(({ key }) => !this.wanted_.some((tolerance) => tolerance.key === key));
    const add = button(
      "Add a tolerance",
      () => unused && this.tolerate_(this.wanted_.length, { key: unused.key, relative: 0.1 }),
      { id: "add-tolerance" },
    );
    this.tolerances_.replaceChildren(...rows, add);
  }

  private tolerate_(at: number, tolerance: { key: string; relative: number } | null): void {
    const wanted = [...this.wanted_];
    if (tolerance) wanted[at] = tolerance;
    else wanted.splice(at, 1);
    this.wanted_ = wanted;
    (document.activeElement as HTMLElement | null)?.blur();
    if (this.last_) this.show(this.last_);
  }
}

function rank(advice: Advice, key: string): number {
  const place = advice.ranking.indexOf(key);
  return place < 0 ? advice.ranking.length : place;
}

/** A change that ends the silence; its value in the units of the page. */
function turnLine({ words, value, unit }: NonNullable<Advice["near"]>["turns"][number]): HTMLElement {
  return h("li", {}, words.replace(/\(.*?\)/, `(${quantity(value, unit)})`));
}

/** "joint mass 100 g → 93.2 g, preload 20 N → 21 N (0.85 % of their ranges away)", of what the program names. */
function nearestText({ words, set }: NonNullable<Advice["nearest"]>): string {
  return words.replace(/[\w.-]+ \S+ -> \S+( [^\s,(]+)?/g, (text) => {
    const step = set.find(({ key }) => text.startsWith(`${key} `));
    return step ? `${title(step.key)} ${quantity(step.from, step.unit)} → ${quantity(step.to, step.unit)}` : text;
  });
}
