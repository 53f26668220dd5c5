/**
 * The whole state of the page, and its form in the URL's fragment. Pure: what is read here is what was written.
 *
 * The chosen cell is no state of its own: it is where the design lies on the chart's axes.
 */
import { directions, type Direction, type Scale } from "../program/words.ts";

/** An axis of the chart; both ends belong to it. */
export interface Axis {
  parameter: string;
  from: number;
  to: number;
  points: number;
  scale: Scale;
}

/** A preset with what was changed in it, as text that `--set` takes. */
export interface Design {
  preset: string;
  set: Readonly<Record<string, string>>;
}

/** The tabs below the chart and their titles, from left to right. */
export const viewTitles = {
  response: "Response",
  spectra: "Spectra",
  modes: "Modes",
  energy: "Energy and verdict",
  friction: "Friction",
  listen: "Listen",
  quiet: "Keep quiet",
  library: "Library",
} as const;
export type View = keyof typeof viewTitles;
export const views = Object.keys(viewTitles) as View[];
export const themes = ["auto", "light", "dark"] as const;
export type Theme = (typeof themes)[number];

/** What the present design is compared with. */
export type Other = { design: Design; direction: Direction } | { library: number };

export interface State {
  design: Design;
  x: Axis;
  y: Axis;
  figure: string;
  direction: Direction;
  view: View;
  /** The part of the time history that is shown [s]; null: all of it. */
  span: readonly [number, number] | null;
  other: Other | null;
  theme: Theme;
}

/** The design's overrides as the command line and the server take them. */
export function overrides(design: Design): string[] {
  return Object.entries(design.set).map(([key, value]) => `${key}=${value}`);
}

/** The design as the server takes it. */
export function body(design: Design): { preset: string; set: string[] } {
  return { preset: design.preset, set: overrides(design) };
}

/** Sets values after all others. A key without a joint's name is that of all joints, and takes the place of theirs. */
export function withValues(design: Design, values: Record<string, string>): Design {
  const keys = Object.keys(values);
  const isReplaced = (key: string): boolean => {
    const inner = key.replace(/^joint\.[^.]+\.(?=contact\.)|(?<=^joint\.)[^.]+\.(?=[^.]+$)/, "");
    return keys.includes(key) || keys.includes(inner);
  };
  const kept = withoutKeys(design, Object.keys(design.set).filter(isReplaced));
  return { ...kept, set: { ...kept.set, ...values } };
}

export function withoutKeys(design: Design, keys: readonly string[]): Design {
  const kept = Object.entries(design.set).filter(([key]) => !keys.includes(key));
  return { preset: design.preset, set: Object.fromEntries(kept) };
}

/**
 * What the chart depends on: the design without the two values that its axes replace. A key that the preset does not
 * have must be there all the same, with whichever value; that is an end of its axis.
 */
export function chartDesign({ design, x, y }: State, has: (key: string) => boolean): Design {
  const lacking = [x, y].filter(({ parameter }) => parameter in design.set && !has(parameter));
  const ends = Object.fromEntries(lacking.map(({ parameter, from }) => [parameter, String(from)]));
  return withValues(withoutKeys(design, [x.parameter, y.parameter]), ends);
}

function axisText(axis: Axis): string {
  return [axis.parameter, axis.from, axis.to, axis.points, axis.scale].join(":");
}

function readAxis(text: string | null, otherwise: Axis): Axis {
  const parts = (text ?? "").split(":");
  const [parameter, from, to, points] = [parts[0] ?? "", Number(parts[1]), Number(parts[2]), Number(parts[3])];
  const scale: Scale = parts[4] === "log" ? "log" : "linear";
  const sound = isKey(parameter) && Number.isFinite(from) && Number.isFinite(to) && from < to;
  if (!sound || !(scale === "linear" || from > 0)) return otherwise;
  if (!Number.isInteger(points) || points < 2 || points > 256) return otherwise;
  return { parameter, from, to, points, scale };
}

function isKey(text: string): boolean {
  return /^([a-z0-9_]+|joint\.[\w-]{1,64}(\.contact)?)\.[a-z0-9_]+$/.test(text);
}

function designText(design: Design, separator: string): string {
  return [encode(design.preset), ...overrides(design).map((part) => part.split("=").map(encode).join("="))].join(
    separator,
  );
}

/** As encodeURIComponent, but what may stand in a fragment stays readable. */
function encode(text: string): string {
  return encodeURIComponent(text).replace(/%(2F|3A|40|2C|20)/g, (code) =>
    code === "%20" ? "+" : decodeURIComponent(code),
  );
}

function decode(text: string): string {
  try {
    return decodeURIComponent(text.replaceAll("+", " "));
  } catch {
    return "";
  }
}

function otherText(other: Other): string {
  if ("library" in other) return `library:${other.library}`;
  return `${other.direction};${designText(other.design, ";")}`;
}

function readOther(text: string | null): Other | null {
  if (!text) return null;
  const entry = /^library:(\d+)$/.exec(text);
  if (entry) return { library: Number(entry[1]) };
  const [direction, preset, ...rest] = text.split(";");
  if ((direction !== "going" && direction !== "coming") || !preset) return null;
  return { design: { preset: decode(preset), set: readSet(rest) }, direction };
}

function readSet(parts: readonly string[]): Record<string, string> {
  const set: Record<string, string> = {};
  for (const part of parts) {
    const at = part.indexOf("=");
    const key = part.slice(0, Math.max(at, 0));
    if (isKey(key)) set[key] = decode(part.slice(at + 1));
  }
  return set;
}

/** The case that a page begins with: the one that it was opened with, or one of the paper's. */
export const [ownPreset, paperPreset] = ["file", "squeal"];

/** Most characters of a fragment: a whole case and one it is compared with take some 4000. */
export const longestFragment = 8000;

/** The state as a fragment, without "#"; what a page begins with is left out, but the preset and the axes. */
export function toFragment(state: State): string {
  const parts = [`preset=${designText(state.design, "&")}`, `x=${axisText(state.x)}`, `y=${axisText(state.y)}`];
  const add = (name: string, value: string, usual: string): void => {
    if (value !== usual) parts.push(`${name}=${encode(value)}`);
  };
  add("figure", state.figure, "category");
  add("direction", state.direction, "going");
  add("view", state.view, "response");
  add("theme", state.theme, "auto");
  if (state.span) parts.push(`span=${state.span[0]}:${state.span[1]}`);
  if (state.other) parts.push(`other=${otherText(state.other)}`);
  return parts.join("&");
}

function partsOf(fragment: string): string[] {
  return fragment.length > longestFragment + 1 ? [] : fragment.replace(/^#/, "").split("&");
}

function namedIn(parts: readonly string[]): Map<string, string> {
  const named = new Map<string, string>();
  for (const part of parts) {
    const at = part.indexOf("=");
    if (at > 0 && !isKey(part.slice(0, at))) named.set(part.slice(0, at), part.slice(at + 1));
  }
  return named;
}

/** The design of a fragment; of one that names no case, `usual` is its case. */
export function designIn(fragment: string, usual: string): Design {
  const parts = partsOf(fragment);
  const preset = namedIn(parts).get("preset");
  return { preset: preset === undefined ? usual : decode(preset), set: readSet(parts) };
}

/** The state that a fragment says; what it does not say, or says wrongly, is as in the defaults. */
export function fromFragment(fragment: string, defaults: State): State {
  const parts = partsOf(fragment);
  const named = namedIn(parts);
  const word = <T extends string>(name: string, allowed: readonly T[], usual: T): T => {
    const value = decode(named.get(name) ?? "");
    return allowed.includes(value as T) ? (value as T) : usual;
  };
  const [from, to] = (named.get("span") ?? "").split(":").map(Number);
  const x = readAxis(named.get("x") ?? null, defaults.x);
  const y = readAxis(named.get("y") ?? null, defaults.y);
  return {
    design: designIn(fragment, defaults.design.preset),
    ...(x.parameter === y.parameter ? { x: defaults.x, y: defaults.y } : { x, y }),
    figure: decode(named.get("figure") ?? "") || (named.has("preset") ? "category" : defaults.figure),
    direction: word("direction", directions, defaults.direction),
    view: word("view", views, defaults.view),
    span: from !== undefined && to !== undefined && from < to ? [from, to] : null,
    other: readOther(named.get("other") ?? null),
    theme: word("theme", themes, defaults.theme),
  };
}

/**
 * A word as a shell takes it for one. What pasting would type by itself is refused,
 * and what parts the cells of a table.
 */
function word(text: string): string {
  if (/[^ -~]|[,;]/.test(text)) throw Error("no command");
  return /^[\w.+-][\w.=+-]*$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

/** `stridor init ... | stridor simulate - ...`: the design as a command, ready for a shell. */
export function command(design: Design, file = "CASE.toml"): string {
  const options = overrides(design)
    .map((text) => ` --set ${word(text)}`)
    .join("");
  if (design.preset === ownPreset) return `stridor simulate ${word(file)}${options}`;
  return `stridor init ${word(design.preset)} | stridor simulate -${options}`;
}
