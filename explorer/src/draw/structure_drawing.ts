/**
 * A structure of the user's own at one moment. Painting only.
 *
 * Several contacts, or a string: from above, the line of contacts from left to right, what moves along the sliding
 * direction up and down, and the normal forces as bars below. One contact: from the side, the beam if it is one.
 */
import type { Motion } from "../data/frames.ts";
import { placesOf } from "../data/cases.ts";
import { stateOf, type Moment } from "../data/moment.ts";
import type { OwnContact } from "../program/words.ts";
import { paintBody, paintContact, paintStateName, paintStrokes, type Scales } from "./contact_mark.ts";
import { arrow, line, sign, type Point } from "./sketch.ts";
import { font, type Surface } from "./surface.ts";
import { palette } from "./theme.ts";

const room = { left: 30, right: 34, top: 36, bottom: 24 };
const mostArrows = 24; // contacts whose friction is drawn
const drawnReach = 34; // [px] of the largest motion at the scale of lengths

/** Does its outline run along the line of contacts, as a string does? */
function isAlongLine({ outline }: Motion): boolean {
  return (outline.at(-1)?.[2] ?? 0) !== (outline[0]?.[2] ?? 0);
}

/** Returns how large it drew what moves [px/m]. */
export function paintStructure(s: Surface, moment: Moment, scales: Scales, contacts: readonly OwnContact[]): number {
  const { motion } = moment;
  const isSeenFromAbove = motion.contacts.length > 1 || isAlongLine(motion);
  const unit = isSeenFromAbove ? paintFromAbove(s, moment, scales, contacts) : paintFromSide(s, moment, scales);
  const several = motion.contacts.length > 1;
  paintStateName(s.pen, stateOf(moment), several ? (motion.contacts[moment.contact]?.name ?? "") : "");
  return unit;
}

/** Displacement of a point of the outline; nothing of one that cannot move. */
function deflection(moment: Moment, point: number): Point {
  return { x: moment.at(`outline_${point + 1}_x`), y: moment.at(`outline_${point + 1}_y`) };
}

function paintFromAbove(s: Surface, moment: Moment, scales: Scales, contacts: readonly OwnContact[]): number {
  const { pen, width, height } = s;
  const colours = palette();
  const barsHeight = Math.min(56, 0.24 * height);
  const bottom = height - room.bottom - barsHeight - 12;
  const middle = (room.top + bottom) / 2;
  const unit = (scales.length * 0.4 * (bottom - room.top)) / drawnReach;
  paintMovingSurface(s, moment, scales, { top: room.top, bottom, unit });

  const { outline } = moment.motion;
  const onString = isAlongLine(moment.motion);
  const length = outline.at(-1)?.[2] ?? 1;
  const inner = width - room.left - room.right;
  const places = placesOf(contacts);
  const inset = onString ? 0 : Math.min(24, inner / (2 * contacts.length));
  const across = (k: number): number => {
    const share = onString ? (contacts[k]?.position?.[2] ?? 0) / length : (places[k] ?? 0);
    return room.left + inset + (inner - 2 * inset) * share;
  };
  const points = contacts.map((_, k) => ({ x: across(k), y: middle - unit * moment.at("x1", k) }));
  const shape = onString
    ? outline.map((position, k) => ({
        x: room.left + (inner * (position[2] ?? 0)) / length,
        y: middle - unit * deflection(moment, k).x,
      }))
    : points;
  paintShape(pen, shape, { from: room.left, to: room.left + inner, y: middle });
  points.forEach((at, k) => paintOne(s, moment, scales, { at, k, radius: radiusOf(points) }));
  paintBars(s, moment, scales, points, { base: height - room.bottom, height: barsHeight });
  pen.font = font(10);
  pen.fillStyle = colours.muted;
  pen.textBaseline = "alphabetic";
  pen.textAlign = "left";
  pen.fillText("N", room.left - 16, height - room.bottom - 2);
  pen.save();
  pen.translate(12, middle);
  pen.rotate(-Math.PI / 2);
  pen.textAlign = "center";
  pen.fillText("sliding direction →", 0, 0);
  pen.restore();
  return unit;
}

/** Of a mark: as large as half of the neighbours leave room for. */
function radiusOf(points: readonly Point[]): number {
  const gaps = points.slice(1).map(({ x }, k) => Math.abs(x - (points[k] as Point).x));
  gaps.sort((a, b) => a - b);
  return Math.min(6.5, Math.max(1.5, 0.3 * (gaps[Math.floor(gaps.length / 2)] ?? Infinity)));
}

/** The surface seen from above: strokes that move along the sliding direction, which is up, and its velocity. */
function paintMovingSurface(
  { pen, width }: Surface,
  moment: Moment,
  scales: Scales,
  box: { top: number; bottom: number; unit: number },
): void {
  const colours = palette();
  const inner = width - room.left - room.right;
  pen.fillStyle = colours.grid;
  pen.fillRect(room.left, box.top, inner, box.bottom - box.top);
  pen.save();
  pen.beginPath();
  pen.rect(room.left, box.top, inner, box.bottom - box.top);
  pen.clip();
  pen.strokeStyle = colours.line;
  pen.lineWidth = 1;
  pen.translate(0, box.bottom);
  pen.rotate(-Math.PI / 2); // x is up now, y to the right
  for (let x = room.left + 10; x < width - room.right; x += 52)
    paintStrokes(pen, [0, box.bottom - box.top], box.unit * moment.travelled, { x, y: x + 16 });
  pen.restore();
  const speed = moment.at("surface_velocity") * scales.velocity;
  const from = { x: width - room.right / 2, y: (box.top + box.bottom + speed) / 2 };
  arrow(pen, from, { x: from.x, y: from.y - speed }, colours.muted, colours.panel);
  pen.fillStyle = colours.muted;
  sign(pen, ["V", ""], { x: from.x - 5, y: Math.max(from.y, from.y - speed) + 12 });
}

/** The deflected line over where it is at rest. */
function paintShape(
  pen: CanvasRenderingContext2D,
  shape: readonly Point[],
  rest: { from: number; to: number; y: number },
): void {
  const colours = palette();
  pen.save();
  pen.strokeStyle = colours.muted;
  pen.lineWidth = 1;
  pen.setLineDash([3, 4]);
  line(pen, rest.from, rest.y, rest.to, rest.y);
  pen.restore();
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 1.8;
  pen.lineJoin = "round";
  pen.beginPath();
  for (const { x, y } of shape) pen.lineTo(x, y);
  pen.stroke();
}

/** A contact with its friction; the chosen one within a ring. */
function paintOne(
  { pen }: Surface,
  moment: Moment,
  scales: Scales,
  { at, k, radius }: { at: Point; k: number; radius: number },
): void {
  const colours = palette();
  const state = stateOf(moment, k);
  const T = Math.min(Math.max(moment.at("friction_force", k) * scales.force, -40), 40);
  if (state !== "separation" && moment.motion.contacts.length <= mostArrows)
    arrow(pen, at, { x: at.x, y: at.y - T }, colours.traces[1], colours.panel);
  paintContact(pen, at, state, radius);
  if (k !== moment.contact) return;
  pen.strokeStyle = colours.accent;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.arc(at.x, at.y, radius + 4, 0, 2 * Math.PI);
  pen.stroke();
  pen.fillStyle = colours.traces[1];
  if (Math.abs(T) > 18) sign(pen, ["T", ""], { x: at.x + 8, y: at.y - T + (T > 0 ? 4 : -4) });
}

/** The normal forces as bars, and the names where there is room. */
function paintBars(
  { pen, width }: Surface,
  moment: Moment,
  scales: Scales,
  points: readonly Point[],
  { base, height }: { base: number; height: number },
): void {
  const colours = palette();
  const half = (k: number): number => {
    const gaps = [points[k - 1], points[k + 1]].map((other) =>
      other ? Math.abs(other.x - (points[k] as Point).x) : Infinity,
    );
    return Math.min(7, Math.max(0.5, 0.4 * Math.min(...gaps)));
  };
  pen.strokeStyle = colours.line;
  pen.lineWidth = 1;
  line(pen, room.left, base, width - room.right, base);
  pen.font = font(10);
  pen.textAlign = "center";
  pen.textBaseline = "top";
  let free = -Infinity; // right end of the last name
  points.forEach(({ x }, k) => {
    const N = Math.min((moment.at("normal_force", k) * scales.force * height) / 50, height);
    pen.fillStyle = colours.traces[0];
    pen.fillRect(x - half(k), base - N, 2 * half(k), N);
    const name = moment.motion.contacts[k]?.name ?? "";
    const wide = pen.measureText(name).width / 2;
    const middle = Math.min(Math.max(x, wide + 2), width - wide - 2);
    if (middle - wide < free + 4) return;
    pen.fillStyle = k === moment.contact ? colours.accent : colours.muted;
    pen.fillText(name, middle, base + 4);
    free = middle + wide;
  });
}

function paintFromSide(s: Surface, moment: Moment, scales: Scales): number {
  const { pen, width, height } = s;
  const colours = palette();
  const rest = { x: width / 2, y: height * 0.74 };
  const unit = scales.length * Math.min(1, height / 300);
  const contact = { x: rest.x + unit * moment.at("x1"), y: rest.y - unit * moment.at("y1") };
  pen.fillStyle = colours.grid;
  pen.fillRect(0, rest.y, width, 22);
  pen.strokeStyle = colours.line;
  pen.lineWidth = 1.2;
  paintStrokes(pen, [0, width], rest.x + unit * moment.travelled, { x: rest.y + 21, y: rest.y + 1 });
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 1.6;
  line(pen, 0, rest.y, width, rest.y);
  if (moment.motion.outline.length > 1) paintBeam(s, moment, unit, rest);
  else paintBlock(pen, contact, moment.motion.contacts[0]?.name ?? "");

  const state = stateOf(moment);
  if (state !== "separation") {
    const clamp = (value: number): number => Math.min(Math.max(value * scales.force, -60), 60);
    const [N, T] = [clamp(moment.at("normal_force")), clamp(moment.at("friction_force"))];
    arrow(pen, contact, { x: contact.x, y: contact.y - N }, colours.traces[0], colours.panel);
    arrow(pen, contact, { x: contact.x + T, y: contact.y }, colours.traces[1], colours.panel);
    pen.fillStyle = colours.traces[0];
    if (N > 28) sign(pen, ["N", ""], { x: contact.x + 7, y: contact.y - N + 4 });
    pen.fillStyle = colours.traces[1];
    if (Math.abs(T) > 16) sign(pen, ["T", ""], { x: contact.x + T + (T > 0 ? 5 : -16), y: contact.y + 12 });
  }
  paintContact(pen, contact, state);
  const speed = moment.at("surface_velocity") * scales.velocity;
  const from = { x: width - 62, y: rest.y + 38 };
  arrow(pen, from, { x: from.x + speed, y: from.y }, colours.muted, colours.panel);
  pen.fillStyle = colours.muted;
  sign(pen, ["V", ""], { x: from.x - 4, y: from.y + 14 });
  return unit;
}

/** A beam in its true proportions, with its deflection drawn larger; dashed where it is at rest. */
function paintBeam({ pen, width }: Surface, moment: Moment, unit: number, rest: Point): void {
  const colours = palette();
  const { outline } = moment.motion;
  const reach = (axis: 0 | 1): number => Math.max(...outline.map((position) => Math.abs(position[axis] ?? 0)), 1e-12);
  const size = Math.min((width / 2 - 40) / reach(0), (rest.y - 50) / reach(1));
  const at = (k: number): Point => ({
    x: rest.x + size * (outline[k]?.[0] ?? 0),
    y: rest.y - size * (outline[k]?.[1] ?? 0),
  });
  const path = (shift: (k: number) => Point): void => {
    pen.beginPath();
    outline.forEach((_, k) => pen.lineTo(at(k).x + unit * shift(k).x, at(k).y - unit * shift(k).y));
    pen.stroke();
  };
  pen.save();
  pen.strokeStyle = colours.muted;
  pen.lineWidth = 1;
  pen.setLineDash([3, 4]);
  path(() => ({ x: 0, y: 0 }));
  pen.restore();
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 3;
  pen.lineJoin = "round";
  path((k) => deflection(moment, k));
  const clamped = at(0);
  pen.fillStyle = colours.muted;
  pen.fillRect(clamped.x - 9, clamped.y - 9, 18, 18);
}

/** Of a structure whose form is not known: a block with the contact's name. */
function paintBlock(pen: CanvasRenderingContext2D, contact: Point, name: string): void {
  const colours = palette();
  pen.beginPath();
  pen.moveTo(contact.x, contact.y);
  pen.lineTo(contact.x + 12, contact.y - 16);
  pen.lineTo(contact.x + 40, contact.y - 18);
  pen.lineTo(contact.x + 40, contact.y - 60);
  pen.lineTo(contact.x - 40, contact.y - 60);
  pen.lineTo(contact.x - 40, contact.y - 18);
  pen.lineTo(contact.x - 12, contact.y - 16);
  pen.closePath();
  paintBody(pen);
  pen.font = font(12);
  pen.fillStyle = colours.ink;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(name, contact.x, contact.y - 39);
}
