/** Which parameters the chart's axes are, between which ends, and what it shows. */
import * as api from "../data/api.ts";
import { isOfJoints } from "../data/cases.ts";
import type { Case, Start } from "../data/types.ts";
import { button, h, menu, select, setOptions } from "../draw/dom.ts";
import { number, plain, quantity, symbolText, title, withUnit, words } from "../draw/format.ts";
import type { Axis, State } from "../state/state.ts";
import type { Store } from "../state/store.ts";
import { rangesOf, variedIn } from "./parameters.ts";

type Name = "x" | "y";

interface AxisRow {
  parameter: HTMLSelectElement;
  from: HTMLInputElement;
  to: HTMLInputElement;
  scale: HTMLSelectElement;
}

export class AxisControls {
  readonly element: HTMLElement;
  private readonly rows_: Record<Name, AxisRow>;
  private readonly figure_: HTMLSelectElement;
  private known_: ReturnType<typeof variedIn> = []; // what may be an axis of the case at hand

  constructor(
    private readonly store_: Store,
    private readonly start_: Start,
    unzoom: () => void,
    private readonly complain_: (error: unknown) => void,
  ) {
    this.rows_ = { x: this.row_("x"), y: this.row_("y") };
    const figures = [["category", "category"], ...start_.figures.map(({ name }) => [name, words(name)])];
    const show = (figure: string): void => this.store_.update({ figure });
    this.figure_ = select("Shown in the chart", figures as [string, string][], show, {
      id: "figure",
    });
    this.element = h(
      "div",
      { class: "axes" },
      label("show", this.figure_),
      label("over", this.rows_.x.parameter),
      label("and", this.rows_.y.parameter),
      this.ends_(),
      button("⇄", () => this.store_.update({ x: this.store_.state.y, y: this.store_.state.x }), {
        "class": "icon",
        "aria-label": "Swap the axes",
        "title": "Swap the axes",
      }),
      button("⤢", unzoom, {
        "id": "unzoom",
        "class": "icon",
        "aria-label": "Unzoom",
        "title": "Back to the last axes (double click, or - on the chart)",
      }),
    );
  }

  /** The axis of a parameter over the range in which the case varies it. */
  whole(axis: Axis): Axis {
    return { ...axis, ...this.known_.find(({ key }) => key === axis.parameter)?.range };
  }

  show(state: State, resolved: Case): void {
    const known = (this.known_ = variedIn(resolved, this.start_.fields, rangesOf(this.start_, state.design.preset)));
    const options = known.map(
      ({ key, symbol }) => [key, title(key) + (symbol ? ` ${symbolText(symbol)}` : "")] as const,
    );
    for (const name of ["x", "y"] as const) {
      const axis = state[name];
      const row = this.rows_[name];
      const all = isOfJoints(resolved, axis.parameter) ? "all: " : "";
      const extra = known.some(({ key }) => key === axis.parameter)
        ? []
        : [[axis.parameter, all + title(axis.parameter)] as const];
      setOptions(row.parameter, [...options, ...extra]);
      row.parameter.value = axis.parameter;
      row.parameter.title = row.parameter.selectedOptions[0]?.text ?? ""; // it may be cut
      row.scale.value = axis.scale;
      const unit = this.unit_(axis);
      for (const end of ["from", "to"] as const)
        if (document.activeElement !== row[end])
          row[end].value = row[end].defaultValue = unit === "1" ? plain(axis[end], 6) : quantity(axis[end], unit, 6);
    }
    this.figure_.value = state.figure;
    this.figure_.title = words(state.figure);
  }

  private unit_({ parameter }: Axis): string {
    const field = this.start_.fields.find(({ key }) => key === parameter);
    return field?.kind === "quantity" ? field.unit : "";
  }

  private row_(name: Name): AxisRow {
    const parameter = select(`Parameter of the ${name} axis`, [], (key) => this.choose_(name, key), {
      id: `axis-${name}`,
    });
    const end = (which: "from" | "to"): HTMLInputElement => {
      const input = h("input", {
        "type": "text",
        "inputmode": "decimal",
        "autocomplete": "off",
        "aria-label": `${name} axis, ${which}`,
        "id": `${name}-${which}`,
      });
      input.addEventListener("change", () => void this.move_(name, which, input));
      return input;
    };
    const scale = select(
      `Scale of the ${name} axis`,
      [
        ["linear", "linear"],
        ["log", "log"],
      ],
      (value) => {
        const axis = this.store_.state[name];
        if (value === "log" && axis.from <= 0) this.change_(name, { ...axis, from: axis.to / 1000, scale: "log" });
        else this.change_(name, { ...axis, scale: value === "log" ? "log" : "linear" });
      },
    );
    return { parameter, from: end("from"), to: end("to"), scale };
  }

  private ends_(): HTMLElement {
    const line = (name: Name): HTMLElement => {
      const { from, to, scale } = this.rows_[name];
      return h("div", { class: "ends" }, h("b", {}, name), from, "to", to, scale);
    };
    const sizes = [16, 32, 64, 128].map((n): [string, string] => [String(n), `${n} × ${n} cells`]);
    const points = select("Points of each axis", sizes, (value) => {
      const { x, y } = this.store_.state;
      this.store_.update({ x: { ...x, points: Number(value) }, y: { ...y, points: Number(value) } });
    });
    points.value = "64";
    return menu("Range", h("div", { class: "sheet" }, line("x"), line("y"), points));
  }

  private choose_(name: Name, key: string): void {
    const { state } = this.store_;
    const other = name === "x" ? "y" : "x";
    if (state[other].parameter === key) this.store_.update({ x: state.y, y: state.x });
    else this.change_(name, this.whole({ ...state[name], parameter: key }));
  }

  private async move_(name: Name, which: "from" | "to", input: HTMLInputElement): Promise<void> {
    const axis = this.store_.state[name];
    try {
      const unit = this.unit_(axis);
      const text = withUnit(input.value, unit, axis[which]);
      const next = { ...axis, [which]: number(text) ?? (await api.value(axis.parameter, text)) };
      if (!(next.from < next.to)) throw Error(`The ${name} axis must rise from one end to the other.`);
      if (axis.scale === "log" && next.from <= 0) throw Error("A log axis begins above 0.");
      input.setAttribute("aria-invalid", "false");
      this.change_(name, next);
      this.complain_(null);
    } catch (error) {
      input.setAttribute("aria-invalid", "true");
      this.complain_(error);
    }
  }

  private change_(name: Name, axis: Axis): void {
    this.store_.update(name === "x" ? { x: axis } : { y: axis });
  }
}

function label(text: string, control: HTMLElement): HTMLElement {
  return h("label", {}, h("span", { class: "muted" }, text), control);
}
