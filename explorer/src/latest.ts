/**
 * Work of which only the newest wish counts. At most one is in flight. A newer wish aborts it, but not before it has
 * had its time: without that, a slider moving faster than the answers come would never show one.
 */
export class Latest<Wish> {
  private running: { controller: AbortController; since: number } | null = null;
  private waiting: { wish: Wish } | null = null;
  private timer = 0;

  /** @param patience how long a running wish may go on when a newer one waits [ms] */
  constructor(
    private readonly work: (wish: Wish, signal: AbortSignal) => Promise<void>,
    private readonly patience = 0,
  ) {}

  ask(wish: Wish): void {
    this.waiting = { wish };
    if (!this.running) {
      void this.next();
      return;
    }
    const left = this.patience - (performance.now() - this.running.since);
    clearTimeout(this.timer);
    if (left <= 0) this.running.controller.abort();
    else this.timer = window.setTimeout(() => this.waiting && this.running?.controller.abort(), left);
  }

  /** Aborts what runs and forgets what waits. */
  cancel(): void {
    this.waiting = null;
    this.running?.controller.abort();
  }

  /** Starts the wish at once, whatever runs. */
  askNow(wish: Wish): void {
    this.waiting = { wish };
    if (this.running) this.running.controller.abort();
    else void this.next();
  }

  private async next(): Promise<void> {
    while (this.waiting) {
      const { wish } = this.waiting;
      this.waiting = null;
      const controller = new AbortController();
      this.running = { controller, since: performance.now() };
      try {
        await this.work(wish, controller.signal);
      } finally {
        this.running = null;
        clearTimeout(this.timer);
      }
    }
  }
}
