/** What rubs in slow motion, with contact states and forces: the paper's Figure 2, or a structure of one's own. */
import { sentence } from "../data/api.ts";
import { contactsOf, hasStructure, jointsOf, valueIn } from "../data/cases.ts";
import { valueAt, type Motion } from "../data/frames.ts";
import { momentOf, stateOf, type Moment } from "../data/moment.ts";
import { plateTravel, tellingTime } from "../data/motions.ts";
import type { Case, Simulation } from "../data/types.ts";
import { button, h, select, setOptions, setText } from "../draw/dom.ts";
import { inRow, plain, quantity } from "../draw/format.ts";
import type { Scales } from "../draw/contact_mark.ts";
import { columnOf } from "../draw/lane_specs.ts";
import { paintRubbingSystem } from "../draw/rubbing_system.ts";
import type { paintStructure } from "../draw/structure_drawing.ts";
import { surface, type Surface } from "../draw/surface.ts";
import { onLook } from "../draw/theme.ts";
import type { Direction } from "../program/words.ts";
import { Clock, slowness } from "../state/clock.ts";
import type { Shown } from "../state/shown.ts";
import { phaseOf } from "./verdict.ts";

const wantedRate = 0.8; // [1/s] cycles of the noise per second of watching

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
  private unit_ = 1; // [px/m] of what moves, as it was drawn
  private ownSpeed_ = true;
  private placed_: Direction | null = null;
  private paintStructure_: typeof paintStructure | null = null;

  /** `structure_` fetches what draws a structure of one's own, when there is one. */
  constructor(
    readonly clock: Clock,
    private readonly shown_: Shown,
    private readonly structure_: () => Promise<typeof paintStructure>,
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
      { id: "speed", title: "How much slower than in reality" },
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
    onLook(() => this.surface_.invalidate());
  }

  show(motion: Motion, simulation: Simulation, direction: Direction): void {
    const first = this.motion_ === null;
    this.motion_ = motion;
    this.resolved_ = simulation.case;
    this.travel_ = plateTravel(motion) as Float32Array<ArrayBuffer>;
    this.offer_(motion);
    if (hasStructure(simulation.case) && !this.paintStructure_) void this.load_();
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

  private async load_(): Promise<void> {
    try {
      this.paintStructure_ = await this.structure_();
      this.surface_.invalidate();
    } catch (error) {
      setText(this.readout_, sentence(error));
    }
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
    const { motion_: motion } = this;
    if (!motion) return;
    // of a structure all that moves is drawn, of joints the chosen one
    const isWhole = this.resolved_ !== null && hasStructure(this.resolved_);
    const contacts = isWhole ? motion.contacts.map((_, k) => k) : [this.shown_.contact];
    const largest = (names: readonly string[], share = 1): number => {
      const columns = new Set(names.flatMap((name) => contacts.map((k) => columnOf(motion, name, k))));
      return Math.max(...[...columns].map((column) => largestOf(motion, column, share)), 1e-12);
    };
    const outline = motion.outline.flatMap((_, k) => [`outline_${k + 1}_x`, `outline_${k + 1}_y`]);
    this.scales_ = {
      length: 34 / largest(["x1", "y1", "y2", ...outline]),
      force: 46 / largest(["normal_force", "friction_force"], 0.99),
      velocity: 44 / largest(["surface_velocity"]),
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

  private get moment_(): Moment {
    return momentOf(this.motion_ as Motion, this.clock.time, this.shown_.contact, this.travel_, columnOf);
  }

  private paint_(s: Surface): void {
    if (!this.motion_ || !this.resolved_) return;
    const moment = this.moment_;
    if (hasStructure(this.resolved_)) {
      this.unit_ = this.paintStructure_?.(s, moment, this.scales_, contactsOf(this.resolved_)) ?? this.unit_;
    } else {
      const joint = jointsOf(this.resolved_)[this.shown_.contact]; // of several the chosen one is drawn
      const angle = joint ? joint.incidence_angle : valueIn(this.resolved_, "joint.incidence_angle");
      this.unit_ = paintRubbingSystem(s, moment, this.scales_, (Number(angle) * Math.PI) / 180);
    }
    this.tell_(moment);
  }

  private tell_(moment: Moment): void {
    const state = stateOf(moment);
    const magnified = plain(this.unit_ * 2.6e-4, 2); // a CSS pixel is 0.26 mm
    const told = [
      `t = ${(this.clock.time * 1000).toFixed(2)} ms`,
      `V = ${quantity(moment.at("surface_velocity"), "m/s", 3)}`,
      `N = ${quantity(moment.at("normal_force"), "N", 3)}`,
      `T = ${quantity(moment.at("friction_force"), "N", 3)}`,
      `motion enlarged ${magnified} times`,
    ];
    setText(this.readout_, inRow(told));
    if (this.clock.playing) return;
    const label = `The rubbing system: ${state}, ${this.readout_.textContent}`;
    this.surface_.canvas.setAttribute("aria-label", label);
  }
}

/** The largest size of a column's values, or that below which a share of them lie; some of many are looked at. */
function largestOf(motion: Motion, column: string, share: number): number {
  const values = motion.columns.get(column)?.values ?? new Float32Array(1);
  const stride = Math.max(1, Math.floor(values.length / 20_000));
  const sizes: number[] = [];
  for (let k = 0; k < values.length; k += stride) sizes.push(Math.abs(values[k] as number));
  sizes.sort((a, b) => a - b);
  return sizes[Math.min(sizes.length - 1, Math.floor(share * sizes.length))] ?? 0;
}
