/** Several contacts and the wholes that they are judged as. Pure. */
import type { Category } from "../program/words.ts";
import type { InterfaceResult, PhaseResult, Verdict } from "./types.ts";

/** A contact beside what it carries. */
export interface ContactRow {
  name: string;
  index: number; // in the order of the structure
  verdict: Verdict | null; // none of one that carries nothing
  load: InterfaceResult["contacts"][number] | undefined;
}

// from the loudest noise to none
const severity: readonly Category[] = ["squeal", "squeak", "creak", "undecided", "none"];

function rank({ verdict }: ContactRow): number {
  return verdict ? severity.indexOf(verdict.category) : severity.length;
}

/** The contacts of a phase, the worst first: by category, then by level; what carries nothing comes last. */
export function worstFirst(phase: PhaseResult): ContactRow[] {
  const loads = new Map((phase.interfaces ?? []).flatMap(({ contacts }) => contacts.map((each) => [each.name, each])));
  const rows = (phase.contacts ?? []).map(({ name, verdict }, index): ContactRow => ({
    name,
    index,
    verdict,
    load: loads.get(name),
  }));
  const levelOf = ({ verdict }: ContactRow): number => verdict?.levels.joint.level ?? -Infinity;
  return rows.sort((a, b) => rank(a) - rank(b) || levelOf(b) - levelOf(a) || a.index - b.index);
}
