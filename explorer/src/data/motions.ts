/** The present design's motion: coarse at once, as fine as the server gives it when there is time. */
import type { Direction } from "../program/words.ts";
import type { Design } from "../state/state.ts";
import * as api from "./api.ts";
import { valueIn } from "./cases.ts";
import { lastAtMost, type Motion, type Stays } from "./frames.ts";
import { Latest } from "./latest.ts";
import type { Simulation } from "./types.ts";

const coarseSamples = 100_000;

interface Wish {
  design: Design;
  to: number;
  fine: boolean;
}

export class Motions {
  motion: Motion | null = null;
  isFine = false;
  problem: unknown = null; // why there is no newer motion
  private readonly requests_ = new Latest<Wish>((wish, signal) => this.fetch_(wish, signal));
  private readonly listeners_: (() => void)[] = [];
  private current_: Wish | null = null;
  private wantsFine_ = false;
  private timer_ = 0;

  listen(listener: () => void): void {
    this.listeners_.push(listener);
  }

  /** A new design has been run. */
  renew(design: Design, simulation: Simulation): void {
    const duration = Number(valueIn(simulation.case, "run.duration") ?? 1);
    const to = Math.min(duration, simulation.outcome.time || Infinity);
    this.current_ = { design, to, fine: false };
    clearTimeout(this.timer_);
    this.requests_.askNow(this.current_);
  }

  /** Whether anyone looks closely enough for the fine motion. */
  refine(wanted: boolean): void {
    this.wantsFine_ = wanted;
    if (wanted && this.current_ && this.motion && !this.isFine) this.later_();
  }

  private later_(): void {
    clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => {
      if (this.current_ && this.wantsFine_ && !this.isFine) this.requests_.ask({ ...this.current_, fine: true });
    }, 350);
  }

  private async fetch_(wish: Wish, signal: AbortSignal): Promise<void> {
    try {
      const interval = wish.fine ? null : Math.max(wish.to / coarseSamples, 1e-7);
      this.motion = await api.motion(wish.design, { from: 0, to: wish.to, interval }, signal);
      this.isFine = wish.fine;
      this.problem = null;
      if (!wish.fine && this.wantsFine_) this.later_();
    } catch (error) {
      if (api.isAbort(error)) return;
      this.problem = error;
    }
    for (const listener of this.listeners_) listener();
  }
}

/** Where a motion is well under way in a direction: the plate near its top speed, once the start has died away. */
export function tellingTime(motion: Motion, direction: Direction): number {
  const velocity = motion.columns.get("surface_velocity")?.values;
  const end = motion.start + motion.samples * motion.interval;
  if (!velocity || velocity.length === 0) return motion.start;
  const sign = direction === "going" ? 1 : -1;
  let top = 0;
  for (const value of velocity) top = Math.max(top, sign * value);
  if (top <= 0) return motion.start + 0.6 * (end - motion.start);
  const first = Math.floor(0.4 * velocity.length);
  for (let k = first; k < velocity.length; ++k)
    if (sign * (velocity[k] as number) >= 0.985 * top) return motion.start + k * motion.interval;
  return motion.start;
}

/** Displacement of the plate along x: its velocity added up, in the mean at zero. */
export function plateTravel(motion: Motion): Float32Array {
  const velocity = motion.columns.get("surface_velocity")?.values ?? new Float32Array(motion.samples);
  const travel = new Float32Array(velocity.length);
  let sum = 0;
  for (let k = 1; k < velocity.length; ++k) {
    sum += (((velocity[k] as number) + (velocity[k - 1] as number)) / 2) * motion.interval;
    travel[k] = sum;
  }
  return travel;
}

/** The stays that a span of time touches: first and last index. */
export function staysWithin(stays: Stays, from: number, to: number): [number, number] {
  const last = stays.state.length - 1;
  const first = Math.min(Math.max(lastAtMost(stays.from, from), 0), last);
  return [first, Math.min(Math.max(lastAtMost(stays.from, to), first), last)];
}
