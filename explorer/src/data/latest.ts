/**
 * Work of which only the newest wish counts. At most one is in flight. What follows a moving slider is let go on until
 * it has shown something: if each wish ended the one before, a slider faster than the answers would never show one.
 */
type Work<Wish> = (wish: Wish, signal: AbortSignal, shown: () => void) => Promise<void>;

interface Running {
  controller: AbortController;
  since: number;
  hasShown: boolean;
}

export class Latest<Wish> {
  private running_: Running | null = null;
  private waiting_: { wish: Wish } | null = null;

  /** @param patience how long work that has shown something may still go on when a newer wish waits [ms] */
  constructor(
    private readonly work_: Work<Wish>,
    private readonly patience_ = 0,
  ) {}

  /** After what runs, or in its place once that has shown something. */
  ask(wish: Wish): void {
    this.waiting_ = { wish };
    if (this.running_) this.giveWay_(this.running_);
    else void this.next_();
  }

  /** In place of what runs. */
  askNow(wish: Wish): void {
    this.waiting_ = { wish };
    if (this.running_) this.running_.controller.abort();
    else void this.next_();
  }

  /** Aborts what runs and forgets what waits. */
  cancel(): void {
    this.waiting_ = null;
    this.running_?.controller.abort();
  }

  private giveWay_(running: Running): void {
    if (!this.waiting_ || !running.hasShown) return;
    const left = this.patience_ - (performance.now() - running.since);
    if (left <= 0) running.controller.abort();
    else setTimeout(() => this.running_ === running && this.waiting_ && running.controller.abort(), left);
  }

  private async next_(): Promise<void> {
    while (this.waiting_) {
      const { wish } = this.waiting_;
      this.waiting_ = null;
      const running: Running = { controller: new AbortController(), since: performance.now(), hasShown: false };
      this.running_ = running;
      const shown = (): void => {
        running.hasShown = true;
        this.giveWay_(running);
      };
      try {
        await this.work_(wish, running.controller.signal, shown);
      } finally {
        this.running_ = null;
      }
    }
  }
}
