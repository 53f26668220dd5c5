/** Line plots: uPlot in the page's colours, as wide as its box. */
import uPlot from "uplot";
import type { Scale } from "../program/words.ts";
import { h } from "./dom.ts";
import { plain } from "./format.ts";
import { rows, ticks } from "./scale.ts";
import { font } from "./surface.ts";
import { onLook, palette } from "./theme.ts";

const legendHeight = 27; // [px] of one line

/** Marks of a logarithmic axis where ours have them. */
const decades: uPlot.Axis = {
  splits: (_, __, from, to) => ticks(from, to, "log"),
  filter: (_, splits) => splits,
};

export interface Curve {
  label: string;
  colour: 0 | 1 | 2 | 3 | "muted";
  values: (number | null)[];
  width?: number;
  dash?: number[];
  pointsOnly?: boolean;
}

export interface PlotContent {
  x: number[];
  xTitle: string;
  xScale?: Scale;
  yTitle: string;
  curves: Curve[];
  /** Upright lines with a word each. */
  marks?: { x: number; label: string }[];
  yRange?: [number, number];
  zeroLine?: boolean;
  /** Is told the x under the pointer; null: it is elsewhere. */
  point?: (x: number | null) => void;
}

export class Plot {
  readonly element: HTMLElement;
  private readonly host_ = h("div", { class: "plot-host" });
  private plot_: uPlot | null = null;
  private content_: PlotContent | null = null;

  constructor(private readonly name_: string) {
    this.element = h("div", { "class": "plot", "role": "img", "aria-label": name_, "data-plot": name_ }, this.host_);
    onLook(() => this.remake_());
    new ResizeObserver(() => this.resize_()).observe(this.host_);
  }

  show(content: PlotContent): void {
    this.content_ = content;
    this.remake_();
  }

  /** Says in words what the picture shows, for those who do not see it. */
  describe(text: string): void {
    this.element.setAttribute("aria-label", `${this.name_}: ${text}`);
  }

  private resize_(): void {
    if (!this.plot_) this.remake_();
    else if (this.host_.clientWidth > 40) this.plot_.setSize(this.size_());
  }

  private size_(): { width: number; height: number } {
    return { width: this.host_.clientWidth, height: Math.max(80, this.host_.clientHeight - legendHeight) };
  }

  private remake_(): void {
    this.plot_?.destroy();
    this.plot_ = null;
    const { content_: content } = this;
    if (!content || this.host_.clientWidth < 40) return;
    const data = [content.x, ...content.curves.map(({ values }) => values)] as uPlot.AlignedData;
    this.plot_ = new uPlot(this.options_(content), data, this.host_);
  }

  private options_(content: PlotContent): uPlot.Options {
    const colours = palette();
    const axis = (label: string, size: number): uPlot.Axis => ({
      label,
      labelSize: 18,
      labelFont: font(11),
      font: font(10),
      size,
      stroke: colours.muted,
      grid: { stroke: colours.grid, width: 1 },
      ticks: { stroke: colours.line, width: 1, size: 4 },
      values: (_, splits) => splits.map((value) => plain(value)),
    });
    const { yRange } = content;
    return {
      ...this.size_(),
      cursor: { drag: { x: true, y: false, setScale: true }, points: { size: 6 } },
      legend: { live: true },
      scales: {
        x: { time: false, distr: content.xScale === "log" ? 3 : 1, range: (_, from, to) => [from, to] },
        y: yRange ? { range: () => yRange } : {},
      },
      axes: [{ ...axis(content.xTitle, 32), ...(content.xScale === "log" ? decades : {}) }, axis(content.yTitle, 44)],
      series: [
        { label: content.xTitle, value: (_, value) => (value === null ? "–" : plain(value)) },
        ...content.curves.map((curve) => ({
          label: curve.label,
          stroke: curve.colour === "muted" ? colours.muted : colours.traces[curve.colour],
          width: curve.width ?? 1.4,
          spanGaps: false,
          ...(curve.dash ? { dash: curve.dash } : {}),
          ...(curve.pointsOnly
            ? { paths: () => null, points: { show: true, size: 3.5 } }
            : { points: { show: false } }),
          value: (_: uPlot, value: number | null) => (value === null || value === undefined ? "–" : plain(value)),
        })),
      ],
      hooks: {
        draw: [(plot) => this.drawMarks_(plot, content)],
        setCursor: [({ cursor: { left = -1 }, posToVal }) => content.point?.(left < 0 ? null : posToVal(left, "x"))],
      },
    };
  }

  private drawMarks_(plot: uPlot, content: PlotContent): void {
    const { ctx, bbox } = plot;
    const colours = palette();
    ctx.save();
    ctx.lineWidth = devicePixelRatio;
    if (content.zeroLine) {
      const y = plot.valToPos(0, "y", true);
      ctx.strokeStyle = colours.muted;
      stroke(ctx, bbox.left, y, bbox.left + bbox.width, y);
    }
    ctx.font = font(10 * devicePixelRatio);
    ctx.textAlign = "left";
    const rowOf = rows();
    const inOrder = [...(content.marks ?? [])].sort((a, b) => a.x - b.x);
    for (const { x, label } of inOrder) {
      const at = plot.valToPos(x, "x", true);
      if (at < bbox.left || at > bbox.left + bbox.width) continue;
      ctx.strokeStyle = colours.accent;
      ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
      stroke(ctx, at, bbox.top, at, bbox.top + bbox.height);
      ctx.fillStyle = colours.accent;
      const right = at > bbox.left + 0.7 * bbox.width;
      const width = ctx.measureText(label).width;
      const left = at + 5 * devicePixelRatio - (right ? width + 10 * devicePixelRatio : 0);
      ctx.fillText(label, left, bbox.top + (11 + 12 * rowOf(left, width)) * devicePixelRatio);
    }
    ctx.restore();
  }
}

function stroke(ctx: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
  ctx.beginPath();
  ctx.moveTo(x0, y0);
  ctx.lineTo(x1, y1);
  ctx.stroke();
}
