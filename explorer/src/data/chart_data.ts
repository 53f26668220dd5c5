/** What a chart shows, put together from the frames it comes in. Pure. */
import { chartKinds, type Direction } from "../program/words.ts";
import { bytesOf, floatsOf } from "./frames.ts";
import { namePlaces, spread, type NamePlace } from "./regions.ts";
import type { ChartAxisFrame, ChartFrame } from "./types.ts";

export interface ChartData {
  x: ChartAxisFrame;
  y: ChartAxisFrame;
  directions: Direction[];
  category: Uint8Array; // [direction][y][x]
  computed: Uint8Array | null; // likewise; 1: computed, 0: inferred, or not computed yet
  figure: Float32Array | null; // likewise; NaN unknown
  painted: Float32Array | null; // the figure, cells that were not computed like their nearest neighbour
  figureRange: readonly [number, number];
  names: NamePlace[]; // where a category's name fits
  gaps: string; // why cells without a result have none
  done: boolean;
}

/** Is a cell of a chart that is not finished still to be computed? What it then shows is its neighbour's. */
export function isAwaited(data: ChartData, index: number): boolean {
  return !data.done && data.computed !== null && !data.computed[index];
}

/** What the picture shows in a cell, in a word. */
export function wordAt(data: ChartData, index: number): string {
  if (isAwaited(data, index)) return "not computed yet";
  return chartKinds[data.category[index] as number] ?? (data.done ? "no result" : "not computed yet");
}

/** How many cells of a direction were computed. */
export function computedIn(data: ChartData, direction: Direction): number {
  const size = data.x.points * data.y.points;
  const from = data.directions.indexOf(direction) * size;
  return data.computed?.subarray(from, from + size).reduce((sum, mark) => sum + mark, 0) ?? 0;
}

/** The chart after a frame; axes come with the first one only. Nothing before these are known. */
export function merged(before: ChartData | null, frame: ChartFrame, hasFigure: boolean): ChartData | null {
  const x = frame.x ?? before?.x;
  const y = frame.y ?? before?.y;
  const directions = frame.directions ?? before?.directions;
  if (!x || !y || !directions) return null;
  const figure = hasFigure && frame.figure ? floatsOf(frame.figure) : null;
  return {
    x,
    y,
    directions,
    category: bytesOf(frame.category),
    computed: frame.computed_mask ? bytesOf(frame.computed_mask) : null,
    figure,
    painted: figure && spread(figure, frame.computed_mask ? bytesOf(frame.computed_mask) : null, x.points, y.points),
    names: frame.done && !figure ? namePlaces(bytesOf(frame.category), x.points, y.points) : [],
    figureRange: figure ? rangeOf(figure) : [0, 1],
    gaps: frame.gaps ?? "",
    done: frame.done,
  };
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
