/** The time at which mechanism and time history are read: plays in slow motion, stops, is moved. */

export const slowness = [10_000, 5_000, 2_000, 1_000, 500, 200, 100, 50, 20, 10, 5, 2, 1] as const;

export class Clock {
  time = 0; // [s] of the simulation
  from = 0; // [s] what is played, again and again
  to = 1;
  slow = 1000; // seconds of watching per second of motion
  playing = false;
  private last_ = 0;
  private frame_ = 0;
  private readonly listeners_: (() => void)[] = [];

  listen(listener: () => void): void {
    this.listeners_.push(listener);
  }

  play(): void {
    if (this.playing) return;
    this.playing = true;
    this.last_ = performance.now();
    this.frame_ = requestAnimationFrame((now) => this.tick_(now));
    this.tell_();
  }

  pause(): void {
    this.playing = false;
    cancelAnimationFrame(this.frame_);
    this.tell_();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Goes to a time, within what is played. */
  seek(time: number): void {
    this.time = Math.min(Math.max(time, this.from), this.to);
    this.tell_();
  }

  limit(from: number, to: number): void {
    [this.from, this.to] = [from, to];
    this.seek(this.time);
  }

  private tick_(now: number): void {
    if (!this.playing) return;
    const passed = Math.min(now - this.last_, 100) / 1000;
    this.last_ = now;
    this.time += passed / this.slow;
    if (this.time > this.to) this.time = this.from;
    this.tell_();
    this.frame_ = requestAnimationFrame((next) => this.tick_(next));
  }

  private tell_(): void {
    for (const listener of this.listeners_) listener();
  }
}
