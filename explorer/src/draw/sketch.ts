/** The parts that mechanisms are drawn of: springs, dashpots, walls, arrows. */

export interface Point {
  x: number;
  y: number;
}

type Pen = CanvasRenderingContext2D;

/** Draws in a frame that has its origin at one point and its x axis towards another; gives the distance. */
function along(pen: Pen, from: Point, to: Point, draw: (length: number) => void): void {
  pen.save();
  pen.translate(from.x, from.y);
  pen.rotate(Math.atan2(to.y - from.y, to.x - from.x));
  draw(Math.hypot(to.x - from.x, to.y - from.y));
  pen.restore();
}

/** A spring and a dashpot side by side, as one. */
export function springDashpot(pen: Pen, from: Point, to: Point, half = 8): void {
  along(pen, from, to, (length) => {
    const lead = Math.min(8, length * 0.1);
    line(pen, 0, 0, lead, 0);
    line(pen, lead, -half, lead, half);
    line(pen, length - lead, -half, length - lead, half);
    line(pen, length - lead, 0, length, 0);
    coil(pen, lead, length - lead, -half, 5);
    dashpot(pen, lead, length - lead, half);
  });
}

function coil(pen: Pen, from: number, to: number, y: number, amplitude: number): void {
  const turns = 7;
  const lead = (to - from) * 0.12;
  const step = (to - from - 2 * lead) / (2 * turns);
  pen.beginPath();
  pen.moveTo(from, y);
  pen.lineTo(from + lead, y);
  for (let k = 0; k < 2 * turns; ++k)
    pen.lineTo(from + lead + (k + 0.5) * step, y + (k % 2 === 0 ? -amplitude : amplitude));
  pen.lineTo(to - lead, y);
  pen.lineTo(to, y);
  pen.stroke();
}

function dashpot(pen: Pen, from: number, to: number, y: number): void {
  const middle = (from + to) / 2;
  const size = Math.min(11, (to - from) * 0.2);
  line(pen, from, y, middle - size, y);
  pen.beginPath();
  pen.moveTo(middle + size, y - 5);
  pen.lineTo(middle - size, y - 5);
  pen.lineTo(middle - size, y + 5);
  pen.lineTo(middle + size, y + 5);
  pen.stroke();
  line(pen, middle, y - 4, middle, y + 4);
  line(pen, middle, y, to, y);
}

/** A wall through a point, square to the direction towards another; hatched on the far side. */
export function wall(pen: Pen, at: Point, towards: Point, half = 22): void {
  along(pen, at, towards, () => {
    line(pen, 0, -half, 0, half);
    for (let y = -half + 3; y <= half; y += 6) line(pen, 0, y, -6, y - 5);
  });
}

/** An arrow with a halo, so that it reads on every ground; nothing if it is too short to see. */
export function arrow(pen: Pen, from: Point, to: Point, colour: string, halo: string): void {
  along(pen, from, to, (length) => {
    if (length < 3) return;
    const head = Math.min(9, length);
    for (const [stroke, extra] of [
      [halo, 3],
      [colour, 0],
    ] as const) {
      pen.strokeStyle = pen.fillStyle = stroke;
      pen.lineWidth = 2.2 + extra;
      pen.lineJoin = "round";
      if (length > head) line(pen, 0, 0, length - head + 1, 0);
      pen.beginPath();
      pen.moveTo(length, 0);
      pen.lineTo(length - head, -head * 0.45);
      pen.lineTo(length - head, head * 0.45);
      pen.closePath();
      if (extra) pen.stroke();
      pen.fill();
    }
  });
}

export function line(pen: Pen, x0: number, y0: number, x1: number, y1: number): void {
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
}

/** A letter with what stands below it, from its left. */
export function sign(pen: Pen, parts: readonly [string, string], at: Point, size = 14): void {
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  pen.font = `italic ${size}px "STIX Two Text", "Libertinus Serif", Georgia, "Liberation Serif", "DejaVu Serif", serif`;
  pen.fillText(parts[0], at.x, at.y);
  const width = pen.measureText(parts[0]).width;
  pen.font =
    `${Math.round(size * 0.72)}px "STIX Two Text", "Libertinus Serif", Georgia, "Liberation Serif", ` +
    '"DejaVu Serif", serif';
  pen.fillText(parts[1], at.x + width + 0.5, at.y + size * 0.3);
}
