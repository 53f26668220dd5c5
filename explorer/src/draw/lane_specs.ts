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

/** A contact's column: the program numbers them from 1 where there are several. */
export function contactColumn(motion: Motion, column: string, contact: number): string {
  return motion.contacts.length > 1 ? `${column}_${contact + 1}` : column;
}

/** The column of a joint's place or velocity along x or y: those of several joints bear their names, but the first. */
export function jointColumn(motion: Motion, place: "x" | "y", contact: number): string {
  const named = `${place}_${motion.contacts[contact]?.name}`;
  return motion.contacts.length > 1 && motion.columns.has(named) ? named : `${place}1`;
}

/** The wanted lanes of a motion: with several contacts each lane stands once for each, with the joint's name. */
export function lanesOf(motion: Motion, wanted: ReadonlySet<string>): LaneSpec[] {
  const shown = laneSpecs.filter(({ name }) => wanted.has(name));
  if (motion.contacts.length < 2) return shown;
  return shown.flatMap((lane) =>
    motion.contacts.map((contact, k) => ({
      ...lane,
      title: `${contact.name}: ${lane.title}`,
      curves: lane.curves.map((curve) => ({ ...curve, column: columnOf(motion, curve.column, k) })),
    })),
  );
}

/** A column of one contact's motion, called as in a motion of one, in a motion of any number. */
export function columnOf(motion: Motion, column: string, contact: number): string {
  if (column === "surface_velocity" || motion.contacts.length < 2) return column;
  if (column === "y2") return motion.columns.has("y_plate") ? "y_plate" : column;
  const place = /^([xy])1(.*)$/.exec(column);
  if (place) return jointColumn(motion, place[1] as "x" | "y", contact) + place[2];
  return contactColumn(motion, column, contact);
}
