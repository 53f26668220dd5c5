/** The rubbing system of the paper's Figure 2 at one moment, with its contact's state and forces. Painting only. */
import { stateOf, type Moment } from "../data/moment.ts";
import { paintBody, paintContact, paintStateName, paintStrokes, type Scales } from "./contact_mark.ts";
import { arrow, line, sign, springDashpot, wall, type Point } from "./sketch.ts";
import type { Surface } from "./surface.ts";
import { palette } from "./theme.ts";

/** `alpha` is the incidence angle [rad]. Returns how large it drew what moves [px/m]. */
export function paintRubbingSystem(s: Surface, moment: Moment, scales: Scales, alpha: number): number {
  const { pen, width, height } = s;
  const unit = scales.length * Math.min(1, height / 300);
  const rest = { x: width * 0.5, y: height * 0.64 };
  const contact = { x: rest.x + unit * moment.at("x1"), y: rest.y - unit * moment.at("y1") };
  const plateTop = rest.y - unit * moment.at("y2");
  const body = { x: contact.x, y: contact.y - 34 };
  pen.lineWidth = 1.3;
  pen.lineCap = "round";
  pen.strokeStyle = palette().muted;
  paintSupports(s, rest, body, alpha);
  paintPlate(s, plateTop, rest.x + unit * moment.travelled, rest.x, moment.at("surface_velocity") * scales.velocity);
  paintJoint(s, contact, body);
  paintForces(s, contact, plateTop, moment, scales);
  return unit;
}

/**
 * The joint's springs and dashpots to their walls, along i and j, and the angle between x and i. The signs stand
 * beside them where neither the arc nor the line of the angle passes: above a spring that lies low on the right.
 */
function paintSupports(s: Surface, rest: Point, body: Point, alpha: number): void {
  const { pen, width, height } = s;
  const colours = palette();
  const home = { x: rest.x, y: rest.y - 34 };
  const axes: [Point, string][] = [
    [{ x: Math.cos(alpha), y: -Math.sin(alpha) }, "1i"],
    [{ x: -Math.sin(alpha), y: -Math.cos(alpha) }, "1j"],
  ];
  for (const [direction, name] of axes) {
    const up = direction.y > 0.05 ? -1 : 1; // a spring pulls alike on either side: keep it above the plate
    const d = { x: direction.x * up, y: direction.y * up };
    const reach = Math.min(
      (width / 2 - 26) / Math.max(Math.abs(d.x), 1e-6),
      (home.y - 20) / Math.max(-d.y, 1e-6),
      0.47 * height,
    );
    const anchor = { x: home.x + d.x * reach, y: home.y + d.y * reach };
    pen.strokeStyle = colours.ink;
    springDashpot(pen, { x: body.x + d.x * 14, y: body.y + d.y * 14 }, anchor);
    pen.strokeStyle = colours.muted;
    wall(pen, anchor, home);
    pen.fillStyle = colours.ink;
    const isLow = d.x > 0.78; // below 39 degrees, to the right
    const beside = (part: number, aside: number): Point => ({
      // half of the sign, and a little off the drawing
      x: body.x + (anchor.x - body.x) * part - d.y * aside - (aside < 0 ? 11 : 5),
      y: body.y + (anchor.y - body.y) * part + d.x * aside,
    });
    sign(pen, ["k", name], beside(isLow ? 0.45 : 0.62, isLow ? -27 : -24));
    sign(pen, ["c", name], beside(isLow ? 0.82 : 0.62, isLow ? -27 : 25));
  }
  paintAngle(s, home, alpha);
}

function paintAngle(s: Surface, home: Point, alpha: number): void {
  const { pen } = s;
  pen.save();
  pen.strokeStyle = palette().muted;
  pen.setLineDash([3, 3]);
  // the sign of a small angle has room below the line only; within a wide one lies the joint's other spring
  const isNarrow = alpha < 0.68;
  const radius = isNarrow ? 104 : 50;
  line(pen, home.x + 38, home.y, home.x + radius + 20, home.y);
  pen.setLineDash([]);
  pen.beginPath();
  pen.arc(home.x, home.y, radius, -Math.max(alpha, 0), 0);
  pen.stroke();
  pen.restore();
  pen.fillStyle = palette().muted;
  const at = alpha > Math.PI / 2 ? alpha - Math.PI / 4 : Math.min(0.38 * alpha, 0.42);
  const place =
    alpha < 1
      ? { x: home.x + (isNarrow ? radius - 4 : radius + 12), y: home.y + 11 }
      : { x: home.x + 64 * Math.cos(at) - 5, y: home.y - 64 * Math.sin(at) };
  sign(pen, ["α", ""], place, 15);
}

/** `moved` is where the plate is, `speed` its velocity [px]. */
function paintPlate(s: Surface, top: number, moved: number, middle: number, speed: number): void {
  const { pen, width, height } = s;
  const colours = palette();
  const thick = 24;
  const ground = height - 14;
  pen.strokeStyle = colours.ink;
  springDashpot(pen, { x: middle, y: top + thick }, { x: middle, y: ground });
  pen.fillStyle = colours.ink;
  const label = (top + thick + ground) / 2;
  sign(pen, ["k", "2y"], { x: middle + 20, y: label });
  sign(pen, ["c", "2y"], { x: middle - 36, y: label });
  pen.strokeStyle = colours.muted;
  line(pen, middle - 34, ground, middle + 34, ground);
  for (let x = middle - 30; x <= middle + 34; x += 7) line(pen, x, ground, x - 5, ground + 6);

  pen.fillStyle = colours.grid;
  pen.fillRect(0, top, width, thick);
  pen.strokeStyle = colours.line;
  pen.lineWidth = 1.2;
  paintStrokes(pen, [0, width], moved, { x: top + thick - 1, y: top + 1 });
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 1.6;
  line(pen, 0, top, width, top);
  pen.lineWidth = 1;
  line(pen, 0, top + thick, width, top + thick);
  pen.fillStyle = colours.ink;
  sign(pen, ["m", "2"], { x: 12, y: top + thick / 2 });

  const from = { x: width - 62, y: top + thick + 20 };
  arrow(pen, from, { x: from.x + speed, y: from.y }, colours.muted, colours.panel);
  pen.fillStyle = colours.muted;
  sign(pen, ["V", ""], { x: from.x - 4, y: from.y + 16 });
}

function paintJoint(s: Surface, contact: Point, body: Point): void {
  const { pen } = s;
  const colours = palette();
  pen.beginPath();
  pen.moveTo(contact.x, contact.y);
  pen.lineTo(contact.x - 13, contact.y - 15);
  pen.lineTo(contact.x - 30, contact.y - 18);
  pen.arcTo(contact.x - 34, contact.y - 52, body.x, contact.y - 56, 8);
  pen.arcTo(contact.x + 34, contact.y - 56, contact.x + 34, contact.y - 18, 8);
  pen.lineTo(contact.x + 30, contact.y - 18);
  pen.lineTo(contact.x + 13, contact.y - 15);
  pen.closePath();
  paintBody(pen);
  pen.fillStyle = colours.ink;
  sign(pen, ["m", "1"], { x: contact.x - 26, y: body.y });
}

function paintForces(s: Surface, contact: Point, plateTop: number, moment: Moment, scales: Scales): void {
  const { pen } = s;
  const colours = palette();
  const state = stateOf(moment);
  const [N, T] = [moment.at("normal_force") * scales.force, moment.at("friction_force") * scales.force];
  if (state !== "separation") {
    arrow(pen, contact, { x: contact.x, y: contact.y - Math.min(N, 52) }, colours.traces[0], colours.panel);
    arrow(
      pen,
      contact,
      { x: contact.x + Math.min(Math.max(T, -70), 70), y: contact.y },
      colours.traces[1],
      colours.panel,
    );
    pen.fillStyle = colours.traces[0];
    if (N > 28) sign(pen, ["N", ""], { x: contact.x + 7, y: contact.y - Math.min(N, 52) + 4 });
    pen.fillStyle = colours.traces[1];
    if (Math.abs(T) > 16)
      sign(pen, ["T", ""], { x: contact.x + Math.min(Math.max(T, -70), 70) + (T > 0 ? 5 : -16), y: contact.y + 12 });
  }
  paintContact(pen, { x: contact.x, y: state === "separation" ? (contact.y + plateTop) / 2 : contact.y }, state);
  paintStateName(pen, state);
}
