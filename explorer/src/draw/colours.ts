/**
 * Colours of categories, contact states and figures, in light and dark, and the hatching that says the same without
 * colour. In light they are those of Stridor's figures, as the program writes them. In dark, quiet recedes and the
 * noises keep their hue and their order of lightness.
 */
import { kindFills, sequentialStops, stateColours } from "../program/palette.ts";
import { type Category, chartKinds, type ContactState, type QuietReason } from "../program/words.ts";

/** [1] How much of a colour is left where a cell is not computed yet. */
export const paleness = 0.3;

export type Texture = "plain" | "dots" | "rising" | "falling" | "crossed";

export interface Fill {
  ground: string;
  texture: Texture;
  mark: string;
}

/** 0 to 255 each. */
export type Colour = [red: number, green: number, blue: number];

/** What a cell may be filled for: a category, a contact that sticks or locks, no result. */
export type Kind = keyof typeof kindFills;

export interface Palette {
  name: "light" | "dark";
  page: string;
  panel: string;
  field: string;
  ink: string;
  muted: string;
  line: string;
  grid: string;
  accent: string;
  onAccent: string;
  warn: string;
  traces: readonly [string, string, string, string];
  category: Readonly<Record<Kind, Fill>>;
  state: Record<ContactState, string>;
}

export const light: Palette = {
  name: "light",
  page: "#F4F5F6",
  panel: "#FFFFFF",
  field: "#FFFFFF",
  ink: "#1B1F24",
  muted: "#59616B",
  line: "#CFD4DA",
  grid: "#E9ECEF",
  accent: "#0B5CAD",
  onAccent: "#FFFFFF",
  warn: "#A3262A",
  traces: ["#004488", "#BB5566", "#8A6A12", "#3A7D44"],
  category: kindFills,
  state: stateColours,
};

export const dark: Palette = {
  name: "dark",
  page: "#121417",
  panel: "#1A1D21",
  field: "#121417",
  ink: "#E4E7EB",
  muted: "#9AA3AD",
  line: "#363C44",
  grid: "#262B31",
  accent: "#6CB2F5",
  onAccent: "#0D1014",
  warn: "#F28B82",
  traces: ["#6CA8E6", "#E07F8F", "#DDAA33", "#7CC48A"],
  category: {
    "none": { ground: "#30353B", texture: "plain", mark: "#30353B" },
    "none (sticks)": { ground: "#4A525C", texture: "plain", mark: "#4A525C" },
    "locks": { ground: "#6B747F", texture: "crossed", mark: "#C4CCD4" },
    "squeak": { ground: "#E8BC55", texture: "dots", mark: "#6B4A00" },
    "squeal": { ground: "#CC6677", texture: "rising", mark: "#F3C6CD" },
    "creak": { ground: "#1F66AE", texture: "falling", mark: "#8FBCE8" },
    "undecided": { ground: "#1A1D21", texture: "dots", mark: "#9AA3AD" },
    "failed": { ground: "#1A1D21", texture: "crossed", mark: "#7D8690" },
  },
  state: { slip: "#88CCEE", stick: "#B5B52B", separation: "#8C5A9E" },
};

/** The category alone, and why it is quiet if it is. */
export function categoryAndQuiet(code: number): [string, string] {
  const name = chartKinds[code] ?? "";
  if (name === "none (sticks)") return ["none", "sticks"];
  if (name === "locks") return ["none", "locks"];
  return [name, name === "none" ? "slides" : ""];
}

/** What a verdict is drawn as. */
export function kindOf({ category, quiet_because }: { category: Category; quiet_because: QuietReason | null }): Kind {
  if (quiet_because === "sticks") return "none (sticks)";
  return quiet_because === "locks" ? "locks" : category;
}

/** The word of a verdict: its category, or that it locks. */
export function wordOf(verdict: { category: Category; quiet_because: QuietReason | null }): string {
  return verdict.quiet_because === "locks" ? "locks" : verdict.category;
}

/** Why nothing is heard, beside that word, and empty where the word has said it. */
export function silenceOf({ quiet_because }: { quiet_because: QuietReason | null }): string {
  return quiet_because === "locks" ? "" : (quiet_because ?? "");
}

export function fillOf(palette: Palette, category: string | null | undefined): Fill {
  return palette.category[category as Kind] ?? palette.category.failed;
}

/** How a cell that is not computed yet is filled: a breath of what its neighbour is, and no texture. */
export function paleOf(palette: Palette, category: string | null | undefined): Fill {
  const [ground, panel] = [rgb(fillOf(palette, category).ground), rgb(palette.panel)];
  const mixed = ground.map((part, k) => Math.round(paleness * part + (1 - paleness) * (panel[k] as number)));
  const colour = "#" + mixed.map((part) => part.toString(16).padStart(2, "0")).join("");
  return { ground: colour.toUpperCase(), texture: "plain", mark: colour };
}

/** Red, green and blue of a share of the scale of figures, 0 to 255. */
export function sequential(part: number): Colour {
  const last = sequentialStops.length - 1;
  const place = Math.min(Math.max(part, 0), 1) * last;
  const below = Math.min(Math.floor(place), last - 1);
  const [low, high] = [stops[below], stops[below + 1]] as [Colour, Colour];
  const mixed = (k: 0 | 1 | 2): number => Math.round(low[k] + (place - below) * (high[k] - low[k]));
  return [mixed(0), mixed(1), mixed(2)];
}

const stops = sequentialStops.map(rgb);

export function rgb(colour: string): Colour {
  return [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16)) as Colour;
}

/** Relative luminance (WCAG 2.2). */
export function luminance(colour: string): number {
  const [r, g, b] = rgb(colour).map((value) => {
    const c = value / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** Contrast of two colours (WCAG 2.2): 1 to 21. */
export function contrast(one: string, other: string): number {
  const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

/** Lightness L* (CIELAB), 0 to 100. */
export function lightness(colour: string): number {
  const Y = luminance(colour);
  return Y > 216 / 24389 ? 116 * Math.cbrt(Y) - 16 : (24389 / 27) * Y;
}

/** Black or white, whichever reads better on a ground. */
export function textOn(ground: string): string {
  return contrast(ground, "#1B1F24") >= contrast(ground, "#FFFFFF") ? "#1B1F24" : "#FFFFFF";
}

/** The marks of a texture, to be laid over its ground: a tile repeated from the canvas' corner. */
export function tile(fill: Fill, ratio: number): HTMLCanvasElement | null {
  if (fill.texture === "plain") return null;
  const key = `${fill.texture} ${fill.mark} ${ratio}`;
  const known = tiles.get(key);
  if (known) return known;
  const made = newTile(fill, ratio);
  tiles.set(key, made);
  return made;
}

const tiles = new Map<string, HTMLCanvasElement>();

function newTile(fill: Fill, ratio: number): HTMLCanvasElement {
  const size = Math.round(8 * ratio);
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = size;
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  pen.strokeStyle = pen.fillStyle = fill.mark;
  pen.lineWidth = Math.max(1, 0.9 * ratio);
  if (fill.texture === "dots") {
    for (const [x, y] of [
      [0.25, 0.25],
      [0.75, 0.75],
    ] as const) {
      pen.beginPath();
      pen.arc(x * size, y * size, 0.95 * ratio, 0, 2 * Math.PI);
      pen.fill();
    }
    return canvas;
  }
  pen.beginPath();
  for (const offset of [-size, 0, size]) {
    if (fill.texture !== "falling") line(pen, offset, size, offset + size, 0);
    if (fill.texture !== "rising") line(pen, offset, 0, offset + size, size);
  }
  pen.stroke();
  return canvas;
}

function line(pen: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
}
