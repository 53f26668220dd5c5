/** What a choice takes with it, from the program's field table: which keys it needs, which lose their meaning. Pure. */
import type { Field } from "../data/types.ts";
import { exact, rounded } from "../draw/format.ts";
import type { Direction } from "../program/words.ts";

/** Keys that mean nothing any more, or something else, once a choice is made anew. */
export function dependants(fields: readonly Field[], choice: string): string[] {
  return fields.filter((field) => choice in field.belongs_to).map(({ key }) => key);
}

/** Does a choice need a file, which the page cannot name? */
export function needsFile(fields: readonly Field[], choice: string, name: string): boolean {
  return fields.some(({ kind, belongs_to }) => kind === "text" && belongs_to[choice]?.includes(name));
}

/**
 * What a choice cannot do without and the present case may not have: its own value if it has one, else one that makes
 * the least of the change, else the program's default.
 *
 * @param now the present case's value of a quantity; not a number where it has none
 */
export function companions(
  fields: readonly Field[],
  choice: string,
  name: string,
  now: (key: string) => number,
  direction: Direction,
): Record<string, string> {
  const needed: Record<string, string> = {};
  for (const field of fields) {
    if (field.kind !== "quantity" || field.default === undefined) continue;
    if (!field.belongs_to[choice]?.includes(name)) continue;
    const known = now(field.key);
    needed[field.key] = exact(Number.isFinite(known) ? known : (likened(field.key, now, direction) ?? field.default));
  }
  return needed;
}

const usualFrequency = 5; // [Hz] of a drive that had none

/** A value that keeps a motion as fast, and a law of friction as it was one way. */
function likened(key: string, now: (key: string) => number, direction: Direction): number | undefined {
  const frequency = now("drive.frequency") || usualFrequency;
  const peak = 2 * Math.PI * frequency * now("drive.amplitude");
  const known = [Math.abs(now("drive.velocity")), peak].find((speed) => Number.isFinite(speed) && speed > 0);
  if (key === "drive.velocity" && known) return direction === "going" ? rounded(known) : -rounded(known);
  if (key === "drive.amplitude" && known) return rounded(known / (2 * Math.PI * frequency));
  const bothWays = now(key.replace(/_coming$/, ""));
  return Number.isFinite(bothWays) ? bothWays : undefined;
}
