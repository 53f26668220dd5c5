/** The law of friction over the speed of slip. Its points can be moved: by hand, or by the arrow keys. */
import * as api from "../data/api.ts";
import type { FrictionLaw } from "../data/answer_types.ts";
import { marginOf, paintAxes } from "../draw/axes.ts";
import { h, setText } from "../draw/dom.ts";
import { inRow, quantity, rounded, unitText, writtenIn } from "../draw/format.ts";
import { lawAt, placeOf, pointsOf, type Frame, type Point } from "../draw/law_points.ts";
import { font, surface, type Surface } from "../draw/surface.ts";
import { onLook, palette } from "../draw/theme.ts";
import { withValues, type Design } from "../state/state.ts";
import type { Store } from "../state/store.ts";
import { Asked } from "./asked.ts";
import type { Context, ViewPart } from "./views.ts";

const keyStep = 0.01; // [1] of the picture

export class Friction implements ViewPart {
  readonly element: HTMLElement;
  private readonly canvas_ = h("canvas", { "role": "img", "aria-label": "Law of friction" });
  private readonly grips_ = h("div", { class: "grips" });
  private readonly readout_ = h("p", { class: "readout", id: "friction-readout" });
  private readonly surface_: Surface;
  private readonly asked_ = new Asked<{ design: Design; reach: number | null }, FrictionLaw>(
    ({ design, reach }, signal) => api.friction(design, reach, signal),
    (law, { reach }) => this.take_(law, reach === null),
  );
  private law_: FrictionLaw | null = null;
  private points_: Point[] = [];
  private frame_: Frame | null = null;
  private held_: number | null = null; // the point that a hand has

  constructor(private readonly store_: Store) {
    this.surface_ = surface(this.canvas_, () => this.paint_());
    onLook(() => this.surface_.invalidate());
    this.element = h(
      "div",
      { class: "friction" },
      h("div", { class: "bar" }, this.readout_, this.asked_.note),
      h("div", { class: "law" }, this.canvas_, this.grips_),
    );
  }

  show({ state, step, simulation }: Context): void {
    if (!simulation) return;
    const isStill = step !== "drag" && this.held_ === null;
    this.asked_.ask({ design: state.design, reach: isStill ? null : (this.law_?.visited?.to ?? 0) });
  }

  private take_(law: FrictionLaw, visited: boolean): void {
    // between two looks at the motion the last one stays
    this.law_ = visited ? law : { ...law, visited: this.law_?.visited ?? null };
    this.points_ = pointsOf(law);
    this.surface_.draw();
    setText(this.readout_, inRow(this.told_()));
  }

  private told_(): string[] {
    const { law_: law } = this;
    if (!law) return [];
    const slips = law.visited
      ? `slips at ${quantity(law.visited.from, "m/s", 3)} to ${quantity(law.visited.to, "m/s", 3)}`
      : null;
    const limits = law.curves.map(({ way, limit }) => {
      const holds = limit === null ? "creeps, and never sticks" : `sticks up to ${rounded(limit)}`;
      return law.curves.length > 1 ? `${way} ${holds}` : holds;
    });
    return [law.friction, ...limits, ...(slips ? [slips] : [])];
  }

  private paint_(): void {
    const { law_: law, surface_: canvas } = this;
    if (!law) return;
    const { pen } = canvas;
    const look = palette();
    const top = Math.max(...law.curves.flatMap(({ limit, friction }) => [limit ?? 0, ...friction]));
    const height = canvas.height - 46;
    // a picture that changed under the hand would take the point away from it
    const still = this.held_ === null ? null : this.frame_;
    const speed = still?.speed ?? (law.speeds.at(-1) || 1);
    const friction = still?.friction ?? (top > 0 ? 1.15 * top : 1);
    const written = writtenIn("m/s", speed);
    const x = {
      title: `speed of slip [${unitText(written.unit)}]`,
      from: 0,
      to: speed,
      factor: written.factor,
    };
    const y = { title: "friction / normal force", from: 0, to: friction };
    const left = Math.max(54, marginOf(pen, y, height));
    const frame: Frame = { box: { left, top: 8, width: canvas.width - left - 12, height }, speed, friction };
    if (frame.box.width < 20 || frame.box.height < 20) return;
    this.frame_ = frame;
    paintAxes(pen, look, frame.box, x, y);
    pen.save();
    pen.beginPath();
    pen.rect(frame.box.left - 6, frame.box.top, frame.box.width + 12, frame.box.height);
    pen.clip();
    this.paintVisited_(frame);
    for (const [k, curve] of law.curves.entries()) {
      pen.strokeStyle = look.traces[k] ?? look.ink;
      pen.lineWidth = 2;
      pen.beginPath();
      for (const [point, at] of law.speeds.entries())
        pen.lineTo(...placeOf(frame, { speed: at, friction: curve.friction[point] ?? 0 }));
      pen.stroke();
      if (curve.limit === null) continue;
      pen.strokeStyle = look.state.stick;
      pen.lineWidth = 3;
      pen.beginPath();
      pen.moveTo(...placeOf(frame, { speed: 0, friction: 0 }));
      pen.lineTo(...placeOf(frame, { speed: 0, friction: curve.limit }));
      pen.stroke();
    }
    pen.restore();
    this.placeGrips_(frame);
  }

  private paintVisited_(frame: Frame): void {
    const { visited } = this.law_ ?? {};
    if (!visited) return;
    const { pen } = this.surface_;
    const [from] = placeOf(frame, { speed: visited.from, friction: 0 });
    const [to] = placeOf(frame, { speed: visited.to, friction: 0 });
    pen.fillStyle = palette().grid;
    pen.fillRect(from, frame.box.top, Math.max(to - from, 1), frame.box.height);
    pen.fillStyle = palette().muted;
    pen.font = font(11);
    pen.textAlign = "left";
    pen.textBaseline = "bottom";
    pen.fillText("slips at these speeds", from + 6, frame.box.top + frame.box.height - 6);
  }

  /** A button lies over each point. They stay while a hand or the focus has one. */
  private placeGrips_(frame: Frame): void {
    while (this.grips_.childElementCount > this.points_.length) this.grips_.lastElementChild?.remove();
    while (this.grips_.childElementCount < this.points_.length)
      this.grips_.append(this.grip_(this.grips_.childElementCount));
    for (const [k, point] of this.points_.entries()) {
      const button = this.grips_.children[k] as HTMLElement;
      const [left, top] = placeOf(frame, point);
      button.style.left = `${left}px`;
      button.style.top = `${top}px`;
      button.hidden = left > frame.box.left + frame.box.width + 6;
      button.title = point.name;
      button.setAttribute(
        "aria-label",
        `${point.name}: ${rounded(point.friction)} at ${quantity(point.speed, "m/s", 3)}`,
      );
    }
  }

  private grip_(index: number): HTMLElement {
    const button = h("button", { type: "button", class: "grip" });
    button.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      const [point, frame] = [this.points_[index], this.frame_];
      if (!by || !point || !frame) return;
      event.preventDefault();
      const [across = 0, up = 0] = by;
      this.set_(point, point.speed + across * keyStep * frame.speed, point.friction + up * keyStep * frame.friction);
    });
    button.addEventListener("pointerdown", (event) => this.hold_(button, index, event));
    return button;
  }

  private hold_(button: HTMLElement, index: number, taken: PointerEvent): void {
    const point = this.points_[index];
    if (taken.button !== 0 || !point || !this.frame_) return;
    button.setPointerCapture(taken.pointerId);
    this.held_ = index;
    const stop = new AbortController();
    const { signal } = stop;
    const [left, top] = placeOf(this.frame_, point);
    const place = (event: PointerEvent): [number, number] =>
      lawAt(this.frame_ as Frame, left + event.clientX - taken.clientX, top + event.clientY - taken.clientY);
    let last: [number, number] | null = null;
    button.addEventListener(
      "pointermove",
      (event) => {
        last = place(event);
        this.set_(point, ...last, "drag");
      },
      { signal },
    );
    const end = (): void => {
      stop.abort();
      this.held_ = null;
      if (last) this.set_(point, ...last);
    };
    button.addEventListener("pointerup", end, { signal });
    button.addEventListener("pointercancel", end, { signal });
    // a finger that moves a point does not scroll
    button.addEventListener("touchmove", (event) => event.preventDefault(), { signal, passive: false });
  }

  private set_(point: Point, speed: number, friction: number, step: "push" | "drag" = "push"): void {
    this.store_.update({ design: withValues(this.store_.state.design, point.at(speed, friction)) }, step);
  }
}
