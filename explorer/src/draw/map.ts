/** One direction of a chart, painted: cells with their hatching, boundaries, axes, the chosen cell. */
import { isAwaited, type ChartData } from "../data/chart_data.ts";
import type { ChartAxisFrame } from "../data/types.ts";
import { chartKinds, type Direction } from "../program/words.ts";
import { paintAxes, type AxisLook, type Box } from "./axes.ts";
import { fillOf, paleness, paleOf, sequential, textOn, tile, type Palette } from "./colours.ts";
import { writtenIn } from "./format.ts";
import { besideMarks, markRadius, placesAbout, type Spot } from "./mark_names.ts";
import { at, share } from "./scale.ts";
import { font, type Surface } from "./surface.ts";

export interface Look {
  palette: Palette;
  title: string;
  shortTitle: string; // where there is no room for it
  xTitle: string;
  yTitle: string; // empty: neither title nor numbers on y
  chosen: boolean;
}

/** Where the cells lie on a surface of this size. */
export function plotBox(surface: { width: number; height: number }, look: Look): Box {
  const left = look.yTitle === "" ? 14 : 58;
  return { left, top: 26, width: surface.width - left - 12, height: surface.height - 26 - 42 };
}

/**
 * Where a value lies within the box, 0 to 1. A cell is as wide as the distance of its neighbours' middles, so the first
 * and the last value of an axis lie half a cell inside.
 */
export function place(value: number, axis: ChartAxisFrame): number {
  return (share(value, axis.from, axis.to, axis.scale) * (axis.points - 1) + 0.5) / axis.points;
}

/** The share of the axis (0 at `from`) at a place of the box. */
export function shareAt(part: number, points: number): number {
  return (part * points - 0.5) / (points - 1);
}

/** The cell under a point of the surface; null outside. */
export function cellAt(box: Box, data: ChartData, x: number, y: number): { ix: number; iy: number } | null {
  const ix = Math.floor(((x - box.left) / box.width) * data.x.points);
  const iy = Math.floor((1 - (y - box.top) / box.height) * data.y.points);
  const inside = ix >= 0 && iy >= 0 && ix < data.x.points && iy < data.y.points;
  return inside ? { ix, iy } : null;
}

export function indexOf(data: ChartData, direction: Direction, ix: number, iy: number): number {
  const d = Math.max(data.directions.indexOf(direction), 0);
  return (d * data.y.points + iy) * data.x.points + ix;
}

export function paintMap(surface: Surface, data: ChartData, direction: Direction, look: Look): void {
  const box = plotBox(surface, look);
  if (box.width < 10 || box.height < 10) return;
  if (data.figure) paintFigure(surface, box, data, direction, look);
  else paintCategories(surface, box, data, direction, look);
  if (data.done) paintBoundaries(surface, box, data, direction, look);
  paintNames(surface, box, data, direction, look);
  paintFrameOf(surface, box, data, look);
}

/** Edges of columns, and of rows from below, in whole pixels of the device: neighbours meet without a seam. */
function gridOf({ ratio }: Surface, box: Box, { x, y }: ChartData): [number[], number[]] {
  const edges = (start: number, size: number, count: number): number[] =>
    Array.from({ length: count + 1 }, (_, i) => Math.round((start + (size * i) / count) * ratio) / ratio);
  return [edges(box.left, box.width, x.points), edges(box.top + box.height, -box.height, y.points)];
}

function paintCategories(surface: Surface, box: Box, data: ChartData, direction: Direction, look: Look): void {
  const { pen } = surface;
  const { x, y } = data;
  const [columns, rows] = gridOf(surface, box, data);
  const brushes = brushesOf(surface, look.palette);
  for (let iy = 0; iy < y.points; ++iy) {
    const top = rows[iy + 1] as number;
    const height = (rows[iy] as number) - top;
    const row = indexOf(data, direction, 0, iy);
    for (let ix = 0; ix < x.points;) {
      const category = data.category[row + ix] as number;
      const awaited = isAwaited(data, row + ix);
      let end = ix + 1;
      while (end < x.points && data.category[row + end] === category && isAwaited(data, row + end) === awaited) ++end;
      const left = columns[ix] as number;
      const width = (columns[end] as number) - left;
      ix = end;
      if (category === 255 && !data.done) continue;
      const brush = brushes(category, awaited);
      pen.fillStyle = brush.ground;
      pen.fillRect(left, top, width, height);
      if (!brush.marks) continue;
      pen.fillStyle = brush.marks;
      pen.fillRect(left, top, width, height);
    }
  }
}

function brushesOf(surface: Surface, palette: Palette) {
  const made = new Map<string, { ground: string; marks: CanvasPattern | null }>();
  return (category: number, awaited: boolean) => {
    const key = `${category} ${awaited}`;
    const known = made.get(key);
    if (known) return known;
    const fill = (awaited ? paleOf : fillOf)(palette, chartKinds[category]);
    const image = tile(fill, surface.ratio);
    const marks = image ? surface.pen.createPattern(image, "repeat") : null;
    marks?.setTransform(new DOMMatrix().scale(1 / surface.ratio));
    const brush = { ground: fill.ground, marks };
    made.set(key, brush);
    return brush;
  };
}

function paintFigure(surface: Surface, box: Box, data: ChartData, direction: Direction, look: Look): void {
  const { x, y, painted } = data;
  if (!painted) return;
  const image = new ImageData(x.points, y.points);
  const [low, high] = data.figureRange;
  for (let iy = 0; iy < y.points; ++iy)
    for (let ix = 0; ix < x.points; ++ix) {
      const index = indexOf(data, direction, ix, iy);
      const value = painted[index] as number;
      const pixel = 4 * ((y.points - 1 - iy) * x.points + ix);
      if (!Number.isFinite(value)) continue;
      const opacity = isAwaited(data, index) ? paleness : 1;
      image.data.set([...sequential((value - low) / (high - low || 1)), 255 * opacity], pixel);
    }
  const small = document.createElement("canvas");
  [small.width, small.height] = [x.points, y.points];
  (small.getContext("2d") as CanvasRenderingContext2D).putImageData(image, 0, 0);
  const { pen } = surface;
  pen.fillStyle = look.palette.grid;
  pen.fillRect(box.left, box.top, box.width, box.height);
  pen.imageSmoothingEnabled = false;
  pen.drawImage(small, box.left, box.top, box.width, box.height);
}

/** Edges between cells whose verdicts differ. None lies between slides and sticks: both are none. */
export function paintBoundaries(surface: Surface, box: Box, data: ChartData, direction: Direction, look: Look): void {
  const { pen } = surface;
  const [columns, rows] = gridOf(surface, box, data);
  const verdict = (ix: number, iy: number): string | undefined => {
    const kind = chartKinds[data.category[indexOf(data, direction, ix, iy)] as number];
    return kind === "none (sticks)" ? "none" : kind;
  };
  pen.save();
  pen.strokeStyle = data.figure ? "#FFFFFF" : look.palette.ink;
  pen.lineWidth = 1.1;
  pen.lineCap = "square"; // two that meet make a corner
  pen.beginPath();
  for (let iy = 0; iy < data.y.points; ++iy)
    for (let ix = 0; ix < data.x.points; ++ix) {
      const own = verdict(ix, iy);
      const [left, below] = [columns[ix] as number, rows[iy] as number];
      if (ix > 0 && verdict(ix - 1, iy) !== own) {
        pen.moveTo(left, below);
        pen.lineTo(left, rows[iy + 1] as number);
      }
      if (iy > 0 && verdict(ix, iy - 1) !== own) {
        pen.moveTo(left, below);
        pen.lineTo(columns[ix + 1] as number, below);
      }
    }
  pen.stroke();
  pen.restore();
}

function paintNames(surface: Surface, box: Box, data: ChartData, direction: Direction, look: Look): void {
  const { pen } = surface;
  pen.font = font(12);
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (const { d, category, x, y, cells } of data.names) {
    const name = chartKinds[category];
    if (data.directions[d] !== direction || !name) continue;
    const room = Math.min((cells * box.width) / data.x.points, (2 * cells * box.height) / data.y.points);
    const width = pen.measureText(name).width + 8;
    if (width > room) continue;
    const [px, py] = [box.left + (box.width * x) / data.x.points, box.top + box.height * (1 - y / data.y.points)];
    const { ground } = fillOf(look.palette, name);
    pen.fillStyle = ground;
    pen.fillRect(px - width / 2, py - 8, width, 16);
    pen.fillStyle = textOn(ground);
    pen.fillText(name, px, py + 0.5);
  }
}

function paintFrameOf(surface: Surface, box: Box, data: ChartData, look: Look): void {
  const { pen } = surface;
  const axis = (frame: ChartAxisFrame, title: string): AxisLook => ({
    ...frame,
    title,
    factor: writtenIn(frame.unit, frame.to).factor,
    place: (value) => place(value, frame),
  });
  paintAxes(pen, look.palette, box, axis(data.x, look.xTitle), axis(data.y, look.yTitle));
  pen.fillStyle = look.palette.ink;
  pen.font = font(12, look.chosen ? 650 : 500);
  pen.textAlign = "left";
  pen.textBaseline = "alphabetic";
  const isRoom = pen.measureText(look.title).width <= box.width + 12;
  pen.fillText(isRoom ? look.title : look.shortTitle, box.left, box.top - 9);
}

function mark(pen: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
}

/** Where the design lies, or one of its joints; then with its name. */
export interface Mark {
  name: string;
  x: number;
  y: number;
}

/**
 * Where the design lies: a ring that is seen on every ground, of the first one hair lines, too. Of several each has its
 * name, or its number where there is no room for names. Are there numbers?
 */
export function paintDesigns(surface: Surface, box: Box, data: ChartData, marks: readonly Mark[], look: Look): boolean {
  const { pen } = surface;
  const spots = marks.map(({ x, y }) => ({
    x: box.left + box.width * place(x, data.x),
    y: box.top + box.height * (1 - place(y, data.y)),
  }));
  pen.save();
  pen.beginPath();
  pen.rect(box.left - 1, box.top - 1, box.width + 2, box.height + 2);
  pen.clip();
  spots.forEach((spot, rank) => paintRing(pen, box, spot, rank === 0, look.chosen));
  const isNumbered = marks.length > 1 && paintMarkNames(pen, box, spots, marks);
  pen.restore();
  return isNumbered;
}

function paintRing(pen: CanvasRenderingContext2D, box: Box, { x, y }: Spot, isFirst: boolean, chosen: boolean): void {
  for (const [colour, width] of [
    ["#FFFFFF", 2.6],
    ["#111418", 1.2],
  ] as const) {
    pen.globalAlpha = chosen ? 0.85 : 0.4;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    if (chosen && isFirst) {
      mark(pen, box.left, y, x - 8, y);
      mark(pen, x + 8, y, box.left + box.width, y);
      mark(pen, x, box.top, x, y - 8);
      mark(pen, x, y + 8, x, box.top + box.height);
    }
    pen.globalAlpha = 1;
    pen.lineWidth = width + (chosen ? 0.8 : 0);
    pen.beginPath();
    pen.arc(x, y, markRadius, 0, 2 * Math.PI);
    pen.stroke();
  }
}

function paintMarkNames(pen: CanvasRenderingContext2D, box: Box, spots: Spot[], marks: readonly Mark[]): boolean {
  pen.font = font(11, 600);
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineWidth = 3;
  pen.strokeStyle = "#FFFFFF";
  pen.fillStyle = "#111418";
  const names = marks.map(({ name }) => name);
  const numbers = marks.map((_, k) => String(k + 1));
  const placesOf = (texts: string[]): (Box | null)[] | null =>
    besideMarks(
      spots,
      texts.map((text) => pen.measureText(text).width + 2),
      box,
    );
  const named = placesOf(names);
  const places = named ?? placesOf(numbers) ?? spots.map((spot) => placesAbout(spot, 9)[0] ?? null);
  places.forEach((space, k) => {
    if (!space) return;
    const text = (named ? names : numbers)[k] as string;
    const [x, y] = [space.left + space.width / 2, space.top + space.height / 2 + 0.5];
    pen.strokeText(text, x, y);
    pen.fillText(text, x, y);
  });
  return !named;
}

/** An outline of a cell or of a zoom to be. */
export function paintFrame(surface: Surface, area: Box, palette: Palette): void {
  const { pen } = surface;
  pen.lineWidth = 3;
  pen.strokeStyle = "#FFFFFF";
  pen.strokeRect(area.left, area.top, area.width, area.height);
  pen.lineWidth = 1.2;
  pen.strokeStyle = palette.name === "dark" ? "#111418" : palette.ink;
  pen.strokeRect(area.left, area.top, area.width, area.height);
}

export function cellBox(box: Box, data: ChartData, ix: number, iy: number): Box {
  const width = box.width / data.x.points;
  const height = box.height / data.y.points;
  return { left: box.left + ix * width, top: box.top + box.height - (iy + 1) * height, width, height };
}

/** The value that an axis has at a place of the box. */
export function valueAtPlace(part: number, axis: ChartAxisFrame): number {
  return at(shareAt(part, axis.points), axis.from, axis.to, axis.scale);
}
