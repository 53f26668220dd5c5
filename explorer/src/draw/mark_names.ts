/** Where the names of marks stand on a picture, so that none lies on another or on a mark. Pure. */
import type { Box } from "./axes.ts";

export interface Spot {
  x: number; // [px] of its middle
  y: number;
}

export const markRadius = 6; // [px]
const nameHeight = 14;
const gap = 3; // between mark and name

/** The name's box for each mark within the picture, null for one outside; nothing where there is no room for all. */
export function besideMarks(spots: readonly Spot[], widths: readonly number[], box: Box): (Box | null)[] | null {
  const rings = spots.map(({ x, y }) => around(x, y, 2 * markRadius + 2, 2 * markRadius + 2));
  const taken: Box[] = [];
  const placed: (Box | null)[] = [];
  for (const [k, spot] of spots.entries()) {
    if (!isWithin(around(spot.x, spot.y, 0, 0), box)) {
      placed.push(null);
      continue;
    }
    const isFree = (place: Box): boolean =>
      isWithin(place, box) && ![...taken, ...rings.filter((_, of) => of !== k)].some((other) => overlap(place, other));
    const place = placesAbout(spot, widths[k] ?? 0).find(isFree);
    if (!place) return null;
    taken.push(place);
    placed.push(place);
  }
  return placed;
}

/** Beside, above and below a mark, the best first. */
export function placesAbout({ x, y }: Spot, width: number): Box[] {
  const across = markRadius + gap + width / 2;
  const up = markRadius + gap + nameHeight / 2;
  const middles: [number, number][] = [];
  for (const dy of [0, -0.7 * up, 0.7 * up]) for (const dx of [across, -across]) middles.push([dx, dy]);
  for (const dy of [-up, up]) for (const dx of [0, width / 2, -width / 2]) middles.push([dx, dy]);
  return middles.map(([dx, dy]) => around(x + dx, y + dy, width, nameHeight));
}

function around(x: number, y: number, width: number, height: number): Box {
  return { left: x - width / 2, top: y - height / 2, width, height };
}

function isWithin(inner: Box, outer: Box): boolean {
  return (
    inner.left >= outer.left &&
    inner.top >= outer.top &&
    inner.left + inner.width <= outer.left + outer.width &&
    inner.top + inner.height <= outer.top + outer.height
  );
}

function overlap(one: Box, other: Box): boolean {
  return (
    one.left < other.left + other.width &&
    other.left < one.left + one.width &&
    one.top < other.top + other.height &&
    other.top < one.top + one.height
  );
}
