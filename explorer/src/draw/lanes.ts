/** Time histories below each other on one canvas, with the contacts' states above them. Painting only. */
import type { Motion } from "../data/frames.ts";
import { columns, pyramid, type Pyramid } from "../data/pyramid.ts";
import { bandsHeight, heightAround, marginLeft, marginRight, paintBands } from "./bands.ts";
import type { Palette } from "./colours.ts";
import { toldApart, unitText, writtenIn } from "./format.ts";
import type { LaneSpec } from "./lane_specs.ts";
import { ticks, ticksOfScale } from "./scale.ts";
import { font, type Surface } from "./surface.ts";

const axisHeight = 20;
const titleHeight = 17; // of a lane, above its curves

export interface LanesView {
  span: readonly [number, number];
  lanes: readonly LaneSpec[];
  playhead: number;
  hover: number | null; // [s]
  palette: Palette;
  /** Of many contacts the one whose lanes are shown. */
  chosen: number;
}

/** Pyramids of a motion's columns, made when first looked at. */
export class Pyramids {
  private readonly made_ = new Map<string, Pyramid>();

  constructor(readonly motion: Motion) {}

  of(column: string): Pyramid | null {
    const known = this.made_.get(column);
    if (known) return known;
    const values = this.motion.columns.get(column)?.values;
    if (!values) return null;
    const tree = pyramid(values);
    this.made_.set(column, tree);
    return tree;
  }
}

const leastLane = 64; // [px] of height, below which a lane shows nothing

/** How many lanes a canvas has room for. */
export function mostLanes(motion: Motion, height: number): number {
  return Math.floor((height - bandsHeight(motion, height) - axisHeight) / leastLane);
}

/** The least height of a canvas with so many lanes; where there is less, it scrolls. */
export function leastHeight(motion: Motion, lanes: number): number {
  return heightAround(motion, axisHeight + leastLane * lanes);
}

export function timeAt(surface: { width: number }, span: readonly [number, number], x: number): number {
  return span[0] + ((span[1] - span[0]) * (x - marginLeft)) / (surface.width - marginLeft - marginRight);
}

export function paintLanes(surface: Surface, trees: Pyramids, view: LanesView): void {
  const { pen, width, height } = surface;
  const inner = width - marginLeft - marginRight;
  if (inner < 20) return;
  const x = (time: number): number => marginLeft + (inner * (time - view.span[0])) / (view.span[1] - view.span[0]);
  paintBands(surface, trees.motion, view, inner);
  const bands = bandsHeight(trees.motion, height);
  const room = (height - bands - axisHeight) / Math.max(view.lanes.length, 1);
  paintTimes(surface, view, x, bands);
  view.lanes.forEach((lane, k) =>
    paintLane(surface, trees, view, lane, { top: bands + k * room + 6, height: room - 10, inner }),
  );
  pen.lineWidth = 1;
  for (const [time, colour] of [
    [view.hover, view.palette.muted],
    [view.playhead, view.palette.accent],
  ] as const) {
    if (time === null || time < view.span[0] || time > view.span[1]) continue;
    pen.strokeStyle = colour;
    pen.beginPath();
    pen.moveTo(x(time), 0);
    pen.lineTo(x(time), height - axisHeight);
    pen.stroke();
  }
}

function paintTimes(surface: Surface, view: LanesView, x: (time: number) => number, top: number): void {
  const { pen, height } = surface;
  const [from, to] = view.span;
  const milli = to - from < 0.5;
  const factor = milli ? 1000 : 1;
  pen.font = font(11);
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  pen.lineWidth = 1;
  const marks = ticks(from * factor, to * factor, "linear", Math.max(2, Math.floor(surface.width / 110)));
  for (const mark of marks) {
    const at = Math.round(x(mark / factor)) + 0.5;
    pen.strokeStyle = view.palette.grid;
    pen.beginPath();
    pen.moveTo(at, top);
    pen.lineTo(at, height - axisHeight + 3);
    pen.stroke();
    pen.fillStyle = view.palette.muted;
    pen.fillText(`${Number(mark.toPrecision(10))}`, at, height - 5);
  }
  pen.textAlign = "right";
  pen.fillText(milli ? "t [ms]" : "t [s]", marginLeft - 8, height - 5);
}

interface LaneBox {
  top: number;
  height: number;
  inner: number;
}

function paintLane(surface: Surface, trees: Pyramids, view: LanesView, lane: LaneSpec, box: LaneBox): void {
  if (box.height < 12) return;
  const { pen } = surface;
  const { motion } = trees;
  const index = (time: number): number => (time - motion.start) / motion.interval;
  const [first, end] = [index(view.span[0]), index(view.span[1])];
  const count = Math.max(2, Math.round(box.inner * surface.ratio));
  const curves = lane.curves
    .map((curve) => ({ ...curve, tree: trees.of(curve.column) }))
    .filter((curve): curve is typeof curve & { tree: Pyramid } => curve.tree !== null)
    .map((curve) => ({ ...curve, parts: columns(curve.tree, first, end, count) }));
  const [low, high] = limits(
    curves.map(({ parts }) => parts),
    lane.spiky,
    titleHeight / box.height,
  );
  const y = (value: number): number => box.top + (box.height * (high - value)) / (high - low);

  pen.font = font(10);
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  pen.lineWidth = 1;
  const unit = motion.columns.get(lane.curves[0]?.column ?? "")?.unit ?? "";
  const written = writtenIn(unit, Math.max(high, -low));
  const marks = ticksOfScale(low * written.factor, high * written.factor, "linear", box.height / 26);
  const texts = toldApart(marks);
  for (const [k, value] of marks.entries()) {
    const at = Math.round(y(value / written.factor)) + 0.5;
    if (at < box.top || at > box.top + box.height) continue;
    pen.strokeStyle = value === 0 ? view.palette.line : view.palette.grid;
    pen.beginPath();
    pen.moveTo(marginLeft, at);
    pen.lineTo(marginLeft + box.inner, at);
    pen.stroke();
    pen.fillStyle = view.palette.muted;
    pen.fillText(texts[k] as string, marginLeft - 5, at);
  }
  pen.save();
  pen.beginPath();
  pen.rect(marginLeft, box.top, box.inner, box.height);
  pen.clip();
  for (const curve of curves) {
    pen.fillStyle = pen.strokeStyle = curve.colour === "muted" ? view.palette.muted : view.palette.traces[curve.colour];
    if (end - first > 2 * count) {
      fillParts(pen, curve.parts, y, box.inner / count);
      continue;
    }
    pen.lineWidth = 1.2;
    pen.beginPath();
    strokeSamples(pen, curve.tree.samples, first, end, y, box.inner);
    pen.stroke();
  }
  pen.restore();
  paintTitle(surface, view, lane, box, unitText(written.unit));
}

/**
 * A bar per pixel from the smallest to the largest value, long enough to meet its neighbour:
 * far cheaper than a path.
 */
function fillParts(
  pen: CanvasRenderingContext2D,
  parts: Float32Array,
  y: (value: number) => number,
  step: number,
): void {
  let [before, after] = [NaN, NaN]; // top and bottom of the last bar
  for (let part = 0; 2 * part < parts.length; ++part) {
    let top = y(parts[2 * part + 1] as number);
    let bottom = y(parts[2 * part] as number);
    if (top > after) top = after;
    if (bottom < before) bottom = before;
    [before, after] = [y(parts[2 * part + 1] as number), y(parts[2 * part] as number)];
    pen.fillRect(marginLeft + part * step, top - 0.5, step, Math.max(bottom - top, 0) + 1);
  }
}

function strokeSamples(
  pen: CanvasRenderingContext2D,
  samples: Float32Array,
  first: number,
  end: number,
  y: (value: number) => number,
  inner: number,
): void {
  const last = Math.min(samples.length - 1, Math.ceil(end));
  for (let k = Math.max(0, Math.floor(first)); k <= last; ++k)
    pen.lineTo(marginLeft + (inner * (k - first)) / (end - first), y(samples[k] as number));
}

/**
 * Ends of a lane's scale: what is seen, with a little room and a part for its title; without rare peaks where these
 * mean nothing.
 */
function limits(parts: Float32Array[], spiky: boolean, title: number): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const part of parts) {
    if (spiky) {
      const sorted = part.slice().sort(); // a low and a high per pixel
      low = Math.min(low, sorted[Math.floor(0.005 * sorted.length)] ?? 0);
      high = Math.max(high, sorted[Math.floor(0.985 * (sorted.length - 1))] ?? 1);
    } else {
      for (const value of part) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
  }
  if (!(low <= high) || !Number.isFinite(low) || !Number.isFinite(high)) return [-1, 1];
  const room = 0.06 * (high - low) || Math.abs(high) * 0.1 || 1e-12;
  const above = Math.min(title, 0.5);
  return [low - room, high + ((high - low + room) * above) / (1 - above)];
}

function paintTitle(surface: Surface, view: LanesView, lane: LaneSpec, box: LaneBox, unit: string): void {
  const { pen } = surface;
  pen.textAlign = "left";
  pen.textBaseline = "top";
  pen.font = font(11, 600);
  const title = `${lane.title} [${unit}]`;
  let left = marginLeft + 6;
  const write = (text: string, colour: string): void => {
    const { width } = pen.measureText(text);
    pen.fillStyle = view.palette.panel;
    pen.fillRect(left - 4, box.top, width + 8, 16); // curves must not run through it
    pen.fillStyle = colour;
    pen.fillText(text, left, box.top + 3);
    left += width + 12;
  };
  write(title, view.palette.ink);
  pen.font = font(11);
  for (const curve of lane.curves)
    write(curve.label, curve.colour === "muted" ? view.palette.muted : view.palette.traces[curve.colour]);
}
