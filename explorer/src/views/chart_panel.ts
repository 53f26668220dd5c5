/** The map of one direction: its canvas, what is under the pointer, and what hands do on it. */
import type { ChartData } from "../data/chart_data.ts";
import { h } from "../draw/dom.ts";
import {
  cellAt,
  cellBox,
  paintDesigns,
  paintFrame,
  paintMap,
  plotBox,
  shareAt,
  type Look,
  type Mark,
} from "../draw/map.ts";
import { surface, type Surface } from "../draw/surface.ts";
import type { Direction } from "../program/words.ts";

/** What the chart shows in its panels, and what it does when a hand asks for it. */
export interface PanelOwner {
  readonly current: ChartData | null;
  lookOf(direction: Direction): Look;
  /** Where the design is on the axes; of several joints with different values each. */
  marks(): Mark[];
  /** Do its marks have numbers in the place of their names? */
  numbered(direction: Direction, isNumbered: boolean): void;
  hovered(panel: ChartPanel): void;
  choose(direction: Direction, cell: { ix: number; iy: number }): void;
  zoom(across: [number, number], up: [number, number]): void;
  unzoom(): void;
  step(direction: Direction, dx: number, dy: number): void;
  zoomAbout(): void;
  regard(direction: Direction): void;
}

export class ChartPanel {
  readonly surface: Surface;
  hover: { ix: number; iy: number } | null = null;
  private drag_: { x0: number; y0: number; x1: number; y1: number } | null = null;

  constructor(
    readonly direction: Direction,
    private readonly owner_: PanelOwner,
  ) {
    const canvas = h("canvas", {
      "tabindex": 0,
      "role": "application",
      "aria-roledescription": "chart",
      "data-direction": direction,
      "aria-label": `Noise chart, ${direction}`,
    });
    this.surface = surface(canvas, () => this.paint_());
    canvas.addEventListener("pointerdown", (event) => this.press_(event));
    canvas.addEventListener("pointermove", (event) => this.move_(event));
    canvas.addEventListener("pointerup", (event) => this.release_(event));
    canvas.addEventListener("pointercancel", () => this.letGo_());
    canvas.addEventListener("pointerleave", () => this.leave_());
    canvas.addEventListener("dblclick", () => owner_.unzoom());
    canvas.addEventListener("keydown", (event) => this.key_(event));
    canvas.addEventListener("focus", () => owner_.regard(direction));
  }

  private paint_(): void {
    const data = this.owner_.current;
    if (!data) return;
    const look = this.owner_.lookOf(this.direction);
    const box = plotBox(this.surface, look);
    paintMap(this.surface, data, this.direction, look);
    this.owner_.numbered(this.direction, paintDesigns(this.surface, box, data, this.owner_.marks(), look));
    if (this.drag_) {
      const { x0, y0, x1, y1 } = this.drag_;
      const area = {
        left: Math.min(x0, x1),
        top: Math.min(y0, y1),
        width: Math.abs(x1 - x0),
        height: Math.abs(y1 - y0),
      };
      paintFrame(this.surface, area, look.palette);
    } else if (this.hover) {
      paintFrame(this.surface, cellBox(box, data, this.hover.ix, this.hover.iy), look.palette);
    }
  }

  private press_(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.surface.canvas.setPointerCapture(event.pointerId);
    this.drag_ = { x0: event.offsetX, y0: event.offsetY, x1: event.offsetX, y1: event.offsetY };
  }

  private move_(event: PointerEvent): void {
    const data = this.owner_.current;
    if (!data) return;
    const box = plotBox(this.surface, this.owner_.lookOf(this.direction));
    if (this.drag_) {
      this.drag_.x1 = Math.min(Math.max(event.offsetX, box.left), box.left + box.width);
      this.drag_.y1 = Math.min(Math.max(event.offsetY, box.top), box.top + box.height);
    } else {
      this.hover = cellAt(box, data, event.offsetX, event.offsetY);
      this.owner_.hovered(this);
    }
    this.surface.invalidate();
  }

  private release_(event: PointerEvent): void {
    const data = this.owner_.current;
    const drag = this.drag_;
    this.drag_ = null;
    this.surface.invalidate();
    if (!drag || !data || event.button !== 0) return;
    const box = plotBox(this.surface, this.owner_.lookOf(this.direction));
    if (Math.abs(drag.x1 - drag.x0) > 6 && Math.abs(drag.y1 - drag.y0) > 6) {
      const across = [drag.x0, drag.x1].map((x) => shareAt((x - box.left) / box.width, data.x.points));
      const up = [drag.y0, drag.y1].map((y) => shareAt(1 - (y - box.top) / box.height, data.y.points));
      this.owner_.zoom(across as [number, number], up as [number, number]);
      return;
    }
    const cell = cellAt(box, data, drag.x0, drag.y0);
    if (cell) this.owner_.choose(this.direction, cell);
  }

  private letGo_(): void {
    this.drag_ = null;
    this.surface.invalidate();
  }

  private leave_(): void {
    this.hover = null;
    this.owner_.hovered(this);
    this.surface.invalidate();
  }

  private key_(event: KeyboardEvent): void {
    if (!this.owner_.current || event.ctrlKey || event.metaKey || event.altKey) return;
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const by = moves[event.key];
    const far = event.shiftKey ? 8 : 1;
    if (by) this.owner_.step(this.direction, by[0] * far, by[1] * far);
    else if (event.key === "+" || event.key === "=") this.owner_.zoomAbout();
    else if (event.key === "-" || event.key === "0") this.owner_.unzoom();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
