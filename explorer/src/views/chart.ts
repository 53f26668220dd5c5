/** The chart: two directions side by side, streamed as it is refined, followed while a slider is dragged. */
import * as api from "../data/api.ts";
import { valueIn } from "../data/cases.ts";
import { merged, type ChartData } from "../data/chart_data.ts";
import { Latest } from "../data/latest.ts";
import type { Case, ChartFrame, Simulation, Start } from "../data/types.ts";
import { button, h, setText } from "../draw/dom.ts";
import { between, exact, level, percent, plain, quantity, symbolText, title, unitText, words } from "../draw/format.ts";
import {
  cellAt,
  cellBox,
  indexOf,
  paintDesign,
  paintFrame,
  paintMap,
  plotBox,
  shareAt,
  type Look,
} from "../draw/map.ts";
import { holds, nearest, widened, zoomed } from "../draw/scale.ts";
import { surface, type Surface } from "../draw/surface.ts";
import { onTheme, palette } from "../draw/theme.ts";
import { chartKinds, steadyDrives, type Direction } from "../program/words.ts";
import { chartDesign, withValues, type Axis, type State } from "../state/state.ts";
import type { Step, Store } from "../state/store.ts";
import { AxisControls } from "./axis_controls.ts";
import { Legend } from "./legend.ts";
import { quantityOf } from "./parameters.ts";
import { phaseOf } from "./verdict.ts";

const stepPause = 1500; // [ms] arrow keys within it are one step of the history
const patience = 180; // [ms] how long a chart that follows a slider is refined when a newer one waits

interface Panel {
  direction: Direction;
  surface: Surface;
  hover: { ix: number; iy: number } | null;
  drag: { x0: number; y0: number; x1: number; y1: number } | null;
}

export class Chart {
  readonly element: HTMLElement;
  private readonly box_ = h("div", {
    "id": "chart",
    "class": "maps",
    "data-computed": 0,
    "data-done": "false",
    "data-redraws": 0,
  });
  private readonly readout_ = h("p", { id: "chart-readout", class: "readout" });
  private readonly status_ = h("span", { id: "chart-status", class: "muted" });
  private readonly problem_ = h("p", { class: "complaint", hidden: true, role: "alert" });
  private readonly outside_ = h("p", { class: "outside", id: "outside", role: "status", hidden: true });
  private readonly panels_: Panel[];
  private readonly controls_: AxisControls;
  private readonly legend_ = new Legend();
  private readonly zooms_: { x: Axis; y: Axis }[] = [];
  private readonly requests_ = new Latest<api.ChartWish>(
    (wish, signal, shown) => this.fetch_(wish, signal, shown),
    patience,
  );
  private readonly probe_ = new Latest<{ direction: Direction; ix: number; iy: number }>((wish, signal) =>
    this.look_(wish, signal),
  );
  private probeTimer_ = 0;
  private stepped_ = -Infinity; // [ms] when an arrow key last moved the cell
  private data_: ChartData | null = null;
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
    this.controls_ = new AxisControls(store_, start_, () => this.unzoom_(), complain);
    this.panels_ = (["going", "coming"] as const).map((direction) => this.panel_(direction));
    this.box_.append(...this.panels_.map(({ surface: { canvas } }) => h("div", { class: "map" }, canvas)));
    this.element = h(
      "section",
      { "class": "panel chart", "aria-label": "Noise chart" },
      h("div", { class: "heading" }, h("h2", {}, "Noise chart"), this.status_, this.controls_.element),
      this.problem_,
      this.outside_,
      this.box_,
      h("div", { class: "under" }, this.legend_.element, this.readout_),
    );
    onTheme(() => this.repaint());
    new ResizeObserver(() => this.box_.classList.toggle("stacked", this.box_.clientWidth < 430)).observe(this.box_);
    this.rest_();
  }

  get current(): ChartData | null {
    return this.data_;
  }

  /** Asks for what the state wants if that is not shown yet. */
  follow(state: State, step: Step): void {
    this.controls_.show(state, this.resolved_);
    const wish = this.wish_(state, step === "drag");
    const key = JSON.stringify({ ...wish, preview: false });
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
    this.describe_(simulation);
    this.repaint();
  }

  /** Says that the design is not on the chart, and offers to widen it. */
  private seek_(): void {
    const { state } = this.store_;
    const here = this.design_();
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
    const here = this.design_();
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
    for (const { surface } of this.panels_) surface.invalidate();
    this.legend_.show(this.data_, this.store_.state.figure, this.start_);
  }

  /** Paints both directions with a palette of one's own, for a picture to keep. */
  paintOn(surface: Surface, direction: Direction, look: Look): void {
    if (this.data_) paintMap(surface, this.data_, direction, look);
  }

  lookOf(direction: Direction): Look {
    const { state } = this.store_;
    const stacked = this.box_.classList.contains("stacked");
    return {
      palette: palette(),
      title: direction === "going" ? "going (V > 0)" : "coming (V < 0)",
      xTitle: this.axisTitle_(state.x),
      yTitle: direction === "going" || stacked ? this.axisTitle_(state.y) : "",
      chosen: direction === state.direction,
    };
  }

  /** Of a figure, its name and ends, so that a picture alone says what it shows. */
  range(): string {
    if (!this.data_?.figure) return "";
    const { figure } = this.store_.state;
    const unit = this.start_.figures.find(({ name }) => name === figure)?.unit ?? "";
    const [low, high] = this.data_.figureRange;
    return `: ${words(figure)} ${between(low, high, unit, " to ")}`;
  }

  private wish_(state: State, preview: boolean): api.ChartWish {
    const chart = { x: state.x, y: state.y, refine: this.start_.chart.refine };
    return { design: chartDesign(state), chart, preview, figure: state.figure };
  }

  private axisTitle_(axis: Axis): string {
    const field = this.start_.fields.find(({ key }) => key === axis.parameter);
    const unit = unitText(this.unit_(axis));
    const sign = field?.symbol ? ` ${symbolText(field.symbol)}` : "";
    return title(axis.parameter) + sign + (unit ? ` [${unit}]` : "");
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
        this.problem_.hidden = true;
        this.note_(frame, wish, performance.now() - began);
        for (const { surface } of this.panels_) surface.draw();
        this.legend_.show(data, wish.figure, this.start_);
        shown();
      }
    } catch (error) {
      if (!api.isAbort(error)) {
        this.problem_.hidden = false;
        setText(this.problem_, api.sentence(error));
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

  private design_(): { x: number; y: number } {
    const { state } = this.store_;
    const on = ({ parameter }: Axis): number => {
      const value = quantityOf(state, this.resolved_, parameter);
      return parameter === "drive.velocity" ? Math.abs(value) : value; // its sign is the direction
    };
    return { x: on(state.x), y: on(state.y) };
  }

  private panel_(direction: Direction): Panel {
    const canvas = h("canvas", {
      "tabindex": 0,
      "role": "application",
      "aria-roledescription": "chart",
      "data-direction": direction,
      "aria-label": `Noise chart, ${direction}`,
    });
    const panel: Panel = { direction, hover: null, drag: null, surface: surface(canvas, () => this.paint_(panel)) };
    canvas.addEventListener("pointerdown", (event) => this.press_(panel, event));
    canvas.addEventListener("pointermove", (event) => this.move_(panel, event));
    canvas.addEventListener("pointerup", (event) => this.release_(panel, event));
    canvas.addEventListener("pointercancel", () => this.letGo_(panel));
    canvas.addEventListener("pointerleave", () => this.leave_(panel));
    canvas.addEventListener("dblclick", () => this.unzoom_());
    canvas.addEventListener("keydown", (event) => this.key_(panel, event));
    canvas.addEventListener(
      "focus",
      () => this.store_.state.direction !== direction && this.store_.update({ direction }, "replace"),
    );
    return panel;
  }

  private paint_(panel: Panel): void {
    if (!this.data_) return;
    const look = this.lookOf(panel.direction);
    const box = plotBox(panel.surface, look);
    paintMap(panel.surface, this.data_, panel.direction, look);
    paintDesign(panel.surface, box, this.data_, this.design_(), look);
    if (panel.drag) {
      const { x0, y0, x1, y1 } = panel.drag;
      const area = {
        left: Math.min(x0, x1),
        top: Math.min(y0, y1),
        width: Math.abs(x1 - x0),
        height: Math.abs(y1 - y0),
      };
      paintFrame(panel.surface, area, look.palette);
    } else if (panel.hover) {
      paintFrame(panel.surface, cellBox(box, this.data_, panel.hover.ix, panel.hover.iy), look.palette);
    }
  }

  private press_(panel: Panel, event: PointerEvent): void {
    if (event.button !== 0) return;
    panel.surface.canvas.setPointerCapture(event.pointerId);
    panel.drag = { x0: event.offsetX, y0: event.offsetY, x1: event.offsetX, y1: event.offsetY };
  }

  private move_(panel: Panel, event: PointerEvent): void {
    if (!this.data_) return;
    if (panel.drag) {
      const box = plotBox(panel.surface, this.lookOf(panel.direction));
      panel.drag.x1 = Math.min(Math.max(event.offsetX, box.left), box.left + box.width);
      panel.drag.y1 = Math.min(Math.max(event.offsetY, box.top), box.top + box.height);
    } else {
      const box = plotBox(panel.surface, this.lookOf(panel.direction));
      panel.hover = cellAt(box, this.data_, event.offsetX, event.offsetY);
      this.read_(panel);
    }
    panel.surface.invalidate();
  }

  private release_(panel: Panel, event: PointerEvent): void {
    const drag = panel.drag;
    panel.drag = null;
    panel.surface.invalidate();
    if (!drag || !this.data_ || event.button !== 0) return;
    const box = plotBox(panel.surface, this.lookOf(panel.direction));
    if (Math.abs(drag.x1 - drag.x0) > 6 && Math.abs(drag.y1 - drag.y0) > 6) {
      const across = [drag.x0, drag.x1].map((x) => shareAt((x - box.left) / box.width, this.data_?.x.points ?? 2));
      const up = [drag.y0, drag.y1].map((y) => shareAt(1 - (y - box.top) / box.height, this.data_?.y.points ?? 2));
      this.zoom_(across as [number, number], up as [number, number]);
      return;
    }
    const cell = cellAt(box, this.data_, drag.x0, drag.y0);
    if (cell) this.choose_(panel.direction, cell.ix, cell.iy, "push");
  }

  private letGo_(panel: Panel): void {
    panel.drag = null;
    panel.surface.invalidate();
  }

  private leave_(panel: Panel): void {
    panel.hover = null;
    this.rest_();
    panel.surface.invalidate();
  }

  /** Runs a cell: the design takes its two values. */
  private choose_(direction: Direction, ix: number, iy: number, step: Step): void {
    if (!this.data_) return;
    const { state } = this.store_;
    const values: Record<string, string> = {
      [state.x.parameter]: exact(this.data_.x.values[ix] as number),
      [state.y.parameter]: exact(this.data_.y.values[iy] as number),
      ...this.turned_(direction),
    };
    this.store_.update({ design: withValues(state.design, values), direction }, step);
  }

  /** Of a steady drive, the velocity that moves the plate in this direction. */
  private turned_(direction: Direction): Record<string, string> {
    if (!steadyDrives.some((kind) => kind === valueIn(this.resolved_, "drive.kind"))) return {};
    const speed = Math.abs(quantityOf(this.store_.state, this.resolved_, "drive.velocity"));
    return { "drive.velocity": exact(direction === "going" ? speed : -speed) };
  }

  private zoom_(across: [number, number], up: [number, number]): void {
    const { x, y } = this.store_.state;
    this.zooms_.push({ x, y });
    this.store_.update({ x: zoomed(x, ...across), y: zoomed(y, ...up) });
  }

  private unzoom_(): void {
    const last = this.zooms_.pop();
    const { state } = this.store_;
    const fits = last && last.x.parameter === state.x.parameter && last.y.parameter === state.y.parameter;
    if (fits) this.store_.update(last);
    else this.store_.update({ x: this.controls_.whole(state.x), y: this.controls_.whole(state.y) });
  }

  private key_(panel: Panel, event: KeyboardEvent): void {
    if (!this.data_ || event.ctrlKey || event.metaKey || event.altKey) return;
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const by = moves[event.key];
    if (by) this.step_(panel, by[0] * (event.shiftKey ? 8 : 1), by[1] * (event.shiftKey ? 8 : 1));
    else if (event.key === "+" || event.key === "=") this.zoomAbout_();
    else if (event.key === "-" || event.key === "0") this.unzoom_();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private step_(panel: Panel, dx: number, dy: number): void {
    if (!this.data_) return;
    const { x, y } = this.data_;
    const here = this.design_();
    const ix = Math.min(Math.max(nearest(x.values, here.x, x.scale) + dx, 0), x.points - 1);
    const iy = Math.min(Math.max(nearest(y.values, here.y, y.scale) + dy, 0), y.points - 1);
    const now = performance.now();
    this.choose_(panel.direction, ix, iy, now - this.stepped_ < stepPause ? "replace" : "push");
    this.stepped_ = now;
  }

  private zoomAbout_(): void {
    if (!this.data_) return;
    const { x, y } = this.data_;
    const here = this.design_();
    const part = (axis: typeof x, value: number): [number, number] => {
      const middle = nearest(axis.values, value, axis.scale) / (axis.points - 1);
      const low = Math.min(Math.max(middle - 0.25, 0), 0.5);
      return [low, low + 0.5];
    };
    this.zoom_(part(x, here.x), part(y, here.y));
  }

  private rest_(): void {
    clearTimeout(this.probeTimer_);
    this.probe_.cancel();
    setText(this.readout_, "Click a cell to run it, drag a rectangle to zoom; arrow keys move the cell.");
  }

  /** Says what the chart knows of the cell at once, and its figures after a moment's rest. */
  private read_(panel: Panel): void {
    clearTimeout(this.probeTimer_);
    this.probe_.cancel();
    if (!panel.hover || !this.data_) return this.rest_();
    const { ix, iy } = panel.hover;
    setText(this.readout_, this.cellText_(panel.direction, ix, iy));
    this.probeTimer_ = window.setTimeout(() => this.probe_.askNow({ direction: panel.direction, ix, iy }), 140);
  }

  private cellText_(direction: Direction, ix: number, iy: number): string {
    const data = this.data_ as ChartData;
    const index = indexOf(data, direction, ix, iy);
    const part = (axis: ChartData["x"], i: number): string =>
      `${words(axis.parameter)} ${quantity(axis.values[i], axis.unit)}`;
    const category = chartKinds[data.category[index] as number] ?? "no result";
    const figure = data.figure ? `${words(this.store_.state.figure)} ${plain(data.figure[index] as number)}` : "";
    const source = data.computed ? (data.computed[index] ? "" : "inferred") : "";
    return [direction, part(data.x, ix), part(data.y, iy), category, figure, source].filter(Boolean).join(" · ");
  }

  private async look_(cell: { direction: Direction; ix: number; iy: number }, signal: AbortSignal): Promise<void> {
    const { state } = this.store_;
    if (!this.data_ || this.store_.isDragging) return;
    const values = {
      [state.x.parameter]: exact(this.data_.x.values[cell.ix] as number),
      [state.y.parameter]: exact(this.data_.y.values[cell.iy] as number),
      ...this.turned_(cell.direction),
    };
    try {
      const simulation = await api.simulate(withValues(state.design, values), signal);
      const phase = phaseOf(simulation, cell.direction);
      if (!phase || signal.aborted) return;
      const { judged_rates: shares, frequency, regularity, levels } = phase.verdict;
      const figures = [
        `slip ${percent(shares.slip)} stick ${percent(shares.stick)} separation ${percent(shares.separation)}`,
        frequency ? quantity(frequency, "Hz") : "",
        regularity === null ? "" : `regularity ${plain(regularity, 3)}`,
        `joint ${level(levels.joint.level)} re 1 nm/s`,
      ];
      setText(
        this.readout_,
        [this.cellText_(cell.direction, cell.ix, cell.iy), ...figures].filter(Boolean).join(" · "),
      );
    } catch (error) {
      if (!api.isAbort(error)) setText(this.readout_, api.sentence(error));
    }
  }

  private describe_(simulation: Simulation): void {
    const { x, y } = this.store_.state;
    const here = this.design_();
    for (const panel of this.panels_) {
      const phase = phaseOf(simulation, panel.direction);
      const at = `${words(x.parameter)} ${plain(here.x)}, ${words(y.parameter)} ${plain(here.y)}`;
      const label = `Noise chart, ${panel.direction}. Cell at ${at}: ${phase?.verdict.category ?? "no result"}`;
      panel.surface.canvas.setAttribute("aria-label", label);
    }
  }
}
