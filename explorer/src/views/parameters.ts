/** The design's parameters: a slider and a field each, made from the program's field table; presets; resets. */
import * as api from "../data/api.ts";
import { hasStructure, jointKey, keyOfJoint, valueIn } from "../data/cases.ts";
import type { ServerError } from "../data/answer_types.ts";
import type { Case, Field, Preset, QuantityField, Section, Start } from "../data/types.ts";
import { button, h, select, symbol } from "../draw/dom.ts";
import {
  exact,
  number as plainNumber,
  quantity,
  rounded,
  symbolParts,
  title,
  unitText,
  words,
} from "../draw/format.ts";
import { at, share } from "../draw/scale.ts";
import { companions, dependants, needsFile } from "./companions.ts";
import { withoutKeys, withValues, type State } from "../state/state.ts";
import type { Store } from "../state/store.ts";

const steps = 1000;
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

type Usual = NonNullable<QuantityField["usual"]>;

/** Between which values a quantity of a case is varied, if it is: of the temperature, over its table. */
function usualOf(field: QuantityField, resolved: Case): Usual | null {
  const { key, usual } = field;
  const value = valueIn(resolved, key);
  if (value === undefined || followsTemperature(resolved, key)) return null;
  if (key !== "temperature.value") return hasStructure(resolved) ? reached(field, Number(value)) : (usual ?? null);
  const at = (resolved.temperature as Section).at as number[];
  return { from: at[0] as number, to: at.at(-1) as number, scale: "linear" };
}

/**
 * Usual values are those of rubber seals: a structure of another size varies its own by as much, and a quantity of a
 * builder, which has none, about what the file says.
 */
function reached({ usual, section, low, high }: QuantityField, value: number): Usual | null {
  const size = Math.abs(value);
  if (!usual && (section !== "structure" || !(value > 0))) return null;
  if (usual && (usual.scale === "linear" || size === 0)) return { ...usual, to: Math.max(usual.to, size) };
  if (usual && size >= usual.from && size <= usual.to) return usual;
  const reach = usual ? Math.sqrt(usual.to / usual.from) : 4;
  const [from, to] = [Math.max(size / reach, low ?? 0), Math.min(size * reach, high ?? Infinity)];
  return from > 0 ? { from, to, scale: "log" } : { from, to, scale: "linear" };
}

/** The quantities that can be varied in a case, with the values between which. */
export function variedIn(resolved: Case, fields: readonly Field[]): (QuantityField & { usual: Usual })[] {
  return fields.flatMap((field) => {
    const usual = field.kind === "quantity" ? usualOf(field, resolved) : null;
    return field.kind === "quantity" && usual ? [{ ...field, usual }] : [];
  });
}

/** What a preset begins with: its own chart, else the present axes, unless its case does not have them. */
export function begun(start: Start, { name, case: resolved, chart }: Preset, { x, y }: State): Partial<State> {
  const known = variedIn(resolved, start.fields).map(({ key }) => key);
  const keeps = known.includes(x.parameter) && known.includes(y.parameter);
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

/** The value that a design gives a quantity: what was set, else what the case holds. */
export function quantityOf(state: State, resolved: Case, key: string): number {
  const said = state.design.set[key];
  return Number(said ?? valueIn(resolved, key));
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

  /** Shows a design whose resolved case is known; rows that mean nothing for it are hidden. */
  show(state: State, resolved: Case): void {
    this.resolved_ = resolved;
    for (const [name, input] of this.presets_) input.checked = name === state.design.preset;
    const preset = this.start_.presets.find(({ name }) => name === state.design.preset)?.case ?? resolved;
    this.preset_ = preset;
    for (const row of this.rows_) {
      const { key } = row.field;
      const value = state.design.set[key] ?? valueIn(resolved, key);
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
    const isOfCase = key === "temperature.value" || field.section === "structure"; // its ends are the case's
    const usual = field.usual ?? (isOfCase ? { from: 0, to: 1, scale: "linear" } : null);
    const slider = usual ? new Slider(field, usual, (value, step) => this.set_(field, value, step)) : null;

    let shown = "";
    let refused = false; // text that the program did not take for a quantity
    const forgive = (): void => {
      if (refused) this.complain_(null);
      refused = false;
    };
    const commit = (): void => {
      if (number.value === shown) return forgive();
      const text = number.value;
      const value = plainNumber(text);
      if (value !== null) this.set_(field, exact(value), "push");
      else
        void api.value(key, text).then(
          (meant) => take(text, meant),
          (error: unknown) => {
            refused = true;
            this.complain_(error);
          },
        );
    };
    const take = (text: string, meant: number): void => {
      if (number.value !== text) return; // typed over while it was read
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
      if (document.activeElement !== number || number.value === "") number.value = shown;
      else if (plainNumber(number.value) === known) number.value = shown;
      number.title = `${exact(known)} ${unitText(unit)}`.trim();
      slider?.show(known, shown, usualOf(field, this.preset_));
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

/** A slider over the usual values of a quantity, by its magnitude: the sign stays as it is. */
class Slider {
  readonly input: HTMLInputElement;
  private sign_ = 1;

  constructor(
    field: QuantityField,
    private usual_: Usual,
    change: (value: string, step: "push" | "drag") => void,
  ) {
    this.input = h("input", {
      "type": "range",
      "min": 0,
      "max": steps,
      "step": 1,
      "data-key": field.key,
      "aria-label": field.sentence,
    });
    this.input.addEventListener("input", () => change(exact(this.value_()), "drag"));
    this.input.addEventListener("change", () => change(exact(this.value_()), "push"));
  }

  show(value: number, text: string, usual: Usual | null): void {
    if (usual) this.usual_ = usual;
    const { from, to, scale } = this.usual_;
    this.sign_ = value < 0 && from >= 0 ? -1 : 1;
    const part = share(value * this.sign_, from, to, scale);
    const place = String(Math.round(steps * Math.min(Math.max(Number.isFinite(part) ? part : 0, 0), 1)));
    if (rounded(value) !== this.value_()) this.input.value = place;
    this.input.setAttribute("aria-valuetext", text);
    this.input.style.setProperty("--part", `${this.input.valueAsNumber / 10}%`);
  }

  private value_(): number {
    const { from, to, scale } = this.usual_;
    return this.sign_ * rounded(at(this.input.valueAsNumber / steps, from, to, scale));
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
