/** Axes: where a value lies, which values deserve a tick, and what a zoom leaves. Pure. */
import type { Scale } from "../program/words.ts";
import type { Axis } from "../state/state.ts";

/** Where a value lies between the ends of an axis: 0 at `from`, 1 at `to`. */
export function share(value: number, from: number, to: number, scale: Scale): number {
  if (scale === "log") return Math.log(value / from) / Math.log(to / from);
  return (value - from) / (to - from);
}

/** The value at a share of an axis. */
export function at(part: number, from: number, to: number, scale: Scale): number {
  if (scale === "log") return from * (to / from) ** part;
  return from + (to - from) * part;
}

/** Round values within the ends, about as many as wanted: steps of 1, 2, 5; decades on a log axis. */
export function ticks(from: number, to: number, scale: Scale, wanted = 6): number[] {
  if (!(to > from)) return [];
  if (scale === "log" && from > 0) {
    const decades = Math.log10(to / from);
    if (decades >= 1) {
      const parts = decades > wanted ? [1] : decades > wanted / 2 ? [1] : decades > wanted / 4 ? [1, 3] : [1, 2, 5];
      const every = Math.max(1, Math.ceil(decades / wanted));
      const found: number[] = [];
      for (let power = Math.floor(Math.log10(from)); power <= Math.log10(to); ++power)
        for (const part of parts) {
          const value = Number((part * 10 ** power).toPrecision(12));
          if (power % every === 0 && inside(value, from, to)) found.push(value);
        }
      return found;
    }
  }
  const raw = (to - from) / Math.max(wanted, 1);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((part) => part * power).find((candidate) => candidate >= raw * 0.999) ?? raw;
  const found: number[] = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k)
    found.push(Number((k * step).toPrecision(12)));
  return found;
}

/** About as many as wanted, but two at least: one alone gives no scale. */
export function ticksOfScale(from: number, to: number, scale: Scale, wanted: number): number[] {
  const few = ticks(from, to, scale, Math.max(2, Math.floor(wanted)));
  return few.length < 2 ? ticks(from, to, scale, 2 * Math.ceil(wanted)) : few;
}

function inside(value: number, from: number, to: number): boolean {
  return value >= from * (1 - 1e-9) && value <= to * (1 + 1e-9);
}

/** An axis cut to a part of it, its ends with few digits; never wider than before, never empty. */
export function zoomed(axis: Axis, first: number, second: number): Axis {
  const [low, high] = [Math.max(0, Math.min(first, second)), Math.min(1, Math.max(first, second))];
  const ends = [at(low, axis.from, axis.to, axis.scale), at(high, axis.from, axis.to, axis.scale)] as const;
  const width = Math.abs(ends[1] - ends[0]);
  const digits = Math.min(
    12,
    Math.max(4, 3 + Math.ceil(Math.log10(Math.max(Math.abs(ends[1]), Math.abs(ends[0])) / width))),
  );
  const from = low === 0 ? axis.from : Number(ends[0].toPrecision(digits));
  const to = high === 1 ? axis.to : Number(ends[1].toPrecision(digits));
  return to > from ? { ...axis, from, to } : axis;
}

/** Does a value lie between the ends of an axis, or but half a cell beyond? */
export function holds(axis: Axis, value: number): boolean {
  const part = share(value, axis.from, axis.to, axis.scale);
  const half = 0.5 / (axis.points - 1);
  return !Number.isFinite(value) || (part >= -half && part <= 1 + half);
}

/**
 * An axis made wide enough for a value, with some room beyond, but not beyond what its quantity may be; linear where a
 * logarithm has no place for the value.
 */
export function widened(axis: Axis, value: number, limits: { low: number | null; high: number | null }): Axis {
  if (holds(axis, value)) return axis;
  if (axis.scale === "log" && value <= 0) return widened({ ...axis, scale: "linear" }, value, limits);
  const room = axis.scale === "log" ? Math.abs(value) * 0.2 : 0.1 * Math.max(value - axis.from, axis.to - value);
  const few = (x: number): number => Number(x.toPrecision(3));
  const [low, high] = [limits.low ?? -Infinity, limits.high ?? Infinity];
  if (value < axis.from) return { ...axis, from: Math.min(value, Math.max(low, few(value - room))) };
  return { ...axis, to: Math.max(value, Math.min(high, few(value + room))) };
}

/** A span moved and stretched about a place of it, kept within its limits. */
export function stretched(
  span: readonly [number, number],
  about: number,
  factor: number,
  limits: readonly [number, number],
): [number, number] {
  const whole = limits[1] - limits[0];
  const width = Math.min(whole, Math.max((span[1] - span[0]) * factor, whole * 1e-7));
  const part = (about - span[0]) / (span[1] - span[0]);
  return moved([about - part * width, about - part * width + width], 0, limits);
}

export function moved(
  span: readonly [number, number],
  by: number,
  limits: readonly [number, number],
): [number, number] {
  const width = span[1] - span[0];
  const from = Math.min(Math.max(span[0] + by, limits[0]), limits[1] - width);
  return [from, from + width];
}

/** Index of the grid value nearest to a value, as the axis measures. */
export function nearest(values: readonly number[], value: number, scale: Scale): number {
  const measure = (a: number): number => (scale === "log" ? Math.abs(Math.log(a / value)) : Math.abs(a - value));
  let best = 0;
  values.forEach((candidate, index) => {
    if (measure(candidate) < measure(values[best] as number)) best = index;
  });
  return best;
}

/** In which row a label stands that must not lie on those before it; they come from left to right. */
export function rows(): (left: number, width: number) => number {
  const ends: number[] = []; // of the last label in each row
  return (left, width) => {
    const free = ends.findIndex((end) => end < left);
    const row = free < 0 ? ends.length : free;
    ends[row] = left + width;
    return row;
  };
}
