/** Points of a law of friction that can be moved, and where they lie on the canvas. */
import type { FrictionLaw, Grip } from "../data/answer_types.ts";
import type { Box } from "./axes.ts";
import { rounded, words } from "./format.ts";

const table = "contact.friction_table";

/** What the picture shows: from 0 to these [m/s], [1], in a box of the canvas [px]. */
export interface Frame {
  box: Box;
  speed: number;
  friction: number;
}

/** A point of the picture: what it sets, and where it may go. */
export interface Point {
  name: string;
  speed: number;
  friction: number;
  /** What a design is set to when the point is taken there. */
  at: (speed: number, friction: number) => Record<string, string>;
}

const clamped = (value: number, low: number, high: number | null): number =>
  Math.max(low, Math.min(value, high ?? Infinity));

function pointOf(grip: Grip, ways: number): Point {
  const { key, low, high, origin, rate, way } = grip;
  return {
    name: words(key) + (ways > 1 ? `, ${way}` : ""),
    speed: grip.speed,
    friction: grip.friction,
    at: (speed, friction) => ({
      [key]: String(rounded(origin + rate * clamped(grip.along === "speed" ? speed : friction, low, high), 4)),
    }),
  };
}

/** The rows of a table are its points; a row stays between its neighbours, the first one where it is. */
export function pointsOf({ grips, rows, curves }: FrictionLaw): Point[] {
  const ofRow = (row: number): Point => {
    const { speed, friction } = rows[row] as FrictionLaw["rows"][0];
    const [before, after] = [rows[row - 1]?.speed ?? 0, rows[row + 1]?.speed ?? Infinity];
    const nearest = 1e-2 * (Math.min(after, 2 * speed) - before);
    return {
      name: `row ${row + 1} of the table`,
      speed,
      friction,
      at: (wished, height) => ({
        [table]: rows
          .map((each, k) =>
            k === row
              ? `${rounded(row === 0 ? speed : clamped(wished, before + nearest, after - nearest), 6)}: ` +
                String(rounded(Math.max(0, height), 4))
              : `${each.speed}: ${each.friction}`,
          )
          .join(", "),
      }),
    };
  };
  return [...grips.map((grip) => pointOf(grip, curves.length)), ...rows.map((_, row) => ofRow(row))];
}

/** Where a point of the law lies on the canvas [px], and back. */
export function placeOf({ box, speed, friction }: Frame, at: { speed: number; friction: number }): [number, number] {
  return [box.left + (box.width * at.speed) / speed, box.top + box.height * (1 - at.friction / friction)];
}
export function lawAt({ box, speed, friction }: Frame, x: number, y: number): [number, number] {
  return [(speed * (x - box.left)) / box.width, friction * (1 - (y - box.top) / box.height)];
}
