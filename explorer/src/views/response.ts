/** The response in time: histories that zoom and pan over a million samples, contact states, phase portrait. */
import { shownContact, stateAt, valueAt, type Motion } from "../data/frames.ts";
import type { Motions } from "../data/motions.ts";
import { button, h, setText } from "../draw/dom.ts";
import { inRow, quantity } from "../draw/format.ts";
import { contactAt, marginLeft, marginRight } from "../draw/bands.ts";
import { contactColumn, isLaned, isOnPlate, jointColumn, laneSpecs, lanesOf } from "../draw/lane_specs.ts";
import { leastHeight, mostLanes, paintLanes, Pyramids, timeAt } from "../draw/lanes.ts";
import { paintPortrait, type Portrait } from "../draw/portrait.ts";
import { moved, stretched } from "../draw/scale.ts";
import { surface, type Surface } from "../draw/surface.ts";
import { onLook, palette } from "../draw/theme.ts";
import type { Clock } from "../state/clock.ts";
import type { Shown } from "../state/shown.ts";
import type { Store } from "../state/store.ts";
import type { Context, ViewPart } from "./views.ts";

export class Response implements ViewPart {
  readonly element: HTMLElement;
  private readonly stage_: HTMLElement; // of the lanes
  private readonly lanes_: Surface;
  private readonly portrait_: Surface;
  private readonly readout_ = h("p", { class: "readout", id: "response-readout" });
  private readonly wanted_ = new Set(["velocity", "force"]);
  private trees_: Pyramids | null = null;
  private span_: readonly [number, number] | null = null;
  private hover_: number | null = null;
  private grip_: { x: number; span: readonly [number, number]; moved: boolean } | null = null;
  private saver_ = 0;
  private portraitTimer_ = 0;
  private looked_ = false;
  private painted_: Portrait | undefined;

  constructor(
    private readonly store_: Store,
    private readonly motions_: Motions,
    private readonly clock_: Clock,
    private readonly chosen_: Shown,
    begin: (event: MouseEvent, portrait: Portrait, motion: Motion, contact: number) => void,
  ) {
    const canvas = h("canvas", {
      "id": "response",
      "tabindex": 0,
      "role": "application",
      "aria-roledescription": "time history",
      "aria-label": "Time history",
    });
    const phase = h("canvas", { "id": "portrait", "role": "img", "aria-label": "Phase portrait of the joint" });
    this.lanes_ = surface(canvas, (s) => this.paint_(s));
    this.portrait_ = surface(phase, (s) => this.paintPortrait_(s));
    this.listen_(canvas);
    phase.onclick = (event) =>
      this.trees_ && this.painted_ && begin(event, this.painted_, this.trees_.motion, chosen_.contact);
    const boxes = laneSpecs.map(({ name, title }) => {
      const box = h("input", {
        "type": "checkbox",
        "data-lane": name,
        "onchange": () => this.toggle_(name, box.checked),
      });
      box.checked = this.wanted_.has(name);
      return h("label", { class: "check" }, box, title);
    });
    this.stage_ = h("div", { class: "stage history" }, canvas);
    this.element = h(
      "div",
      { class: "response" },
      h(
        "div",
        { class: "bar" },
        ...boxes,
        button("Whole", () => this.go_(null), { class: "quiet", id: "whole", title: "Show all of the motion (Home)" }),
        this.readout_,
      ),
      this.stage_,
      h("div", { class: "stage phase" }, phase),
    );
    clock_.listen(() => this.looked_ && this.follow_());
    motions_.listen(() => this.take_());
    chosen_.listen(() => {
      this.describe_();
      this.repaint_();
    });
    onLook(() => this.repaint_());
  }

  show({ state }: Context): void {
    this.looked_ = true;
    this.motions_.refine(true);
    this.span_ = state.span;
    this.repaint_();
  }

  hide(): void {
    this.looked_ = false;
    this.motions_.refine(false);
  }

  private take_(): void {
    const { motion } = this.motions_;
    this.trees_ = motion ? new Pyramids(motion) : null;
    this.element.dataset.samples = String(motion?.samples ?? 0);
    this.repaint_();
  }

  private repaint_(): void {
    this.lanes_.invalidate();
    this.repaintPortrait_();
  }

  /** The portrait has thousands of strokes: while a hand is moving it is painted now and then. */
  private repaintPortrait_(): void {
    if (this.portraitTimer_) return;
    this.portraitTimer_ = window.setTimeout(() => {
      this.portraitTimer_ = 0;
      this.portrait_.invalidate();
    }, 160);
  }

  private toggle_(name: string, on: boolean): void {
    if (on) this.wanted_.add(name);
    else this.wanted_.delete(name);
    this.lanes_.invalidate();
  }

  private limits_(): [number, number] {
    const motion = this.trees_?.motion;
    if (!motion) return [0, 1];
    return [motion.start, motion.start + (motion.samples - 1) * motion.interval];
  }

  private get shown_(): readonly [number, number] {
    const limits = this.limits_();
    if (!this.span_) return limits;
    const [from, to] = [Math.max(this.span_[0], limits[0]), Math.min(this.span_[1], limits[1])];
    return from < to ? [from, to] : limits;
  }

  /** Shows a span; the URL follows when the hand rests. */
  private go_(span: readonly [number, number] | null): void {
    const limits = this.limits_();
    this.span_ = span && span[1] - span[0] < 0.999 * (limits[1] - limits[0]) ? span : null;
    this.repaint_();
    this.describe_();
    clearTimeout(this.saver_);
    const digits = (value: number): number => Number(value.toPrecision(8));
    this.saver_ = window.setTimeout(() => {
      const rounded = this.span_ ? ([digits(this.span_[0]), digits(this.span_[1])] as const) : null;
      this.store_.update({ span: rounded }, "replace");
    }, 700);
  }

  private follow_(): void {
    const [from, to] = this.shown_;
    if (this.clock_.playing && this.span_ && (this.clock_.time > to || this.clock_.time < from)) {
      const by = this.clock_.time - from;
      this.span_ = moved(this.shown_, by, this.limits_());
    }
    this.lanes_.invalidate();
    this.repaintPortrait_();
  }

  private listen_(canvas: HTMLCanvasElement): void {
    canvas.addEventListener("wheel", (event) => this.wheel_(event), { passive: false });
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.grip_ = { x: event.offsetX, span: this.shown_, moved: false };
    });
    canvas.addEventListener("pointermove", (event) => this.move_(event));
    canvas.addEventListener("pointerup", (event) => {
      if (this.grip_ && !this.grip_.moved) this.choose_(event);
      this.grip_ = null;
    });
    canvas.addEventListener("pointercancel", () => (this.grip_ = null));
    canvas.addEventListener("pointerleave", () => {
      this.hover_ = null;
      this.lanes_.invalidate();
    });
    canvas.addEventListener("dblclick", () => this.go_(null));
    canvas.addEventListener("keydown", (event) => this.key_(event));
  }

  /** A click goes to its time; on the states of one of several contacts it chooses that one, too. */
  private choose_(event: PointerEvent): void {
    const motion = this.trees_?.motion;
    const contact = motion ? contactAt(motion, this.lanes_.height, event.offsetY) : null;
    if (contact !== null) this.chosen_.choose(contact);
    this.clock_.seek(timeAt(this.lanes_, this.shown_, Math.max(event.offsetX, marginLeft)));
  }

  private wheel_(event: WheelEvent): void {
    event.preventDefault();
    const width = this.shown_[1] - this.shown_[0];
    const across = event.shiftKey ? event.deltaY : event.deltaX;
    if (Math.abs(across) > Math.abs(event.shiftKey ? 0 : event.deltaY)) {
      this.go_(moved(this.shown_, (across / this.lanes_.width) * width, this.limits_()));
      return;
    }
    const about = timeAt(this.lanes_, this.shown_, Math.max(event.offsetX, marginLeft));
    this.go_(
      stretched(this.shown_, about, Math.exp(Math.min(Math.max(event.deltaY, -240), 240) / 400), this.limits_()),
    );
  }

  private move_(event: PointerEvent): void {
    if (this.grip_) {
      const dx = event.offsetX - this.grip_.x;
      if (Math.abs(dx) > 3) this.grip_.moved = true;
      if (!this.grip_.moved) return;
      const inner = this.lanes_.width - marginLeft - marginRight;
      const width = this.grip_.span[1] - this.grip_.span[0];
      this.go_(moved(this.grip_.span, (-dx / inner) * width, this.limits_()));
      return;
    }
    this.hover_ = timeAt(this.lanes_, this.shown_, event.offsetX);
    this.describe_();
    this.lanes_.invalidate();
  }

  private key_(event: KeyboardEvent): void {
    const [from, to] = this.shown_;
    const width = to - from;
    const about = this.clock_.time > from && this.clock_.time < to ? this.clock_.time : (from + to) / 2;
    if (event.key === "ArrowLeft") this.go_(moved(this.shown_, -0.1 * width, this.limits_()));
    else if (event.key === "ArrowRight") this.go_(moved(this.shown_, 0.1 * width, this.limits_()));
    else if (event.key === "+" || event.key === "=" || event.key === "ArrowUp")
      this.go_(stretched(this.shown_, about, 0.7, this.limits_()));
    else if (event.key === "-" || event.key === "ArrowDown")
      this.go_(stretched(this.shown_, about, 1 / 0.7, this.limits_()));
    else if (event.key === "Home" || event.key === "0") this.go_(null);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private describe_(): void {
    const motion = this.trees_?.motion;
    if (!motion) return;
    const [from, to] = this.shown_;
    const time = this.hover_ ?? this.clock_.time;
    const text = readAt(motion, time, this.chosen_.contact);
    setText(this.readout_, text);
    this.lanes_.canvas.setAttribute(
      "aria-label",
      `Time history from ${quantity(from, "s")} to ${quantity(to, "s")}; ${text}`,
    );
  }

  private paint_(s: Surface): void {
    if (!this.trees_) return;
    const { motion } = this.trees_;
    const lanes = lanesOf(motion, this.wanted_, this.chosen_.contact, mostLanes(motion, s.height));
    this.stage_.style.minHeight = `${leastHeight(motion, lanes.length)}px`;
    paintLanes(s, this.trees_, {
      span: this.shown_,
      lanes,
      chosen: this.chosen_.contact,
      playhead: this.clock_.time,
      hover: this.hover_,
      palette: palette(),
    });
    if (this.hover_ === null && this.clock_.playing)
      setText(this.readout_, readAt(motion, this.clock_.time, this.chosen_.contact));
    this.element.dataset.draws = String(Number(this.element.dataset.draws ?? 0) + 1);
  }

  private paintPortrait_(s: Surface): void {
    if (!this.trees_) return;
    const { motion } = this.trees_;
    this.painted_ = paintPortrait(s, motion, this.shown_, this.clock_.time, palette(), this.chosen_.contact);
    const { name } = shownContact(motion, this.chosen_.contact);
    const who = motion.contacts.length < 2 && isOnPlate(motion) ? "the joint" : name;
    s.canvas.setAttribute("aria-label", `Phase portrait of ${who}`);
  }
}

/** What stands at a time: of few contacts all, of many the chosen one. */
function readAt(motion: Motion, time: number, chosen: number): string {
  const value = (name: string, unit: string): string => quantity(valueAt(motion, name, time), unit, 3);
  const several = motion.contacts.length > 1;
  const velocity = several || !isOnPlate(motion) ? "ẋ" : "ẋ₁";
  return inRow([
    `t = ${(1000 * time).toFixed(3)} ms`,
    ...(several ? [`V = ${value("surface_velocity", "m/s")}`] : []),
    ...motion.contacts.flatMap((contact, k) =>
      !isLaned(motion, k, chosen)
        ? []
        : [
            several ? `${contact.name}: ${stateAt(contact, time)}` : stateAt(contact, time),
            `${velocity} = ${value(`${jointColumn(motion, "x", k)}_velocity`, "m/s")}`,
            ...(several ? [] : [`V = ${value("surface_velocity", "m/s")}`]),
            `N = ${value(contactColumn(motion, "normal_force", k), "N")}`,
            `T = ${value(contactColumn(motion, "friction_force", k), "N")}`,
          ],
    ),
  ]);
}
