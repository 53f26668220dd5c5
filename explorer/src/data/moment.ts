/** A motion at one time, as one of its contacts has it. Pure. */
import type { ContactState } from "../program/words.ts";
import { shownContact, stateAt, valueAt, type Motion } from "./frames.ts";

export interface Moment {
  motion: Motion;
  time: number; // [s]
  contact: number; // that is regarded
  /** Columns by the names that they have in a motion of one contact. */
  at: (name: string, contact?: number) => number;
  travelled: number; // [m] of the surface since the start
}

export function momentOf(
  motion: Motion,
  time: number,
  contact: number,
  travel: Float32Array,
  columnOf: (motion: Motion, name: string, contact: number) => string,
): Moment {
  const place = Math.min(Math.max((time - motion.start) / motion.interval, 0), Math.max(travel.length - 1, 0));
  const index = Math.floor(place);
  const here = travel[index] ?? 0;
  return {
    motion,
    time,
    contact,
    at: (name, whose = contact) => valueAt(motion, columnOf(motion, name, whose), time),
    travelled: here + ((travel[index + 1] ?? here) - here) * (place - index),
  };
}

export function stateOf({ motion, time, contact }: Moment, whose = contact): ContactState {
  return stateAt(shownContact(motion, whose), time);
}
