/** The chart: two directions side by side, streamed as it is refined, followed while a slider is dragged. */
import * as api from "../data/api.ts";
import { isOfJoints, jointsOf, valueIn } from "../data/cases.ts";
import { computedIn, merged, wordAt, type ChartData } from "../data/chart_data.ts";
import { Latest } from "../data/latest.ts";
import type { Case, ChartFrame, Simulation, Start } from "../data/types.ts";
import { button, h, setText } from "../draw/dom.ts";
import {
  between,
  exact,
  inRow,
  plain,
  quantity,
  symbolText,
  title,
  unitText,
  words,
  writtenIn,
} from "../draw/format.ts";
import { indexOf, paintMap, type Look, type Mark } from "../draw/map.ts";
import { holds, nearest, widened, zoomed } from "../draw/scale.ts";
import type { Surface } from "../draw/surface.ts";
import { onLook, palette } from "../draw/theme.ts";
import { steadyDrives, type Direction } from "../program/words.ts";
import { chartDesign, withValues, type Axis, type State } from "../state/state.ts";
import type { Step, Store } from "../state/store.ts";
import { AxisControls } from "./axis_controls.ts";
import { ChartPanel, type PanelOwner } from "./chart_panel.ts";
import { ChartReadout, type Cell } from "./chart_readout.ts";
import { Legend } from "./legend.ts";
import { quantitiesOf, quantityOf } from "./parameters.ts";

const stepPause = 1500; // [ms] arrow keys within it are one step of the history
const longestAnswer = 115_000; // [ms] the program stops what takes two minutes
const tooLong = "The chart took longer than two minutes. Take fewer cells below Range, or run `stridor chart`.";
const patience = 180; // [ms] how long a chart that follows a slider is refined when a newer one waits

export class Chart implements PanelOwner {
  readonly element: HTMLElement;
  private readonly box_ = h("div", {
    "id": "chart",
    "class": "maps",
    "data-computed": 0,
    "data-done": "false",
    "data-redraws": 0,
  });
  private readonly status_ = h("span", { id: "chart-status", class: "muted" });
  private readonly problem_ = h("p", { class: "complaint", hidden: true, role: "alert" });
  private readonly outside_ = h("p", { class: "outside", id: "outside", role: "status", hidden: true });
  private readonly gaps_ = h("p", { class: "outside", id: "gaps", role: "status", hidden: true });
  private readonly key_ = h("p", { class: "muted", id: "marks", hidden: true }); // of marks with numbers
  private readonly numbered_ = new Set<Direction>(); // where marks have them
  private readonly panels_: ChartPanel[];
  private readonly readout_: ChartReadout;
  private readonly controls_: AxisControls;
  private readonly legend_ = new Legend();
  private readonly zooms_: { x: Axis; y: Axis }[] = [];
  private readonly requests_ = new Latest<api.ChartWish>(
    (wish, signal, shown) => this.fetch_(wish, signal, shown),
    patience,
  );
  private stepped_ = -Infinity; // [ms] when an arrow key last moved the cell
  private data_: ChartData | null = null;
  private dataKey_ = ""; // of what was asked for it
  private shownKey_ = "";
  private wasPreview_ = false;
  private resolved_: Case;

  constructor(
    private readonly store_: Store,
    private readonly start_: Start,
    complain: (error: unknown) => void,
  ) {
    this.resolved_ = (start_.presets.find(({ name }) => name === store_.state.design.preset) ?? start_.presets[0])
      ?.case as Case;
    this.key_.style.visibility = "hidden";
    this.controls_ = new AxisControls(store_, start_, () => this.unzoom(), complain);
    this.panels_ = (["going", "coming"] as const).map((direction) => new ChartPanel(direction, this));
    this.readout_ = new ChartReadout(
      () => {
        const { figure } = store_.state;
        return this.data_ && { data: this.data_, figure, unit: this.figureUnit_(), resolved: this.resolved_ };
      },
      (cell) => (store_.isDragging ? null : withValues(store_.state.design, this.valuesOf_(cell))),
    );
    this.box_.append(...this.panels_.map(({ surface: { canvas } }) => h("div", { class: "map" }, canvas)));
    this.element = h(
      "section",
      { "class": "panel chart", "aria-label": "Noise chart" },
      h(
        "div",
        { class: "above" },
        h("div", { class: "heading" }, h("h2", {}, "Noise chart"), this.status_, this.controls_.element),
        this.problem_,
        this.outside_,
        this.gaps_,
      ),
      this.box_,
      h("div", { class: "under" }, this.legend_.element, this.key_, this.readout_.element),
    );
    onLook(() => this.repaint());
    const stack = ({ clientWidth, clientHeight } = this.box_): boolean =>
      this.box_.classList.toggle("stacked", clientWidth < 430 && clientHeight > 300);
    new ResizeObserver(() => stack()).observe(this.box_);
  }

  get current(): ChartData | null {
    return this.data_;
  }

  /** Asks for what the state wants if that is not shown yet. */
  follow(state: State, step: Step): void {
    this.controls_.show(state, this.resolved_);
    const wish = this.wish_(state, step === "drag");
    const key = keyOf(wish);
    const same = key === this.shownKey_;
    if (!same || (this.wasPreview_ && !wish.preview)) {
      this.shownKey_ = key;
      this.wasPreview_ = wish.preview;
      if (wish.preview) this.requests_.ask(wish);
      else this.requests_.askNow(wish);
    }
    this.repaint();
  }

  /** The case is known as the program understands it. */
  know(simulation: Simulation): void {
    this.resolved_ = simulation.case;
    this.controls_.show(this.store_.state, this.resolved_);
    this.repaint();
  }

  /** Says that the design is not on the chart, and offers to widen it. */
  private seek_(): void {
    const { state } = this.store_;
    const here = this.design();
    const missed = (["x", "y"] as const).filter((name) => !holds(state[name], here[name]));
    this.outside_.hidden = missed.length === 0;
    const what = missed
      .map((name) => `${words(state[name].parameter)} ${quantity(here[name], this.unit_(state[name]))}`)
      .join(" and ");
    if (this.outside_.dataset.what === what) return;
    this.outside_.dataset.what = what;
    this.outside_.replaceChildren(
      `The design lies outside the chart: ${what}. `,
      button("Widen the chart", () => this.widen_(), { id: "widen" }),
    );
  }

  private widen_(): void {
    const { x, y } = this.store_.state;
    const here = this.design();
    const wide = (axis: Axis, value: number): Axis => {
      const field = this.start_.fields.find(({ key }) => key === axis.parameter);
      return widened(axis, value, field?.kind === "quantity" ? field : { low: null, high: null });
    };
    this.zooms_.push({ x, y });
    this.store_.update({ x: wide(x, here.x), y: wide(y, here.y) });
    this.panels_[0]?.surface.canvas.focus();
  }

  private unit_(axis: Axis): string {
    const field = this.start_.fields.find(({ key }) => key === axis.parameter);
    return field?.kind === "quantity" ? field.unit : "";
  }

  repaint(): void {
    this.seek_();
    this.describe_();
    for (const { surface } of this.panels_) surface.invalidate();
    this.legend_.show(this.data_, this.store_.state.figure, this.start_);
    const marks = this.marks();
    this.key_.hidden = marks.length < 2;
    setText(this.key_, inRow(marks.map(({ name }, k) => `${k + 1} ${name}`)));
    this.gaps_.hidden = !this.data_?.gaps;
    setText(this.gaps_, `Cells without a result, such as: ${gapText(this.data_?.gaps ?? "")}`);
  }

  /** Paints both directions with a palette of one's own, for a picture to keep. */
  paintOn(surface: Surface, direction: Direction, look: Look): void {
    if (this.data_) paintMap(surface, this.data_, direction, look);
  }

  lookOf(direction: Direction): Look {
    const { state } = this.store_;
    const stacked = this.box_.classList.contains("stacked");
    const cells = this.soFar_(direction);
    return {
      palette: palette(),
      title: (direction === "going" ? "going (V > 0)" : "coming (V < 0)") + (cells && `: ${cells} so far`),
      shortTitle: direction + (cells && `: ${cells}`),
      xTitle: this.axisTitle_(state.x),
      yTitle: direction === "going" || stacked ? this.axisTitle_(state.y) : "",
      chosen: direction === state.direction,
    };
  }

  /** Of a figure, its name and ends, and how far the chart is, so that a picture alone says what it shows. */
  caption(): string {
    const { computed, total } = this.box_.dataset;
    return this.range_() + (this.data_?.done === false ? `, ${computed} of ${total} cells computed` : "");
  }

  private figureUnit_(): string {
    return this.start_.figures.find(({ name }) => name === this.store_.state.figure)?.unit ?? "";
  }

  private range_(): string {
    if (!this.data_?.figure) return "";
    const { figure } = this.store_.state;
    const unit = this.figureUnit_();
    const [low, high] = this.data_.figureRange;
    return `: ${words(figure)} ${between(low, high, unit, " to ")}`;
  }

  // a chart on its way is computed one direction after the other where each has runs of its own
  private soFar_(direction: Direction): string {
    const { data_: data } = this;
    return !data || data.done ? "" : `${computedIn(data, direction) || "no"} cells`;
  }

  private wish_(state: State, preview: boolean): api.ChartWish {
    const chart = { x: state.x, y: state.y, refine: this.start_.chart.refine };
    const own = this.start_.presets.find(({ name }) => name === state.design.preset)?.case;
    const has = (key: string): boolean => !own || valueIn(own, key) !== undefined;
    return { design: chartDesign(state, has), chart, preview, figure: state.figure };
  }

  private axisTitle_(axis: Axis): string {
    const field = this.start_.fields.find(({ key }) => key === axis.parameter);
    const unit = unitText(writtenIn(this.unit_(axis), axis.to).unit);
    const sign = field?.symbol ? ` ${symbolText(field.symbol)}` : "";
    const whose = isOfJoints(this.resolved_, axis.parameter) ? " of all joints" : "";
    return title(axis.parameter) + sign + whose + (unit ? ` [${unit}]` : "");
  }

  private async fetch_(wish: api.ChartWish, signal: AbortSignal, shown: () => void): Promise<void> {
    const began = performance.now();
    this.box_.setAttribute("aria-busy", "true");
    try {
      let data: ChartData | null = null;
      for await (const frame of api.chart(wish, signal)) {
        data = merged(data, frame, wish.figure !== "category");
        if (!data) continue;
        this.data_ = data;
        this.dataKey_ = keyOf(wish);
        this.problem_.hidden = true;
        this.note_(frame, wish, performance.now() - began);
        for (const { surface } of this.panels_) surface.draw();
        this.repaint();
        shown();
      }
      if (!data?.done && !signal.aborted) throw Error("The program ended before the chart was complete.");
    } catch (error) {
      if (!api.isAbort(error)) {
        this.problem_.hidden = false;
        const isCut = performance.now() - began > longestAnswer && !(error instanceof api.Failure);
        setText(this.problem_, isCut ? tooLong : api.sentence(error));
        const { computed, total } = this.box_.dataset;
        if (this.data_?.done === false) setText(this.status_, `${computed} of ${total} cells run · stopped`);
        this.shownKey_ = "";
      }
    } finally {
      this.box_.setAttribute("aria-busy", "false");
    }
  }

  private note_(frame: ChartFrame, wish: api.ChartWish, took: number): void {
    const { dataset } = this.box_;
    dataset.computed = String(frame.computed);
    dataset.total = String(frame.total);
    dataset.round = String(frame.round);
    dataset.done = String(frame.done && !wish.preview);
    dataset.redraws = String(Number(dataset.redraws) + 1);
    if (frame.done) dataset.charts = String(Number(dataset.charts ?? 0) + 1);
    this.box_.style.setProperty("--progress", frame.done ? "0" : String(frame.computed / frame.total));
    const kind = wish.preview ? "preview" : frame.done ? "" : "refining";
    setText(
      this.status_,
      [`${frame.computed} of ${frame.total} cells run`, `${plain(took, 2)} ms`, kind].filter(Boolean).join(" · "),
    );
  }

  design(): Mark {
    return this.marks()[0] as Mark;
  }

  /** Where the design lies; of several joints with different values each one, with the names of those there. */
  marks(): Mark[] {
    const { state } = this.store_;
    const on = ({ parameter }: Axis): number[] => {
      const values = quantitiesOf(state, this.resolved_, parameter);
      return parameter === "drive.velocity" ? values.map(Math.abs) : values; // its sign is the direction
    };
    const [x, y] = [on(state.x), on(state.y)];
    const joints = jointsOf(this.resolved_).map(({ name }) => name);
    const marks: Mark[] = [];
    (joints.length > 0 ? joints : [""]).forEach((name, k) => {
      const mark = { name, x: x[k] ?? x[0] ?? NaN, y: y[k] ?? y[0] ?? NaN };
      const same = marks.find((each) => each.x === mark.x && each.y === mark.y);
      if (same) same.name += `, ${name}`;
      else marks.push(mark);
    });
    return marks.length > 1 ? marks : marks.map((mark) => ({ ...mark, name: "" }));
  }

  numbered(direction: Direction, isNumbered: boolean): void {
    if (isNumbered) this.numbered_.add(direction);
    else this.numbered_.delete(direction);
    this.key_.style.visibility = this.numbered_.size > 0 ? "visible" : "hidden"; // its line is kept: nothing jumps
  }

  hovered({ direction, hover }: ChartPanel): void {
    if (hover && this.data_) this.readout_.read({ direction, ...hover });
    else this.readout_.rest();
  }

  regard(direction: Direction): void {
    if (this.store_.state.direction !== direction) this.store_.update({ direction }, "replace");
  }

  /** Runs a cell: the design takes its two values. */
  choose(direction: Direction, cell: { ix: number; iy: number }, step: Step = "push"): void {
    if (!this.data_) return;
    const { state } = this.store_;
    this.store_.update({ design: withValues(state.design, this.valuesOf_({ direction, ...cell })), direction }, step);
  }

  private valuesOf_({ direction, ix, iy }: Cell): Record<string, string> {
    const { x, y } = this.store_.state;
    return {
      [x.parameter]: exact(this.data_?.x.values[ix] as number),
      [y.parameter]: exact(this.data_?.y.values[iy] as number),
      ...this.turned_(direction),
    };
  }

  /** Of a steady drive, the velocity that moves the plate in this direction. */
  private turned_(direction: Direction): Record<string, string> {
    if (!steadyDrives.some((kind) => kind === valueIn(this.resolved_, "drive.kind"))) return {};
    const speed = Math.abs(quantityOf(this.store_.state, this.resolved_, "drive.velocity"));
    return { "drive.velocity": exact(direction === "going" ? speed : -speed) };
  }

  zoom(across: [number, number], up: [number, number]): void {
    const { x, y } = this.store_.state;
    this.zooms_.push({ x, y });
    this.store_.update({ x: zoomed(x, ...across), y: zoomed(y, ...up) });
  }

  unzoom(): void {
    const last = this.zooms_.pop();
    const { state } = this.store_;
    const fits = last && last.x.parameter === state.x.parameter && last.y.parameter === state.y.parameter;
    if (fits) this.store_.update(last);
    else this.store_.update({ x: this.controls_.whole(state.x), y: this.controls_.whole(state.y) });
  }

  step(direction: Direction, dx: number, dy: number): void {
    if (!this.data_) return;
    const { x, y } = this.data_;
    const here = this.design();
    const ix = Math.min(Math.max(nearest(x.values, here.x, x.scale) + dx, 0), x.points - 1);
    const iy = Math.min(Math.max(nearest(y.values, here.y, y.scale) + dy, 0), y.points - 1);
    const now = performance.now();
    this.choose(direction, { ix, iy }, now - this.stepped_ < stepPause ? "replace" : "push");
    this.stepped_ = now;
  }

  zoomAbout(): void {
    if (!this.data_) return;
    const { x, y } = this.data_;
    const here = this.design();
    const part = (axis: typeof x, value: number): [number, number] => {
      const middle = nearest(axis.values, value, axis.scale) / (axis.points - 1);
      const low = Math.min(Math.max(middle - 0.25, 0), 0.5);
      return [low, low + 0.5];
    };
    this.zoom(part(x, here.x), part(y, here.y));
  }

  /** Says of each direction what its picture shows where the design is. */
  private describe_(): void {
    const { x, y } = this.store_.state;
    const here = this.design();
    const part = (axis: Axis, value: number): string => `${words(axis.parameter)} ${quantity(value, this.unit_(axis))}`;
    const at = `${part(x, here.x)}, ${part(y, here.y)}`;
    for (const { direction, surface } of this.panels_) {
      const label = `Noise chart, ${direction}. Cell at ${at}: ${this.wordOf_(direction, here)}`;
      if (surface.canvas.getAttribute("aria-label") !== label) surface.canvas.setAttribute("aria-label", label);
    }
  }

  private wordOf_(direction: Direction, { x, y }: Mark): string {
    const { data_: data } = this;
    if (!holds(this.store_.state.x, x) || !holds(this.store_.state.y, y)) return "outside the chart";
    const isKnown = Number.isFinite(x) && Number.isFinite(y) && this.dataKey_ === this.shownKey_;
    if (!data || !isKnown) return "not computed yet"; // the picture is of another design
    const [ix, iy] = [nearest(data.x.values, x, data.x.scale), nearest(data.y.values, y, data.y.scale)];
    return wordAt(data, indexOf(data, direction, ix, iy));
  }
}

/** What a chart depends on, however quickly it is wanted. */
function keyOf(wish: api.ChartWish): string {
  return JSON.stringify({ ...wish, preview: false });
}

/** What is wrong with a cell and why, without what to do about one; numbers with few digits. */
function gapText(message: string): string {
  return message.replace(/\)[^)]*$/, ")").replace(/\d+\.\d{5,}/g, (digits) => plain(Number(digits)));
}
