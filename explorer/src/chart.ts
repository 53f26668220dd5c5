/** The chart: two directions side by side, streamed as it is refined, followed while a slider is dragged. */
import * as api from "./api.ts";
import { AxisControls } from "./axis_controls.ts";
import { categories } from "./colours.ts";
import { h, setText } from "./dom.ts";
import { exact, percent, plain, quantity, symbolText, title, unitText, words } from "./format.ts";
import { bytesOf, floatsOf } from "./frames.ts";
import { Latest } from "./latest.ts";
import { Legend } from "./legend.ts";
import { cellAt, cellBox, indexOf, paintDesign, paintFrame, paintMap, plotBox, type ChartData, type Look } from "./map.ts";
import { quantityOf } from "./parameters.ts";
import { nearest, zoomed } from "./scale.ts";
import { shareAt } from "./map.ts";
import { chartDesign, withValues, type State } from "./state.ts";
import type { Step, Store } from "./store.ts";
import { surface, type Surface } from "./surface.ts";
import { onTheme, palette } from "./theme.ts";
import type { Axis, Case, ChartFrame, Direction, Simulation, Start } from "./types.ts";
import { phaseOf } from "./verdict.ts";

const patience = 180; // [ms] a chart that follows a slider may take this long before a newer one replaces it

interface Panel {
  direction: Direction;
  surface: Surface;
  hover: { ix: number; iy: number } | null;
  drag: { x0: number; y0: number; x1: number; y1: number } | null;
}

export class Chart {
  readonly element: HTMLElement;
  private readonly box = h("div", { id: "chart", class: "maps", "data-computed": 0, "data-done": "false", "data-redraws": 0 });
  private readonly readout = h("p", { id: "chart-readout", class: "readout" });
  private readonly status = h("span", { id: "chart-status", class: "muted" });
  private readonly problem = h("p", { class: "complaint", hidden: true, role: "alert" });
  private readonly panels: Panel[];
  private readonly controls: AxisControls;
  private readonly legend = new Legend();
  private readonly zooms: { x: Axis; y: Axis }[] = [];
  private readonly requests = new Latest<api.ChartWish>((wish, signal) => this.fetch(wish, signal), patience);
  private readonly probe = new Latest<{ direction: Direction; ix: number; iy: number }>((wish, signal) => this.look(wish, signal));
  private probeTimer = 0;
  private data: ChartData | null = null;
  private shownKey = "";
  private wasPreview = false;
  private resolved: Case;

  constructor(
    private readonly store: Store,
    private readonly start: Start,
  ) {
    this.resolved = (start.presets.find(({ name }) => name === store.state.design.preset) ?? start.presets[0])?.case as Case;
    this.controls = new AxisControls(store, start, () => this.unzoom());
    this.panels = (["going", "coming"] as const).map((direction) => this.panel(direction));
    this.box.append(...this.panels.map(({ surface: { canvas } }) => h("div", { class: "map" }, canvas)));
    this.element = h(
      "section",
      { class: "panel chart", "aria-label": "Noise chart" },
      h("div", { class: "heading" }, h("h2", {}, "Noise chart"), this.status, this.controls.element),
      this.problem,
      this.box,
      h("div", { class: "under" }, this.legend.element, this.readout),
    );
    onTheme(() => this.repaint());
    new ResizeObserver(() => this.box.classList.toggle("stacked", this.box.clientWidth < 430)).observe(this.box);
    this.rest();
  }

  get current(): ChartData | null {
    return this.data;
  }

  /** Asks for what the state wants if that is not shown yet. */
  follow(state: State, step: Step): void {
    this.controls.show(state, this.resolved);
    const wish = this.wish(state, step === "drag");
    const key = JSON.stringify({ ...wish, preview: false });
    const same = key === this.shownKey;
    if (!same || (this.wasPreview && !wish.preview)) {
      this.shownKey = key;
      this.wasPreview = wish.preview;
      if (wish.preview) this.requests.ask(wish);
      else this.requests.askNow(wish);
    }
    this.repaint();
  }

  /** The case is known as the program understands it. */
  know(simulation: Simulation): void {
    this.resolved = simulation.case;
    this.controls.show(this.store.state, this.resolved);
    this.describe(simulation);
    this.repaint();
  }

  repaint(): void {
    for (const { surface } of this.panels) surface.invalidate();
    this.legend.show(this.data, this.store.state.figure, this.start);
  }

  /** Paints both directions with a palette of one's own, for a picture to keep. */
  paintOn(surface: Surface, direction: Direction, look: Look): void {
    if (this.data) paintMap(surface, this.data, direction, look);
  }

  look_(direction: Direction): Look {
    const { state } = this.store;
    const stacked = this.box.classList.contains("stacked");
    return {
      palette: palette(),
      title: direction === "going" ? "going (V > 0)" : "coming (V < 0)",
      xTitle: this.axisTitle(state.x),
      yTitle: direction === "going" || stacked ? this.axisTitle(state.y) : "",
      chosen: direction === state.direction,
    };
  }

  private wish(state: State, preview: boolean): api.ChartWish {
    const chart = { x: state.x, y: state.y, refine: this.start.chart.refine };
    return { design: chartDesign(state), chart, preview, figure: state.figure };
  }

  private axisTitle(axis: Axis): string {
    const field = this.start.fields.find(({ key }) => key === axis.parameter);
    const unit = field?.kind === "quantity" ? unitText(field.unit) : "";
    const sign = field?.symbol ? ` ${symbolText(field.symbol)}` : "";
    return title(axis.parameter) + sign + (unit ? ` [${unit}]` : "");
  }

  private async fetch(wish: api.ChartWish, signal: AbortSignal): Promise<void> {
    const began = performance.now();
    this.box.setAttribute("aria-busy", "true");
    try {
      let data: ChartData | null = null;
      for await (const frame of api.chart(wish, signal)) {
        data = this.merged(data, frame, wish);
        if (!data) continue;
        this.data = data;
        this.problem.hidden = true;
        this.note(frame, wish, performance.now() - began);
        for (const { surface } of this.panels) surface.draw();
        this.legend.show(data, wish.figure, this.start);
      }
    } catch (error) {
      if (!api.isAbort(error)) {
        this.problem.hidden = false;
        setText(this.problem, api.sentence(error));
        this.shownKey = "";
      }
    } finally {
      this.box.setAttribute("aria-busy", "false");
    }
  }

  private merged(before: ChartData | null, frame: ChartFrame, wish: api.ChartWish): ChartData | null {
    const x = frame.x ?? before?.x;
    const y = frame.y ?? before?.y;
    if (!x || !y) return null;
    const figure = wish.figure !== "category" && frame.figure ? floatsOf(frame.figure) : null;
    return {
      x,
      y,
      directions: frame.directions ?? before?.directions,
      category: bytesOf(frame.category),
      computed: frame.computed_mask ? bytesOf(frame.computed_mask) : null,
      figure,
      figureRange: figure ? rangeOf(figure) : [0, 1],
      boundaries: frame.boundaries ?? [],
      done: frame.done,
    };
  }

  private note(frame: ChartFrame, wish: api.ChartWish, took: number): void {
    const { dataset } = this.box;
    dataset.computed = String(frame.computed);
    dataset.total = String(frame.total);
    dataset.round = String(frame.round);
    dataset.done = String(frame.done && !wish.preview);
    dataset.redraws = String(Number(dataset.redraws) + 1);
    if (frame.done) dataset.charts = String(Number(dataset.charts ?? 0) + 1);
    this.box.style.setProperty("--progress", frame.done ? "0" : String(frame.computed / frame.total));
    const kind = wish.preview ? "preview" : frame.done ? "" : "refining";
    setText(this.status, [`${frame.computed} of ${frame.total} cells run`, `${plain(took, 2)} ms`, kind].filter(Boolean).join(" · "));
  }

  private design(): { x: number; y: number } {
    const { state } = this.store;
    return {
      x: quantityOf(state, this.resolved, state.x.parameter),
      y: quantityOf(state, this.resolved, state.y.parameter),
    };
  }

  private panel(direction: Direction): Panel {
    const canvas = h("canvas", {
      tabindex: 0,
      role: "application",
      "aria-roledescription": "chart",
      "data-direction": direction,
      "aria-label": `Noise chart, ${direction}`,
    });
    const panel: Panel = { direction, hover: null, drag: null, surface: surface(canvas, () => this.paint(panel)) };
    canvas.addEventListener("pointerdown", (event) => this.press(panel, event));
    canvas.addEventListener("pointermove", (event) => this.move(panel, event));
    canvas.addEventListener("pointerup", (event) => this.release(panel, event));
    canvas.addEventListener("pointercancel", () => this.letGo(panel));
    canvas.addEventListener("pointerleave", () => this.leave(panel));
    canvas.addEventListener("dblclick", () => this.unzoom());
    canvas.addEventListener("keydown", (event) => this.key(panel, event));
    canvas.addEventListener("focus", () => this.store.state.direction !== direction && this.store.update({ direction }, "replace"));
    return panel;
  }

  private paint(panel: Panel): void {
    if (!this.data) return;
    const look = this.look_(panel.direction);
    const box = plotBox(panel.surface, look);
    paintMap(panel.surface, this.data, panel.direction, look);
    paintDesign(panel.surface, box, this.data, this.design(), look);
    if (panel.drag) {
      const { x0, y0, x1, y1 } = panel.drag;
      const area = { left: Math.min(x0, x1), top: Math.min(y0, y1), width: Math.abs(x1 - x0), height: Math.abs(y1 - y0) };
      paintFrame(panel.surface, area, look.palette);
    } else if (panel.hover) {
      paintFrame(panel.surface, cellBox(box, this.data, panel.hover.ix, panel.hover.iy), look.palette);
    }
  }

  private press(panel: Panel, event: PointerEvent): void {
    if (event.button !== 0) return;
    panel.surface.canvas.setPointerCapture(event.pointerId);
    panel.drag = { x0: event.offsetX, y0: event.offsetY, x1: event.offsetX, y1: event.offsetY };
  }

  private move(panel: Panel, event: PointerEvent): void {
    if (!this.data) return;
    if (panel.drag) {
      const box = plotBox(panel.surface, this.look_(panel.direction));
      panel.drag.x1 = Math.min(Math.max(event.offsetX, box.left), box.left + box.width);
      panel.drag.y1 = Math.min(Math.max(event.offsetY, box.top), box.top + box.height);
    } else {
      const box = plotBox(panel.surface, this.look_(panel.direction));
      panel.hover = cellAt(box, this.data, event.offsetX, event.offsetY);
      this.read(panel);
    }
    panel.surface.invalidate();
  }

  private release(panel: Panel, event: PointerEvent): void {
    const drag = panel.drag;
    panel.drag = null;
    panel.surface.invalidate();
    if (!drag || !this.data || event.button !== 0) return;
    const box = plotBox(panel.surface, this.look_(panel.direction));
    if (Math.abs(drag.x1 - drag.x0) > 6 && Math.abs(drag.y1 - drag.y0) > 6) {
      const across = [drag.x0, drag.x1].map((x) => shareAt((x - box.left) / box.width, this.data?.x.points ?? 2));
      const up = [drag.y0, drag.y1].map((y) => shareAt(1 - (y - box.top) / box.height, this.data?.y.points ?? 2));
      this.zoom(across as [number, number], up as [number, number]);
      return;
    }
    const cell = cellAt(box, this.data, drag.x0, drag.y0);
    if (cell) this.choose(panel.direction, cell.ix, cell.iy, "push");
  }

  private letGo(panel: Panel): void {
    panel.drag = null;
    panel.surface.invalidate();
  }

  private leave(panel: Panel): void {
    panel.hover = null;
    this.rest();
    panel.surface.invalidate();
  }

  /** Runs a cell: the design takes its two values. */
  private choose(direction: Direction, ix: number, iy: number, step: Step): void {
    if (!this.data) return;
    const { state } = this.store;
    const values: Record<string, string> = {
      [state.x.parameter]: exact(this.data.x.values[ix] as number),
      [state.y.parameter]: exact(this.data.y.values[iy] as number),
      ...this.turned(direction),
    };
    this.store.update({ design: withValues(state.design, values), direction }, step);
  }

  /** Of a constant drive, the velocity that moves the plate in this direction. */
  private turned(direction: Direction): Record<string, string> {
    const drive = this.resolved.drive;
    if (typeof drive !== "object" || drive.kind !== "constant") return {};
    const speed = Math.abs(quantityOf(this.store.state, this.resolved, "drive.velocity"));
    return { "drive.velocity": exact(direction === "going" ? speed : -speed) };
  }

  private zoom(across: [number, number], up: [number, number]): void {
    const { x, y } = this.store.state;
    this.zooms.push({ x, y });
    this.store.update({ x: zoomed(x, ...across), y: zoomed(y, ...up) });
  }

  private unzoom(): void {
    const last = this.zooms.pop();
    const { state } = this.store;
    const fits = last && last.x.parameter === state.x.parameter && last.y.parameter === state.y.parameter;
    if (fits) this.store.update(last);
    else this.store.update({ x: this.controls.whole(state.x), y: this.controls.whole(state.y) });
  }

  private key(panel: Panel, event: KeyboardEvent): void {
    if (!this.data || event.ctrlKey || event.metaKey || event.altKey) return;
    const moves: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const by = moves[event.key];
    if (by) this.step(panel, by[0] * (event.shiftKey ? 8 : 1), by[1] * (event.shiftKey ? 8 : 1));
    else if (event.key === "+" || event.key === "=") this.zoomAbout();
    else if (event.key === "-" || event.key === "0") this.unzoom();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private step(panel: Panel, dx: number, dy: number): void {
    if (!this.data) return;
    const { x, y } = this.data;
    const here = this.design();
    const ix = Math.min(Math.max(nearest(x.values, here.x, x.scale) + dx, 0), x.points - 1);
    const iy = Math.min(Math.max(nearest(y.values, here.y, y.scale) + dy, 0), y.points - 1);
    this.choose(panel.direction, ix, iy, "replace");
  }

  private zoomAbout(): void {
    if (!this.data) return;
    const { x, y } = this.data;
    const here = this.design();
    const part = (axis: typeof x, value: number): [number, number] => {
      const middle = nearest(axis.values, value, axis.scale) / (axis.points - 1);
      const low = Math.min(Math.max(middle - 0.25, 0), 0.5);
      return [low, low + 0.5];
    };
    this.zoom(part(x, here.x), part(y, here.y));
  }

  private rest(): void {
    clearTimeout(this.probeTimer);
    this.probe.cancel();
    setText(this.readout, "Click a cell to run it, drag a rectangle to zoom; arrow keys move the cell.");
  }

  /** Says what the chart knows of the cell at once, and its figures after a moment's rest. */
  private read(panel: Panel): void {
    clearTimeout(this.probeTimer);
    this.probe.cancel();
    if (!panel.hover || !this.data) return this.rest();
    const { ix, iy } = panel.hover;
    setText(this.readout, this.cellText(panel.direction, ix, iy));
    this.probeTimer = window.setTimeout(() => this.probe.ask({ direction: panel.direction, ix, iy }), 140);
  }

  private cellText(direction: Direction, ix: number, iy: number): string {
    const data = this.data as ChartData;
    const index = indexOf(data, direction, ix, iy);
    const part = (axis: ChartData["x"], i: number): string => `${words(axis.parameter)} ${quantity(axis.values[i], axis.unit)}`;
    const category = categories[data.category[index] as number] ?? "no result";
    const figure = data.figure ? `${words(this.store.state.figure)} ${plain(data.figure[index] as number)}` : "";
    const source = data.computed ? (data.computed[index] ? "" : "inferred") : "";
    return [direction, part(data.x, ix), part(data.y, iy), category, figure, source].filter(Boolean).join(" · ");
  }

  private async look(cell: { direction: Direction; ix: number; iy: number }, signal: AbortSignal): Promise<void> {
    const { state } = this.store;
    if (!this.data || this.store.isDragging) return;
    const values = {
      [state.x.parameter]: exact(this.data.x.values[cell.ix] as number),
      [state.y.parameter]: exact(this.data.y.values[cell.iy] as number),
      ...this.turned(cell.direction),
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
        quantity(levels.plate.level, "dB", 4),
      ];
      setText(this.readout, [this.cellText(cell.direction, cell.ix, cell.iy), ...figures].filter(Boolean).join(" · "));
    } catch (error) {
      if (!api.isAbort(error)) setText(this.readout, api.sentence(error));
    }
  }

  private describe(simulation: Simulation): void {
    const { x, y } = this.store.state;
    const here = this.design();
    for (const panel of this.panels) {
      const phase = phaseOf(simulation, panel.direction);
      const at = `${words(x.parameter)} ${plain(here.x)}, ${words(y.parameter)} ${plain(here.y)}`;
      const label = `Noise chart, ${panel.direction}. Cell at ${at}: ${phase?.verdict.category ?? "no result"}`;
      panel.surface.canvas.setAttribute("aria-label", label);
    }
  }
}

function rangeOf(values: Float32Array): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values)
    if (Number.isFinite(value)) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  return low <= high ? [low, high] : [0, 1];
}
