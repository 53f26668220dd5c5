/** Which curves of a motion stand in which lane. Pure. */
import type { Motion } from "../data/frames.ts";

export interface LaneSpec {
  name: string;
  title: string;
  /** Peaks of single samples, as impacts make them, do not set the scale. */
  spiky: boolean;
  curves: { column: string; label: string; colour: 0 | 1 | 2 | 3 | "muted" }[];
}

/** The lanes of a motion with one contact; their names and titles are those of the lanes of any. */
export const laneSpecs: readonly LaneSpec[] = [
  {
    name: "velocity",
    title: "velocity",
    spiky: false,
    curves: [
      { column: "surface_velocity", label: "plate V", colour: "muted" },
      { column: "x1_velocity", label: "joint ẋ₁", colour: 0 },
    ],
  },
  {
    name: "displacement",
    title: "displacement",
    spiky: false,
    curves: [
      { column: "x1", label: "x₁", colour: 0 },
      { column: "y1", label: "y₁", colour: 1 },
      { column: "y2", label: "y₂", colour: 2 },
    ],
  },
  {
    name: "force",
    title: "force",
    spiky: true,
    curves: [
      { column: "normal_force", label: "normal N", colour: 0 },
      { column: "friction_force", label: "friction T", colour: 1 },
    ],
  },
  { name: "gap", title: "gap", spiky: false, curves: [{ column: "gap", label: "gap", colour: 3 }] },
];

/** Contacts up to which each has lanes of its own; of more those of the chosen one are shown. */
export const mostLaned = 3;

const mostOutputs = 4; // curves of one lane

/** Is it the motion of joints on a plate, not of a structure of the user's own? */
export function isOnPlate(motion: Motion): boolean {
  return motion.columns.has("y2") || motion.columns.has("y_plate");
}

/** A contact's column: the program numbers them from 1 where there are several. */
export function contactColumn(motion: Motion, column: string, contact: number): string {
  return motion.contacts.length > 1 ? `${column}_${contact + 1}` : column;
}

/** The column of a contact's place or velocity along x or y: those of several bear their names, but the first joint. */
export function jointColumn(motion: Motion, place: "x" | "y", contact: number): string {
  const named = `${place}_${motion.contacts[contact]?.name}`;
  return motion.contacts.length > 1 && motion.columns.has(named) ? named : `${place}1`;
}

/**
 * The wanted lanes of a motion: with few contacts each lane stands once for each, with its name, as long as there is
 * room for so many; else those of the chosen one. Below them the outputs of a structure of the user's own.
 */
export function lanesOf(motion: Motion, wanted: ReadonlySet<string>, chosen = 0, most = Infinity): LaneSpec[] {
  const specs = isOnPlate(motion) ? laneSpecs : laneSpecs.map(ofStructure);
  const shown = specs.filter(({ name }) => wanted.has(name));
  const outputs = wanted.has("velocity") ? outputLanes(motion) : [];
  if (motion.contacts.length < 2) return [...shown, ...outputs];
  const isRoom = motion.contacts.length * shown.length + outputs.length <= most;
  const laned = motion.contacts
    .map((contact, k) => ({ contact, k }))
    .filter(({ k }) => (isRoom ? isLaned(motion, k, chosen) : k === chosen));
  const own = shown.flatMap((lane) =>
    laned.map(({ contact, k }) => ({
      ...lane,
      title: `${contact.name}: ${lane.title}`,
      curves: lane.curves.map((curve) => ({ ...curve, column: columnOf(motion, curve.column, k) })),
    })),
  );
  return [...own, ...outputs];
}

/** Has a contact lanes of its own? */
export function isLaned(motion: Motion, contact: number, chosen: number): boolean {
  return motion.contacts.length <= mostLaned || contact === chosen;
}

/** A lane in the words of a structure: it rubs on a surface, and has no plate that moves. */
function ofStructure(lane: LaneSpec): LaneSpec {
  const labels: Record<string, string> = { surface_velocity: "surface V", x1_velocity: "contact ẋ", x1: "x", y1: "y" };
  const curves = lane.curves.filter(({ column }) => column !== "y2");
  return { ...lane, curves: curves.map((curve) => ({ ...curve, label: labels[curve.column] ?? curve.label })) };
}

function outputLanes(motion: Motion): LaneSpec[] {
  const names = [...motion.columns.keys()].filter((name) => name.startsWith("velocity_")).slice(0, mostOutputs);
  if (names.length === 0) return [];
  const curves = names.map((column, k) => ({
    column,
    label: column.slice("velocity_".length),
    colour: ([0, 1, 2, 3] as const)[k] ?? 0,
  }));
  return [{ name: "outputs", title: "outputs: velocity", spiky: false, curves }];
}

/** A column of one contact's motion, called as in a motion of one, in a motion of any number. */
export function columnOf(motion: Motion, column: string, contact: number): string {
  if (column === "surface_velocity" || motion.contacts.length < 2) return column;
  if (column === "y2") return motion.columns.has("y_plate") ? "y_plate" : column;
  const place = /^([xy])1(.*)$/.exec(column);
  if (place) return jointColumn(motion, place[1] as "x" | "y", contact) + place[2];
  return contactColumn(motion, column, contact);
}
