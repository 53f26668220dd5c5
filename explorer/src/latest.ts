/**
 * Work of which only the newest wish counts. At most one is in flight. A newer wish aborts it, but not before it has
 * had its time: without that, a slider moving faster than the answers come would never show one.
 */
export class Latest<Wish> {
  private running_: { controller: AbortController; since: number } | null = null;
  private waiting_: { wish: Wish } | null = null;
  private timer_ = 0;

  /** @param patience how long a running wish may go on when a newer one waits [ms] */
  constructor(
    private readonly work_: (wish: Wish, signal: AbortSignal) => Promise<void>,
    private readonly patience_ = 0,
  ) {}

  ask(wish: Wish): void {
    this.waiting_ = { wish };
    if (!this.running_) {
      void this.next_();
      return;
    }
    const left = this.patience_ - (performance.now() - this.running_.since);
    clearTimeout(this.timer_);
    if (left <= 0) this.running_.controller.abort();
    else this.timer_ = window.setTimeout(() => this.waiting_ && this.running_?.controller.abort(), left);
  }

  /** Aborts what runs and forgets what waits. */
  cancel(): void {
    this.waiting_ = null;
    this.running_?.controller.abort();
  }

  /** Starts the wish at once, whatever runs. */
  askNow(wish: Wish): void {
    this.waiting_ = { wish };
    if (this.running_) this.running_.controller.abort();
    else void this.next_();
  }

  private async next_(): Promise<void> {
    while (this.waiting_) {
      const { wish } = this.waiting_;
      this.waiting_ = null;
      const controller = new AbortController();
      this.running_ = { controller, since: performance.now() };
      try {
        await this.work_(wish, controller.signal);
      } finally {
        this.running_ = null;
        clearTimeout(this.timer_);
      }
    }
  }
}
