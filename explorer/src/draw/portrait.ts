/** Phase portrait of the joint: velocity over displacement, coloured by the state of the contact. Painting only. */
import { lastAtMost, shownContact, valueAt, type Motion } from "../data/frames.ts";
import type { ContactState } from "../program/words.ts";
import { marginOf, paintAxes, type Box } from "./axes.ts";
import type { Palette } from "./colours.ts";
import { columnOf, isOnPlate } from "./lane_specs.ts";
import { unitText, writtenIn } from "./format.ts";
import type { Surface } from "./surface.ts";

const mostPoints = 5_000;
const finest = 2e-5; // [s] a 50th of a period at 1 kHz

/** Where a portrait lies on its canvas: its frame, left, top, width and height, and the ends of its axes [m], [m/s]. */
export type Portrait = readonly [Box, number, number, number, number];

/** Returns what was painted, if anything was. */
export function paintPortrait(
  surface: Surface,
  motion: Motion,
  span: readonly [number, number],
  now: number,
  palette: Palette,
  contact = 0,
): Portrait | undefined {
  const place = columnOf(motion, "x1", contact);
  const velocity = columnOf(motion, "x1_velocity", contact);
  const x = motion.columns.get(place)?.values;
  const v = motion.columns.get(velocity)?.values;
  if (!x || !v) return;
  const sign = motion.contacts.length > 1 || !isOnPlate(motion) ? "x" : "x₁";
  // no coarser than the orbit needs; of a longer span, the part about the present time
  const stride = Math.max(1, Math.floor(finest / motion.interval));
  const index = (time: number): number => Math.round((time - motion.start) / motion.interval);
  const [begin, end] = [Math.max(0, index(span[0])), Math.min(motion.samples - 1, index(span[1]))];
  const reach = stride * mostPoints;
  const first = Math.max(begin, Math.min(index(now) - reach / 2, end - reach));
  const last = Math.min(end, first + reach);
  const ends = (values: Float32Array): [number, number] => {
    let [low, high] = [Infinity, -Infinity];
    for (let k = first; k <= last; k += stride) {
      low = Math.min(low, values[k] as number);
      high = Math.max(high, values[k] as number);
    }
    // no finer than the samples, of 24 bits, which a joint at rest does not leave
    const size = Math.max(high, -low);
    const room = Math.max(0.06 * (high - low), 1e-6 * size) || 1e-9;
    return [low - room, high + room];
  };
  const [x0, x1] = ends(x);
  const [v0, v1] = ends(v);
  const { pen } = surface;
  const speed = writtenIn("m/s", Math.max(v1, -v0));
  const across = `${sign === "x" ? "ẋ" : "ẋ₁"} [${unitText(speed.unit)}]`;
  const y = { title: across, from: v0, to: v1, factor: speed.factor };
  const height = surface.height - 46;
  const left = Math.max(54, marginOf(pen, y, height));
  const box = { left, top: 8, width: surface.width - left - 8, height };
  if (box.width < 20 || box.height < 20) return;
  const px = (value: number): number => box.left + (box.width * (value - x0)) / (x1 - x0);
  const py = (value: number): number => box.top + (box.height * (v1 - value)) / (v1 - v0);
  paintAxes(
    pen,
    palette,
    box,
    {
      title: `${motion.contacts.length > 1 ? `${shownContact(motion, contact).name}: ` : ""}${sign} [mm]`,
      from: x0,
      to: x1,
      factor: 1000,
    },
    y,
  );

  pen.save();
  pen.beginPath();
  pen.rect(box.left, box.top, box.width, box.height);
  pen.clip();
  pen.lineWidth = 1.1;
  const stays = shownContact(motion, contact);
  let stay = Math.max(lastAtMost(stays.from, motion.start + first * motion.interval), 0);
  const paths = new Map<ContactState, Path2D>();
  for (let k = first; k + stride <= last; k += stride) {
    const time = motion.start + k * motion.interval;
    while (stay + 1 < stays.state.length && (stays.from[stay + 1] as number) <= time) ++stay;
    const state = stays.state[stay] ?? "slip";
    const path = paths.get(state) ?? new Path2D();
    paths.set(state, path);
    path.moveTo(px(x[k] as number), py(v[k] as number));
    path.lineTo(px(x[k + stride] as number), py(v[k + stride] as number));
  }
  for (const [state, path] of paths) {
    pen.strokeStyle = palette.state[state];
    pen.stroke(path);
  }
  if (now >= span[0] && now <= span[1]) {
    pen.beginPath();
    pen.arc(px(valueAt(motion, place, now)), py(valueAt(motion, velocity, now)), 5, 0, 2 * Math.PI);
    pen.fillStyle = palette.accent;
    pen.fill();
    pen.strokeStyle = palette.panel;
    pen.lineWidth = 2;
    pen.stroke();
  }
  pen.restore();
  return [box, x0, x1, v0, v1];
}
