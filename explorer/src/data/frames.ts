/** Decoding of what the server sends in pieces or in binary. Pure. */
import type { ContactState } from "../program/words.ts";
import type { MotionHeader } from "./types.ts";

/** Cuts text that arrives in pieces into lines. */
export class Lines {
  private rest_ = "";

  /** The lines that this piece completes. */
  add(piece: string): string[] {
    const lines = (this.rest_ + piece).split("\n");
    this.rest_ = lines.pop() ?? "";
    return lines.filter((line) => line.trim() !== "");
  }

  /** What was left without an end of line. */
  end(): string[] {
    const last = this.rest_.trim();
    this.rest_ = "";
    return last === "" ? [] : [last];
  }
}

export function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

export function floatsOf(base64: string): Float32Array<ArrayBuffer> {
  const bytes = bytesOf(base64);
  return new Float32Array(bytes.buffer, 0, Math.floor(bytes.length / 4));
}

/** The stays of a contact in its states. */
export interface Stays {
  name: string; // of the joint, or its own
  from: Float64Array; // [s] when each stay began; one more: when the last ended
  state: ContactState[]; // of each stay
}

/** A sampled motion: columns of equal length, uniform in time, and the stays of each contact in its states. */
export interface Motion {
  samples: number;
  start: number; // [s]
  interval: number; // [s]
  columns: Map<string, { unit: string; sentence: string; values: Float32Array }>;
  contacts: Stays[];
  /** Points of the line as which an own structure is drawn [m], at rest; none: it is not known. */
  outline: number[][];
}

/** The contact that views of one contact show; the first where the motion has no such one. */
export function shownContact(motion: Motion, contact = 0): Stays {
  return motion.contacts[contact] ?? motion.contacts[0] ?? { name: "", from: new Float64Array([0]), state: [] };
}

function aligned(offset: number): number {
  return Math.ceil(offset / 8) * 8;
}

/** Reads the answer of /api/motion; throws RangeError if it is shorter than it says. */
export function motionOf(buffer: ArrayBuffer): Motion {
  const headerLength = new DataView(buffer).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(buffer, 4, headerLength));
  const header = JSON.parse(text.replace(/[\0 ]+$/, "")) as MotionHeader;
  let offset = aligned(4 + headerLength);
  const columns: Motion["columns"] = new Map();
  for (const column of header.columns) {
    const values = new Float32Array(buffer, offset, header.samples);
    columns.set(column.name, { unit: column.unit, sentence: column.sentence, values });
    offset = aligned(offset + 4 * header.samples);
  }
  const contacts = header.contacts.map(({ name, intervals }): Stays => {
    const from = new Float64Array(buffer, offset, intervals + 1);
    offset += 8 * (intervals + 1);
    const numbers = new Uint8Array(buffer, offset, intervals);
    offset = aligned(offset + intervals);
    return { name, from, state: Array.from(numbers, (number) => header.states[number] ?? "separation") };
  });
  return {
    samples: header.samples,
    start: header.start,
    interval: header.interval,
    columns,
    contacts,
    outline: header.outline ?? [],
  };
}

/** Index of the last element that is at most the value; -1 if all are above it. Ascending order. */
export function lastAtMost(values: ArrayLike<number>, value: number): number {
  let low = -1;
  let high = values.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((values[middle] as number) <= value) low = middle;
    else high = middle;
  }
  return low;
}

/** The state of a contact at a time; the first or last state outside the motion. */
export function stateAt(contact: Stays, time: number): ContactState {
  const at = Math.min(Math.max(lastAtMost(contact.from, time), 0), contact.state.length - 1);
  return contact.state[at] ?? "separation";
}

/** A column's value at a time, linear between samples. */
export function valueAt(motion: Motion, name: string, time: number): number {
  const values = motion.columns.get(name)?.values;
  if (!values || values.length === 0) return 0;
  const place = Math.min(Math.max((time - motion.start) / motion.interval, 0), values.length - 1);
  const index = Math.min(Math.floor(place), Math.max(values.length - 2, 0));
  const first = values[index] ?? 0;
  return first + ((values[index + 1] ?? first) - first) * (place - index);
}
