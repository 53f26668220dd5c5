/** The rubbing system of the paper's Figure 2, moving in slow motion with its contact state and forces. */
import { jointsOf, valueIn } from "../data/cases.ts";
import { shownContact, stateAt, valueAt, type Motion } from "../data/frames.ts";
import { plateTravel, tellingTime } from "../data/motions.ts";
import type { Case, Simulation } from "../data/types.ts";
import { button, h, select, setOptions, setText } from "../draw/dom.ts";
import { inRow, plain, quantity } from "../draw/format.ts";
import { columnOf } from "../draw/lane_specs.ts";
import { arrow, line, sign, springDashpot, wall, type Point } from "../draw/sketch.ts";
import { font, surface, type Surface } from "../draw/surface.ts";
import { onTheme, palette } from "../draw/theme.ts";
import type { Direction } from "../program/words.ts";
import { Clock, slowness } from "../state/clock.ts";
import type { Shown } from "../state/shown.ts";
import { phaseOf } from "./verdict.ts";

const wantedRate = 0.8; // [1/s] cycles of the noise per second of watching

interface Scales {
  length: number; // [px/m]
  force: number; // [px/N]
  velocity: number; // [px s/m]
}

export class Mechanism {
  readonly element: HTMLElement;
  private readonly surface_: Surface;
  private readonly play_: HTMLButtonElement;
  private readonly scrub_: HTMLInputElement;
  private readonly speed_: HTMLSelectElement;
  private readonly contact_: HTMLSelectElement;
  private readonly readout_ = h("p", { class: "readout", id: "mechanism-readout" });
  private motion_: Motion | null = null;
  private travel_ = new Float32Array();
  private resolved_: Case | null = null;
  private scales_: Scales = { length: 1, force: 1, velocity: 1 };
  private ownSpeed_ = true;
  private placed_: Direction | null = null;

  constructor(
    readonly clock: Clock,
    private readonly shown_: Shown,
  ) {
    const canvas = h("canvas", { "role": "img", "tabindex": 0, "id": "mechanism", "aria-label": "The rubbing system" });
    this.surface_ = surface(canvas, (s) => this.paint_(s));
    this.play_ = button("❚❚", () => clock.toggle(), { id: "play", class: "icon", title: "Play or pause (space)" });
    this.scrub_ = h("input", {
      "type": "range",
      "min": 0,
      "max": 10_000,
      "step": 1,
      "id": "scrub",
      "aria-label": "Time",
    });
    this.scrub_.addEventListener("input", () => {
      clock.seek(clock.from + ((clock.to - clock.from) * this.scrub_.valueAsNumber) / 10_000);
    });
    const options = slowness.map((slow) => [String(slow), slow === 1 ? "real time" : `1/${slow} speed`] as const);
    this.speed_ = select(
      "Speed",
      options,
      (value) => {
        clock.slow = Number(value);
        this.ownSpeed_ = false;
      },
      { id: "speed", title: "How much slower than in truth" },
    );
    this.contact_ = select("Contact", [], (value) => shown_.choose(Number(value)), {
      id: "contact",
      title: "Which of several contacts is drawn, here and in the phase portrait",
    });
    this.contact_.hidden = true;
    shown_.listen(() => this.choose_());
    canvas.addEventListener("keydown", (event) => this.key_(event));
    canvas.addEventListener("click", () => clock.toggle());
    this.element = h(
      "section",
      { "class": "panel mechanism", "aria-label": "Mechanism" },
      h(
        "div",
        { class: "heading" },
        h("h2", {}, "Rubbing system"),
        h("span", { class: "spacer" }),
        this.contact_,
        this.speed_,
      ),
      h("div", { class: "stage" }, canvas),
      h("div", { class: "transport" }, this.play_, this.scrub_),
      this.readout_,
    );
    clock.listen(() => this.follow_());
    onTheme(() => this.surface_.invalidate());
  }

  show(motion: Motion, simulation: Simulation, direction: Direction): void {
    const first = this.motion_ === null;
    this.motion_ = motion;
    this.resolved_ = simulation.case;
    this.travel_ = plateTravel(motion) as Float32Array<ArrayBuffer>;
    this.offer_(motion);
    this.rescale_();
    const { clock } = this;
    clock.limit(motion.start, motion.start + (motion.samples - 1) * motion.interval);
    if (this.ownSpeed_) {
      const frequency = phaseOf(simulation, direction)?.verdict.frequency ?? 400;
      const wanted = frequency / wantedRate;
      clock.slow = slowness.reduce((best, slow) =>
        Math.abs(Math.log(slow / wanted)) < Math.abs(Math.log(best / wanted)) ? slow : best,
      );
      this.speed_.value = String(clock.slow);
    }
    const velocity = valueAt(motion, "surface_velocity", clock.time);
    const isElsewhere = direction === "going" ? velocity <= 0 : velocity >= 0;
    if (this.placed_ !== direction || isElsewhere) this.goTo(direction);
    if (first && !matchMedia("(prefers-reduced-motion: reduce)").matches) clock.play();
    this.follow_();
  }

  /** Offers the contacts of a motion that has several. */
  private offer_(motion: Motion): void {
    this.contact_.hidden = motion.contacts.length < 2;
    setOptions(
      this.contact_,
      motion.contacts.map(({ name }, k) => [String(k), name] as const),
    );
    if (this.shown_.contact >= motion.contacts.length) this.shown_.choose(0);
    this.contact_.value = String(this.shown_.contact);
  }

  private choose_(): void {
    this.contact_.value = String(this.shown_.contact);
    this.rescale_();
    this.follow_();
  }

  /** Goes to where a direction shows what it does. */
  goTo(direction: Direction): void {
    if (!this.motion_) return;
    this.placed_ = direction;
    this.clock.seek(tellingTime(this.motion_, direction));
  }

  private key_(event: KeyboardEvent): void {
    const step = (0.016 / this.clock.slow) * (event.shiftKey ? 20 : 2);
    if (event.key === " ") this.clock.toggle();
    else if (event.key === "ArrowRight") this.clock.seek(this.clock.time + step);
    else if (event.key === "ArrowLeft") this.clock.seek(this.clock.time - step);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private rescale_(): void {
    if (!this.motion_) return;
    const largest = (name: string, share = 1): number => {
      const values = this.motion_?.columns.get(this.column_(name))?.values ?? new Float32Array(1);
      const stride = Math.max(1, Math.floor(values.length / 20_000));
      const sizes: number[] = [];
      for (let k = 0; k < values.length; k += stride) sizes.push(Math.abs(values[k] as number));
      sizes.sort((a, b) => a - b);
      return sizes[Math.min(sizes.length - 1, Math.floor(share * sizes.length))] || 1e-12;
    };
    const reach = Math.max(largest("x1"), largest("y1"), largest("y2"));
    this.scales_ = {
      length: 34 / reach,
      force: 46 / Math.max(largest("normal_force", 0.99), largest("friction_force", 0.99)),
      velocity: 44 / largest("surface_velocity"),
    };
  }

  private follow_(): void {
    const { clock } = this;
    const part = (clock.time - clock.from) / (clock.to - clock.from || 1);
    this.scrub_.value = String(Math.round(part * 10_000));
    this.scrub_.style.setProperty("--part", `${100 * part}%`);
    this.scrub_.setAttribute("aria-valuetext", quantity(clock.time, "s"));
    setText(this.play_, clock.playing ? "❚❚" : "▶");
    this.play_.setAttribute("aria-label", clock.playing ? "Pause" : "Play");
    this.surface_.invalidate();
  }

  private at_(name: string): number {
    return this.motion_ ? valueAt(this.motion_, this.column_(name), this.clock.time) : 0;
  }

  /** A column as in a motion of one contact; of several that of the chosen one. */
  private column_(name: string): string {
    return this.motion_ ? columnOf(this.motion_, name, this.shown_.contact) : name;
  }

  private paint_(s: Surface): void {
    if (!this.motion_ || !this.resolved_) return;
    const { pen, width, height } = s;
    const colours = palette();
    const joint = jointsOf(this.resolved_)[this.shown_.contact]; // of several the chosen one is drawn
    const angle = joint ? joint.incidence_angle : valueIn(this.resolved_, "joint.incidence_angle");
    const alpha = (Number(angle) * Math.PI) / 180;
    const unit = this.scales_.length * Math.min(1, height / 300);
    const rest = { x: width * 0.5, y: height * 0.64 };
    const contact = { x: rest.x + unit * this.at_("x1"), y: rest.y - unit * this.at_("y1") };
    const plateTop = rest.y - unit * this.at_("y2");
    const body = { x: contact.x, y: contact.y - 34 };

    pen.lineWidth = 1.3;
    pen.lineCap = "round";
    pen.strokeStyle = colours.muted;
    this.paintSupports_(s, rest, body, alpha);
    this.paintPlate_(s, plateTop, unit, rest.x);
    this.paintJoint_(s, contact, body);
    this.paintForces_(s, contact, plateTop);
    this.tell_();
  }

  /**
   * The joint's springs and dashpots to their walls, along i and j, and the angle between x and i. The signs stand
   * beside them where neither the arc nor the line of the angle passes: above a spring that lies low on the right.
   */
  private paintSupports_(s: Surface, rest: Point, body: Point, alpha: number): void {
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
    this.paintAngle_(s, home, alpha);
  }

  private paintAngle_(s: Surface, home: Point, alpha: number): void {
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

  private paintPlate_(s: Surface, top: number, unit: number, middle: number): void {
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
    const spacing = 26;
    const { start, interval } = this.motion_ as Motion;
    const place = Math.min(Math.max((this.clock.time - start) / interval, 0), this.travel_.length - 1);
    const index = Math.floor(place);
    const here = this.travel_[index] ?? 0;
    const moved = here + ((this.travel_[index + 1] ?? here) - here) * (place - index);
    const offset = (((middle + unit * moved) % spacing) + spacing) % spacing;
    for (let x = offset - spacing; x < width + spacing; x += spacing) line(pen, x, top + thick - 1, x + 10, top + 1);
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 1.6;
    line(pen, 0, top, width, top);
    pen.lineWidth = 1;
    line(pen, 0, top + thick, width, top + thick);
    pen.fillStyle = colours.ink;
    sign(pen, ["m", "2"], { x: 12, y: top + thick / 2 });

    const speed = this.at_("surface_velocity") * this.scales_.velocity;
    const from = { x: width - 62, y: top + thick + 20 };
    arrow(pen, from, { x: from.x + speed, y: from.y }, colours.muted, colours.panel);
    pen.fillStyle = colours.muted;
    sign(pen, ["V", ""], { x: from.x - 4, y: from.y + 16 });
  }

  private paintJoint_(s: Surface, contact: Point, body: Point): void {
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
    pen.fillStyle = colours.field;
    pen.fill();
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 1.6;
    pen.stroke();
    pen.fillStyle = colours.ink;
    sign(pen, ["m", "1"], { x: contact.x - 26, y: body.y });
  }

  private paintForces_(s: Surface, contact: Point, plateTop: number): void {
    const { pen } = s;
    const colours = palette();
    const state = stateAt(shownContact(this.motion_ as Motion, this.shown_.contact), this.clock.time);
    const [N, T] = [this.at_("normal_force") * this.scales_.force, this.at_("friction_force") * this.scales_.force];
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
    this.paintContact_(
      pen,
      { x: contact.x, y: state === "separation" ? (contact.y + plateTop) / 2 : contact.y },
      state,
    );
  }

  /** The contact point, its state in colour and in form: stick a square, slip a disc, separation a ring. */
  private paintContact_(pen: CanvasRenderingContext2D, at: Point, state: "slip" | "stick" | "separation"): void {
    const colours = palette();
    pen.beginPath();
    if (state === "stick") pen.rect(at.x - 6, at.y - 6, 12, 12);
    else pen.arc(at.x, at.y, 6.5, 0, 2 * Math.PI);
    pen.fillStyle = state === "separation" ? colours.panel : colours.state[state];
    pen.fill();
    pen.strokeStyle = state === "separation" ? colours.state.separation : colours.ink;
    pen.lineWidth = state === "separation" ? 3 : 1.4;
    pen.stroke();
    pen.font = font(12, 650);
    pen.textAlign = "left";
    pen.textBaseline = "middle";
    const width = pen.measureText(state).width + 12;
    pen.fillStyle = colours.state[state];
    pen.beginPath();
    pen.roundRect(8, 8, width, 20, 10);
    pen.fill();
    pen.fillStyle = state === "slip" || (state === "stick" && colours.name === "dark") ? "#1B1F24" : "#FFFFFF";
    pen.fillText(state, 14, 18.5);
  }

  private tell_(): void {
    const state = stateAt(shownContact(this.motion_ as Motion, this.shown_.contact), this.clock.time);
    const magnified = plain(this.scales_.length * 2.6e-4, 2); // a CSS pixel is 0.26 mm
    const told = [
      `t = ${(this.clock.time * 1000).toFixed(2)} ms`,
      `V = ${this.at_("surface_velocity").toFixed(3)} m/s`,
      `N = ${quantity(this.at_("normal_force"), "N", 3)}`,
      `T = ${quantity(this.at_("friction_force"), "N", 3)}`,
      `drawn × ${magnified}`,
    ];
    setText(this.readout_, inRow(told));
    if (this.clock.playing) return;
    const label = `The rubbing system: ${state}, ${this.readout_.textContent}`;
    this.surface_.canvas.setAttribute("aria-label", label);
  }
}
