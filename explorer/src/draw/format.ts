/** Numbers with their units, and the field's symbols, as people write them. Pure. */
import { jointKey } from "../data/cases.ts";

const prefixes: readonly [number, string][] = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];
/** Units that numbers are written in. What a case holds and what is sent stays in SI, to the last digit. */
export const unitSystems = { si: "SI", engineering: "N/mm, g" } as const;
export type UnitSystem = keyof typeof unitSystems;
let system: UnitSystem = "si";

export function setUnits(name: UnitSystem): void {
  system = name;
}

/** A unit as the program reads it, and what a value in SI is multiplied with to be written in it. */
export interface Written {
  factor: number;
  unit: string;
}

// from which size on, the largest first
const engineering: Record<string, readonly (Written & { least: number })[]> = {
  "m": [{ least: 0, factor: 1e3, unit: "mm" }],
  "m/s": [{ least: 0, factor: 1e3, unit: "mm/s" }],
  "N/m": [{ least: 0, factor: 1e-3, unit: "N/mm" }],
  "kg": [
    { least: 1, factor: 1, unit: "kg" },
    { least: 0, factor: 1e3, unit: "g" },
  ],
};

/** In what a quantity of this size is written where prefixes do not go with each value: on axes, in fields. */
export function writtenIn(unit: string, size: number): Written {
  const own = system === "engineering" ? engineering[unit]?.find(({ least }) => Math.abs(size) >= least) : undefined;
  return { factor: own?.factor ?? 1, unit: own?.unit ?? unit };
}

/** What was typed: a number alone is in the unit that stands there. */
export function withUnit(text: string, unit: string, shown: number): string {
  const written = writtenIn(unit, shown);
  return number(text) === null || written.unit === unit ? text : `${text} ${written.unit}`;
}

const scalable = new Set(["N", "N/m", "N*s/m", "m", "m/s", "m/s^2", "s", "Hz", "J", "kg"]);

/** A number with few digits: 4 significant ones unless told. */
export function plain(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-4)
    return value
      .toExponential(digits - 1)
      .replace(/\.?0+e/, "e")
      .replace("e+", "e");
  return String(Number(value.toPrecision(digits)));
}

/** Marks of a scale from low to high, with as many digits as tell each from the next. */
export function toldApart(values: readonly number[]): string[] {
  const step = Math.min(...values.slice(1).map((value, k) => value - (values[k] as number)));
  const size = Math.max(...values.map(Math.abs));
  const digits = Math.min(Math.max(4, Math.ceil(Math.log10(size / step)) + 1), 12);
  return values.map((value) => plain(value, digits));
}

export function unitText(unit: string): string {
  if (unit === "1" || unit === "") return "";
  if (unit === "deg") return "°";
  if (unit === "degC") return "°C";
  return unit.replace("1e-9 m/s", "1 nm/s").replaceAll("*", "·").replace("^2", "²");
}

/** The velocity level of the joint, which stands for a design, as `stridor simulate` prints it. */
export function level(decibels: number | null): string {
  return decibels === null ? "–" : `${decibels.toFixed(1)} dB`;
}

/** "20 N", "10 MN/m", "4 mm", "70°"; "–" for what is not known. */
export function quantity(value: number | null | undefined, unit: string, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (unit === "deg") return `${plain(value, digits)}°`;
  if (unit === "1" || unit === "") return plain(value, digits);
  const written = writtenIn(unit, value);
  if (written.unit !== unit) return `${plain(value * written.factor, digits)} ${unitText(written.unit)}`;
  if (!scalable.has(unit) || value === 0) return `${plain(value, digits)} ${unitText(unit)}`;
  if (unit === "kg") return Math.abs(value) < 1 ? `${plain(value * 1e3, digits)} g` : `${plain(value, digits)} kg`;
  const rounded = Math.abs(Number(value.toPrecision(digits)));
  if (rounded < 1e-9) return `${plain(value, digits)} ${unitText(unit)}`;
  const [factor, prefix] = prefixes.find(([size]) => rounded >= size) ?? [1e-9, "n"];
  return `${plain(value / factor, digits)} ${prefix}${unitText(unit)}`;
}

/** Two ends of a range; of levels the unit stands once. */
export function between(low: number, high: number, unit: string, word: string): string {
  return `${unit.startsWith("dB") ? plain(low, 3) : quantity(low, unit, 3)}${word}${quantity(high, unit, 3)}`;
}

/** A share of one as per cent. */
export function percent(share: number | null | undefined, digits = 1): string {
  return share === null || share === undefined || !Number.isFinite(share) ? "–" : `${(100 * share).toFixed(digits)} %`;
}

/** The shortest text that reads back as the same number: what goes to the server. */
export function exact(value: number): string {
  return String(value);
}

/** Rounds to significant digits, so that a slider gives 21.3 and not 21.287431. */
export function rounded(value: number, digits = 3): number {
  return Number(value.toPrecision(digits));
}

/** The number that a text is without help; null for one with a unit, which the program reads. */
export function number(text: string): number | null {
  return /^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i.test(text) ? Number(text) : null;
}

const greek: Record<string, string> = {
  mu: "μ",
  alpha: "α",
  beta: "β",
  delta: "δ",
  theta: "θ",
  lambda: "λ",
  omega: "ω",
};

/** "mu_d" as a letter and what stands below it: ["μ", "d"]. */
export function symbolParts(symbol: string): [string, string] {
  const [head = "", below = ""] = symbol.split("_", 2);
  if (greek[head]) return [greek[head], below];
  const match = /^([A-Za-z])(\d\w*)$/.exec(head);
  if (match) return [match[1] ?? "", match[2] ?? ""];
  return [head, below];
}

const lowered: Record<string, string> = {
  ...Object.fromEntries([..."0123456789"].map((d, i) => [d, "₀₁₂₃₄₅₆₇₈₉"[i] ?? d])),
};

/** A symbol as text, where nothing can be set lower: "μd", "k₁i". */
export function symbolText(symbol: string): string {
  const [letter, below] = symbolParts(symbol);
  return letter + [...below].map((sign) => lowered[sign] ?? sign).join("");
}

/** Parts of a line that wraps between them and never inside: "t = 5 ms · N = 20 N". */
export function inRow(parts: readonly string[]): string {
  return parts.map((part) => part.replaceAll(" ", "\u00a0")).join("\u00a0· ");
}

/** "contact.kinetic_friction" as words: "kinetic friction"; a section's only value is called as the section. */
export function words(key: string): string {
  const [section = "", name = section] = key.split(".").slice(-2);
  return (name === "value" ? section : name).replaceAll("_", " ");
}

/** "joint mass", "plate mass": the section where the name alone would not do. "lip2: mass" of one of several joints. */
export function title(key: string): string {
  const own = jointKey(key);
  if (own) return `${own.joint}: ${words(key)}`;
  const [section = "", name = key] = key.split(".", 2);
  const alone = !["mass", "stiffness", "damping"].includes(name);
  return (alone ? "" : `${section} `) + words(key);
}
