/** Numbers with their units, and the field's symbols, as people write them. Pure. */

const prefixes: readonly [number, string][] = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];
const scalable = new Set(["N", "N/m", "N*s/m", "m", "m/s", "m/s^2", "s", "Hz", "J", "kg"]);

/** A number with few digits: 4 significant ones unless told. */
export function plain(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-4) return value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e");
  return String(Number(value.toPrecision(digits)));
}

export function unitText(unit: string): string {
  if (unit === "1" || unit === "") return "";
  if (unit === "deg") return "°";
  return unit.replaceAll("*", "·").replace("^2", "²");
}

/** "20 N", "10 MN/m", "4 mm", "70°"; "–" for what is not known. */
export function quantity(value: number | null | undefined, unit: string, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (unit === "deg") return `${plain(value, digits)}°`;
  if (unit === "1" || unit === "") return plain(value, digits);
  if (!scalable.has(unit) || value === 0) return `${plain(value, digits)} ${unitText(unit)}`;
  if (unit === "kg") return Math.abs(value) < 1 ? `${plain(value * 1e3, digits)} g` : `${plain(value, digits)} kg`;
  const rounded = Math.abs(Number(value.toPrecision(digits)));
  if (rounded < 1e-9) return `${plain(value, digits)} ${unitText(unit)}`;
  const [factor, prefix] = prefixes.find(([size]) => rounded >= size) ?? [1e-9, "n"];
  return `${plain(value / factor, digits)} ${prefix}${unitText(unit)}`;
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

const factors: Record<string, number> = { G: 1e9, M: 1e6, k: 1e3, "": 1, m: 1e-3, u: 1e-6, µ: 1e-6, μ: 1e-6, n: 1e-9 };

/** Reads "20", "1e7", "4 mm", "70°" or "10 MN/m" for a field of this unit; null if it is no such number. */
export function read(text: string, unit: string): number | null {
  const match = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\S*)\s*$/.exec(text.replace(",", "."));
  if (!match) return null;
  const number = Number(match[1]);
  const said = (match[2] ?? "").replaceAll("·", "*").replace("²", "^2").replace("°", "deg").replace(/^%$/, "");
  if ((match[2] ?? "") === "%") return unit === "1" ? scaledBack(number, 100) : null;
  if (said === "" || said === unit) return number;
  if (unit === "kg" && said === "g") return scaledBack(number, 1e3);
  if (!said.endsWith(unit)) return null;
  const factor = factors[said.slice(0, said.length - unit.length)];
  if (factor === undefined || !scalable.has(unit)) return null;
  return factor < 1 ? scaledBack(number, Math.round(1 / factor)) : number * factor;
}

/** Division by a whole number: nearer to what was meant than the product with its inverse. */
function scaledBack(number: number, divisor: number): number {
  return number / divisor;
}

const greek: Record<string, string> = { mu: "μ", alpha: "α", beta: "β", lambda: "λ", omega: "ω" };

/** "mu_d" as a letter and what stands below it: ["μ", "d"]. */
export function symbolParts(symbol: string): [string, string] {
  const [head = "", below = ""] = symbol.split("_", 2);
  if (greek[head]) return [greek[head], below];
  const match = /^([A-Za-z])(\d\w*)$/.exec(head);
  if (match) return [match[1] ?? "", match[2] ?? ""];
  return [head, below];
}

const lowered: Record<string, string> = { ...Object.fromEntries([..."0123456789"].map((d, i) => [d, "₀₁₂₃₄₅₆₇₈₉"[i] ?? d])) };

/** A symbol as text, where nothing can be set lower: "μd", "k₁i". */
export function symbolText(symbol: string): string {
  const [letter, below] = symbolParts(symbol);
  return letter + [...below].map((sign) => lowered[sign] ?? sign).join("");
}

/** "contact.kinetic_friction" as words: "kinetic friction". */
export function words(key: string): string {
  const name = key.split(".").pop() ?? key;
  return name.replaceAll("_", " ");
}

/** "joint mass" and "plate mass": the section where the name alone would not do. */
export function title(key: string): string {
  const [section = "", name = key] = key.split(".", 2);
  const alone = !["mass", "stiffness", "damping"].includes(name);
  return (alone ? "" : `${section} `) + words(key);
}
