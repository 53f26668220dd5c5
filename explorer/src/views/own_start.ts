/** A start of the user's own: a click on the phase portrait begins the joint's motion at that place and velocity. */
import { shownContact, type Motion } from "../data/frames.ts";
import { isOnPlate } from "../draw/lane_specs.ts";
import type { Portrait } from "../draw/portrait.ts";
import { withoutKeys, withValues, type Design } from "../state/state.ts";
import type { Store } from "../state/store.ts";

/** Begins where the portrait was clicked; beside its frame, and of what is no joint on a plate, nothing happens. */
export function beginAt(store: Store, event: MouseEvent, portrait: Portrait, motion: Motion, contact: number): void {
  const point = pointOf(portrait, event.offsetX, event.offsetY);
  if (!point || !isOnPlate(motion)) return;
  const joint = motion.contacts.length > 1 ? shownContact(motion, contact).name : "";
  store.update({ design: withStart(store.state.design, joint, point.x, point.v) });
}

/** The place [m] and velocity [m/s] at a point of the canvas [px]; null beside the frame. */
export function pointOf(portrait: Portrait, px: number, py: number): { x: number; v: number } | null {
  const [box, x0, x1, v0, v1] = portrait;
  const [across, down] = [(px - box.left) / box.width, (py - box.top) / box.height];
  if (across < 0 || across > 1 || down < 0 || down > 1) return null;
  return { x: x0 + across * (x1 - x0), v: v1 - down * (v1 - v0) };
}

/**
 * A design whose joint of that name (empty: the only one) begins in contact, at a place [m] and velocity [m/s] along
 * the plate; all else begins at the preloaded rest.
 */
export function withStart(design: Design, joint: string, x: number, v: number): Design {
  const before = Object.keys(design.set).filter((key) => /\.initial_(tangential|normal|state)/.test(key));
  const key = `joint.${joint && `${joint}.`}initial_tangential`;
  const digits = (value: number): string => String(Number(value.toPrecision(6)));
  return withValues(withoutKeys(design, before), {
    "run.initial": "given",
    [key]: digits(x),
    [`${key}_velocity`]: digits(v),
  });
}
