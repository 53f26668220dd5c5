/** The design's parameters: a slider and a field each, made from the program's field table; presets; resets. */
import * as api from "../data/api.ts";
import { isOfJoints, jointKey, jointsOf, keyOfJoint, valueIn } from "../data/cases.ts";
import type { ServerError } from "../data/answer_types.ts";
import type { Case, Field, Preset, QuantityField, Start } from "../data/types.ts";
import { button, h, select, symbol } from "../draw/dom.ts";
import {
  exact,
  number as plainNumber,
  quantity,
  symbolParts,
  title,
  unitText,
  withUnit,
  words,
} from "../draw/format.ts";
import { roomy, type Range } from "../draw/places.ts";
import { holds } from "../draw/scale.ts";
import { companions, dependants, needsFile } from "./companions.ts";
import { withoutKeys, withValues, type Axis, type Design, type State } from "../state/state.ts";
import type { Store } from "../state/store.ts";
import { Slider } from "./slider.ts";

const folded = new Set(["run", "verdict"]);
const sectionTitles: Record<string, string> = {
  joint: "Joint",
  plate: "Plate",
  structure: "Structure",
  contact: "Contact",
  temperature: "Temperature",
  drive: "Drive",
  run: "Run",
  verdict: "Thresholds of the verdict",
};

/** Does a quantity follow the temperature by a table of the file? It cannot be set then. */
export function followsTemperature(resolved: Case, key: string): boolean {
  const { temperature } = resolved;
  return typeof temperature === "object" && key in temperature;
}

/** Between which values the program varies the quantities of a preset: around its own. */
export function rangesOf(start: Start, preset: string): Preset["ranges"] {
  return start.presets.find(({ name }) => name === preset)?.ranges ?? {};
}

/** The range of a quantity, if a case varies it; what its preset does not have is varied over its usual values. */
function rangeOf({ key, usual }: QuantityField, resolved: Case, ranges: Preset["ranges"]): Range | null {
  if (valueIn(resolved, key) === undefined || followsTemperature(resolved, key)) return null;
  return ranges[key] ?? usual ?? null;
}

/** The range of a slider: that of the quantity; of friction and other ratios with room above the own value. */
function reachOf(field: QuantityField, own: number, range: Range | null): Range | null {
  return range && field.unit === "1" && range.scale === "linear" ? roomy(range, own, field.high) : range;
}

/** The quantities that can be varied in a case, with the values between which. */
export function variedIn(
  resolved: Case,
  fields: readonly Field[],
  ranges: Preset["ranges"],
): (QuantityField & { range: Range })[] {
  return fields.flatMap((field) => {
    const range = field.kind === "quantity" ? rangeOf(field, resolved, ranges) : null;
    return field.kind === "quantity" && range ? [{ ...field, range }] : [];
  });
}

/** What a preset begins with: its own chart, else the present axes, unless its case is not on them. */
export function begun(start: Start, preset: Preset, { x, y }: State): Partial<State> {
  const { name, case: resolved, chart } = preset;
  const known = variedIn(resolved, start.fields, preset.ranges).map(({ key }) => key);
  const isOn = (axis: Axis): boolean =>
    known.includes(axis.parameter) && holds(axis, Math.abs(Number(valueIn(resolved, axis.parameter))));
  const keeps = isOn(x) && isOn(y);
  const axes = keeps ? {} : { x: start.chart.x, y: start.chart.y };
  return { design: { preset: name, set: {} }, span: null, ...axes, ...chart };
}

/** A row whose value comes from the table says so, in place of its slider. */
function follow({ field, element }: Row, isFollowing: boolean): void {
  if (isFollowing === element.classList.contains("follows")) return;
  element.classList.toggle("follows", isFollowing);
  const id = `${field.key}-note`;
  const note = element.querySelector(".note") ?? h("span", { class: "note", id }, "follows the temperature");
  if (isFollowing) element.append(note);
  else note.remove();
  for (const input of element.querySelectorAll("input")) {
    input.disabled = isFollowing;
    if (isFollowing) input.setAttribute("aria-describedby", note.id);
    else input.removeAttribute("aria-describedby");
  }
}

/** The value that a design gives a quantity: what was set, else what the case holds; of several joints the first's. */
export function quantityOf(state: State, resolved: Case, key: string): number {
  return quantitiesOf(state, resolved, key)[0] ?? NaN;
}

/** That of each joint, where a key without a name is that of several; else of one. */
export function quantitiesOf({ design: { set } }: State, resolved: Case, key: string): number[] {
  const joints = isOfJoints(resolved, key) ? jointsOf(resolved) : [];
  const own = joints.map(({ name }) => keyOfJoint(name, key));
  if (own.length === 0) return [Number(set[key] ?? valueIn(resolved, key))];
  return own.map((each) => Number(set[each] ?? set[key] ?? valueIn(resolved, each)));
}

/** The heading above the fields of a section; of one of several joints with its name. */
function sectionTitle(section: string): string {
  const [, joint, contact] = /^joint\.([^.]+)(\.contact)?$/.exec(section) ?? [];
  if (joint === undefined) return sectionTitles[section] ?? section;
  return contact ? `Contact of ${joint}` : `Joint ${joint}`;
}

/** Keys that mean nothing any more once a choice is made anew; of one of several joints below its name. */
function dependantsOf(fields: readonly Field[], key: string): string[] {
  const own = jointKey(key);
  const keys = dependants(fields, own?.inner ?? key).filter((each) => !jointKey(each));
  return own ? keys.map((each) => keyOfJoint(own.joint, each)) : keys;
}

interface Row {
  field: Field;
  element: HTMLElement;
  show(value: number | string, base: number | string | undefined): void;
}

export class Parameters {
  readonly element = h("section", { "class": "panel parameters", "aria-label": "Parameters" });
  private readonly rows_: Row[] = [];
  private readonly groups_ = new Map<string, HTMLElement>();
  private readonly presets_ = new Map<string, HTMLInputElement>();
  private readonly resetAll_: HTMLButtonElement;
  private resolved_: Case;
  private preset_: Case; // as it is without changes: a slider's ends do not move with it

  constructor(
    private readonly store_: Store,
    private readonly start_: Start,
    private readonly complain_: (error: unknown) => void,
  ) {
    this.resolved_ = this.preset_ = start_.presets[0]?.case as Case;
    const reset = (): void => this.store_.update({ design: { ...this.store_.state.design, set: {} } });
    this.resetAll_ = button("Reset all", reset, {
      id: "reset-all",
      class: "quiet",
      title: "Back to the preset's own values",
    });
    this.element.append(
      this.presetPicker_(),
      h("div", { class: "heading" }, h("h2", {}, "Parameters"), this.resetAll_),
      this.fields_(),
    );
  }

  /** Shows a design. The resolved case is of it, or of one before it (`of`). Rows that mean nothing are hidden. */
  show(state: State, resolved: Case, of: Design): void {
    this.resolved_ = resolved;
    for (const [name, input] of this.presets_) input.checked = name === state.design.preset;
    const preset = this.start_.presets.find(({ name }) => name === state.design.preset)?.case ?? resolved;
    this.preset_ = preset;
    for (const row of this.rows_) {
      const { key } = row.field;
      const isReset = state.design.set[key] === undefined && of.set[key] !== undefined;
      const now = (isReset ? valueIn(preset, key) : undefined) ?? valueIn(resolved, key);
      const value = state.design.set[key] ?? now;
      row.element.hidden = valueIn(resolved, key) === undefined && state.design.set[key] === undefined;
      row.element.classList.toggle("changed", state.design.set[key] !== undefined);
      if (value !== undefined) row.show(value, valueIn(preset, key));
      follow(row, followsTemperature(resolved, key));
    }
    for (const [, group] of this.groups_)
      group.hidden = ![...group.querySelectorAll<HTMLElement>(".row")].some((row) => !row.hidden);
    this.resetAll_.disabled = Object.keys(state.design.set).length === 0;
  }

  /** Marks the fields that the server refused. */
  blame(complaints: readonly ServerError[]): void {
    const refused = new Set(complaints.map(({ key }) => key));
    for (const row of this.rows_) {
      const guilty = refused.has(row.field.key);
      row.element.classList.toggle("refused", guilty);
      for (const input of row.element.querySelectorAll("input")) input.setAttribute("aria-invalid", String(guilty));
    }
  }

  private presetPicker_(): HTMLElement {
    const group = h("fieldset", { id: "preset", class: "segments" }, h("legend", { class: "unseen" }, "Case"));
    for (const preset of this.start_.presets) {
      const { name, title } = preset;
      const input = h("input", { "type": "radio", "name": "preset", "value": name, "data-preset": name });
      input.addEventListener("change", () => this.store_.update(begun(this.start_, preset, this.store_.state)));
      this.presets_.set(name, input);
      group.append(h("label", { title }, input, h("span", {}, name)));
    }
    return group;
  }

  private fields_(): HTMLElement {
    const list = h("div", { class: "fields" });
    for (const field of this.start_.fields) {
      if (field.kind === "text" || field.section === "") continue;
      const row = field.kind === "quantity" ? this.quantityRow_(field) : this.choiceRow_(field);
      this.rows_.push(row);
      this.group_(list, field.section).append(row.element);
    }
    return list;
  }

  private group_(list: HTMLElement, section: string): HTMLElement {
    const known = this.groups_.get(section);
    if (known) return known;
    const title = sectionTitle(section);
    const group = folded.has(section)
      ? h("details", { "data-section": section }, h("summary", {}, h("h3", {}, title)))
      : h("div", { "data-section": section }, h("h3", {}, title));
    this.groups_.set(section, group);
    list.append(group);
    return group;
  }

  private set_(field: Field, value: string, step: "push" | "drag"): void {
    const { design } = this.store_.state;
    const isOwn = field.kind === "quantity" && Number(value) === valueIn(this.preset_, field.key);
    if (isOwn) return this.store_.update({ design: withoutKeys(design, [field.key]) }, step);
    const kept = field.kind === "choice" ? withoutKeys(design, dependantsOf(this.start_.fields, field.key)) : design;
    const needed = field.kind === "choice" ? this.companions_(field.key, value) : {};
    this.store_.update({ design: withValues(kept, { ...needed, [field.key]: value }) }, step);
  }

  private companions_(key: string, choice: string): Record<string, string> {
    const { state } = this.store_;
    const now = (name: string): number => quantityOf(state, this.resolved_, name);
    const own = jointKey(key);
    const ofJoint = (name: string): string => (own ? keyOfJoint(own.joint, name) : name);
    const fields = this.start_.fields.filter((field) => !jointKey(field.key));
    const inner = companions(fields, own?.inner ?? key, choice, (name) => now(ofJoint(name)), state.direction);
    return Object.fromEntries(Object.entries(inner).map(([name, value]) => [ofJoint(name), value]));
  }

  private resetButton_(field: Field): HTMLButtonElement {
    const keys = [field.key, ...dependantsOf(this.start_.fields, field.key)];
    const reset = (): void => this.store_.update({ design: withoutKeys(this.store_.state.design, keys) });
    return button("↺", reset, {
      "class": "reset",
      "data-reset": field.key,
      "title": "Back to the preset's value",
      "aria-label": `Reset ${title(field.key)}`,
    });
  }

  private quantityRow_(field: QuantityField): Row {
    const { key, unit } = field;
    const number = h("input", {
      "type": "text",
      "inputmode": "decimal",
      "autocomplete": "off",
      "spellcheck": "false",
      "data-field": key,
      "aria-label": `${title(key)}, ${unitText(unit) || "no unit"}`,
    });
    const reset = this.resetButton_(field);
    const isOfCase = key === "temperature.value" || field.section === "structure"; // its range is the case's
    const range = field.usual ?? (isOfCase ? { from: 0, to: 1, scale: "linear" } : null);
    const slider = range ? new Slider(field, range, (value, step) => this.set_(field, value, step)) : null;

    let shown = "";
    let size = 0; // of what is shown
    let refused = false; // text that the program did not take for a quantity
    const forgive = (): void => {
      if (refused) this.complain_(null);
      refused = false;
    };
    const commit = (): void => {
      if (number.value === shown) return forgive();
      const typed = number.value;
      const text = withUnit(typed, unit, size);
      const value = plainNumber(text);
      if (value !== null) this.set_(field, exact(value), "push");
      else
        void api.value(key, text).then(
          (meant) => take(typed, meant),
          (error: unknown) => {
            refused = true;
            this.complain_(error);
          },
        );
    };
    const take = (typed: string, meant: number): void => {
      if (number.value !== typed) return; // typed over while it was read
      number.value = "";
      this.set_(field, exact(meant), "push");
    };
    number.addEventListener("change", commit);
    number.addEventListener("focus", () => number.select());
    number.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      number.value = shown;
      forgive();
    });

    const element = h(
      "div",
      { "class": slider ? "row" : "row short", "data-row": key, "title": field.sentence },
      h("label", { class: "name" }, field.symbol ? symbol(symbolParts(field.symbol)) : null, h("span", {}, words(key))),
      reset,
      number,
      slider?.input ?? null,
    );
    const show = (value: number | string, base: number | string | undefined): void => {
      const known = Number(value);
      shown = quantity(known, unit);
      size = known;
      if (document.activeElement !== number || number.value === "") number.value = shown;
      else if (plainNumber(withUnit(number.value, unit, known)) === known) number.value = shown;
      number.title = `${exact(known)} ${unitText(unit)}`.trim();
      const range = rangeOf(field, this.preset_, rangesOf(this.start_, this.store_.state.design.preset));
      const own = base === undefined ? undefined : Number(base);
      slider?.show(known, shown, own, reachOf(field, own ?? 0, range));
      reset.title = base === undefined ? "Reset" : `Back to ${quantity(Number(base), unit)}`;
    };
    return { field, element, show };
  }

  private choiceRow_(field: Extract<Field, { kind: "choice" }>): Row {
    const choices = field.choices.map((name) => [name, name] as const);
    const picker = select(field.sentence, choices, (value) => this.set_(field, value, "push"), {
      "data-key": field.key,
    });
    const element = h(
      "div",
      { "class": "row choice", "data-row": field.key, "title": field.sentence },
      h("label", { class: "name" }, h("span", {}, words(field.key))),
      this.resetButton_(field),
      picker,
    );
    const show = (value: number | string): void => {
      const { fields } = this.start_;
      for (const option of picker.options)
        option.disabled = option.value !== value && needsFile(fields, field.key, option.value);
      picker.value = String(value);
    };
    return { field, element, show };
  }
}

/** What was refused: a line, or a list of all that is wrong; or nothing. */
export class Complaint {
  readonly element = h("div", { id: "complaint", class: "complaint", role: "alert", hidden: true });
  private shown_ = "";

  show(told: readonly string[]): void {
    const text = told.join("\n");
    if (text === this.shown_) return; // not announced anew
    this.shown_ = text;
    this.element.hidden = told.length === 0;
    // a long list scrolls, with the keys as well
    if (told.length > 1) this.element.tabIndex = 0;
    else this.element.removeAttribute("tabindex");
    const list = (): Node => h("ul", {}, ...told.map((each) => h("li", {}, each)));
    this.element.replaceChildren(told.length > 1 ? list() : (told[0] ?? ""));
  }
}
