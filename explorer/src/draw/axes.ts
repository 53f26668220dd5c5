/** Axes around a picture: marks with their numbers, and titles. Painting only. */
import type { Scale } from "../program/words.ts";
import type { Palette } from "./colours.ts";
import { toldApart } from "./format.ts";
import { share, ticksOfScale } from "./scale.ts";
import { font } from "./surface.ts";

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

export interface AxisLook {
  title: string; // empty: marks without numbers
  from: number;
  to: number;
  scale?: Scale;
  /** Where a value lies between both ends, 0 to 1, if not simply where the scale puts it. */
  place?: (value: number) => number;
  /** What numbers are multiplied with before they are written: 1000 for mm. */
  factor?: number;
}

/** Room for the numbers of y and its title [px]. */
export function marginOf(pen: CanvasRenderingContext2D, y: AxisLook, height: number): number {
  pen.font = font(11);
  return 28 + Math.max(0, ...marksOfY(y, height).map(({ text }) => pen.measureText(text).width));
}

function marksOfY(y: AxisLook, height: number): { text: string; part: number }[] {
  return marks(y, height / 40);
}

function marks(axis: AxisLook, wanted: number): { text: string; part: number }[] {
  const { from, to, scale = "linear", factor = 1 } = axis;
  const place = axis.place ?? ((value: number) => share(value, from, to, scale));
  const values = ticksOfScale(from * factor, to * factor, scale, wanted);
  const texts = toldApart(values);
  return values.map((value, k) => ({ text: texts[k] as string, part: place(value / factor) }));
}

/** A frame with x below and y to the left of it. */
export function paintAxes(pen: CanvasRenderingContext2D, palette: Palette, box: Box, x: AxisLook, y: AxisLook): void {
  const [right, bottom] = [box.left + box.width, box.top + box.height];
  pen.strokeStyle = palette.muted;
  pen.fillStyle = palette.muted;
  pen.lineWidth = 1;
  pen.strokeRect(
    Math.round(box.left) - 0.5,
    Math.round(box.top) - 0.5,
    Math.round(box.width) + 1,
    Math.round(box.height) + 1,
  );
  pen.font = font(11);
  pen.textAlign = "center";
  pen.textBaseline = "top";
  pen.beginPath();
  for (const { text, part } of marks(x, box.width / 70)) {
    const at = Math.round(box.left + box.width * part) + 0.5;
    pen.moveTo(at, bottom);
    pen.lineTo(at, bottom + 4);
    pen.fillText(text, at, bottom + 6);
  }
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (const { text, part } of marksOfY(y, box.height)) {
    const at = Math.round(bottom - box.height * part) + 0.5;
    pen.moveTo(box.left - 4, at);
    pen.lineTo(box.left, at);
    if (y.title !== "") pen.fillText(text, box.left - 7, at);
  }
  pen.stroke();
  pen.fillStyle = palette.ink;
  pen.textAlign = "center";
  pen.textBaseline = "top";
  pen.fillText(x.title, (box.left + right) / 2, bottom + 22);
  pen.save();
  pen.translate(5, (box.top + bottom) / 2);
  pen.rotate(-Math.PI / 2);
  pen.fillText(y.title, 0, 0);
  pen.restore();
}
