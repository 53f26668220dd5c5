/** What a chart shows, put together from the frames it comes in. Pure. */
import { bytesOf, floatsOf } from "./frames.ts";
import type { ChartData } from "./map.ts";
import { namePlaces, spread } from "./regions.ts";
import type { ChartFrame } from "./types.ts";

/** The chart after a frame; axes come with the first one only. Nothing before these are known. */
export function merged(before: ChartData | null, frame: ChartFrame, hasFigure: boolean): ChartData | null {
  const x = frame.x ?? before?.x;
  const y = frame.y ?? before?.y;
  if (!x || !y) return null;
  const figure = hasFigure && frame.figure ? floatsOf(frame.figure) : null;
  return {
    x,
    y,
    directions: frame.directions ?? before?.directions,
    category: bytesOf(frame.category),
    computed: frame.computed_mask ? bytesOf(frame.computed_mask) : null,
    figure,
    painted: figure && spread(figure, frame.computed_mask ? bytesOf(frame.computed_mask) : null, x.points, y.points),
    names: frame.done && !figure ? namePlaces(bytesOf(frame.category), x.points, y.points) : [],
    figureRange: figure ? rangeOf(figure) : [0, 1],
    boundaries: frame.boundaries ?? [],
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
