/** What all drawings of mechanisms share: scales, a contact's state in colour and in form, its name. Painting only. */
import type { ContactState } from "../program/words.ts";
import { line, type Point } from "./sketch.ts";
import { font } from "./surface.ts";
import { palette } from "./theme.ts";

type Pen = CanvasRenderingContext2D;

/** How large the parts of a motion are drawn. */
export interface Scales {
  length: number; // [px/m]
  force: number; // [px/N]
  velocity: number; // [px s/m]
}

/** A body whose outline is the path: its field and its edge. */
export function paintBody(pen: Pen): void {
  const colours = palette();
  pen.fillStyle = colours.field;
  pen.fill();
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 1.6;
  pen.stroke();
}

/** The contact point, its state in colour and in form: stick a square, slip a disc, separation a ring. */
export function paintContact(pen: Pen, at: Point, state: ContactState, radius = 6.5): void {
  const colours = palette();
  const half = 0.92 * radius;
  pen.beginPath();
  if (state === "stick") pen.rect(at.x - half, at.y - half, 2 * half, 2 * half);
  else pen.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  pen.fillStyle = state === "separation" ? colours.panel : colours.state[state];
  pen.fill();
  pen.strokeStyle = state === "separation" ? colours.state.separation : colours.ink;
  pen.lineWidth = (state === "separation" ? 3 : 1.4) * Math.min(1, radius / 6.5);
  pen.stroke();
}

/** The state in a word, in the upper left corner; of one of several contacts behind its name. */
export function paintStateName(pen: Pen, state: ContactState, name = ""): void {
  const colours = palette();
  pen.font = font(12, 650);
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  const text = name ? `${name}: ${state}` : state;
  const width = pen.measureText(text).width + 12;
  pen.fillStyle = colours.state[state];
  pen.beginPath();
  pen.roundRect(8, 8, width, 20, 10);
  pen.fill();
  pen.fillStyle = state === "slip" || (state === "stick" && colours.name === "dark") ? "#1B1F24" : "#FFFFFF";
  pen.fillText(text, 14, 18.5);
}

/** Strokes on a surface, of which the eye sees that it moves: from `low` to `high`, `moved` along the x axis [px]. */
export function paintStrokes(pen: Pen, across: readonly [number, number], moved: number, ends: Point): void {
  const spacing = 26;
  const offset = ((moved % spacing) + spacing) % spacing;
  for (let x = across[0] + offset - spacing; x < across[1] + spacing; x += spacing)
    line(pen, x, ends.x, x + 10, ends.y);
}
