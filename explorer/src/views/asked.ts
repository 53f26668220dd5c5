/** What a view has asked the server for: asked once per wish, the newest one wins, and its state is said in words. */
import { isAbort, sentence } from "../data/api.ts";
import { Latest } from "../data/latest.ts";
import { h, setText } from "../draw/dom.ts";

export class Asked<Wish, Answer> {
  /** Says what is awaited or what went wrong; empty when all is well. */
  readonly note = h("p", { class: "note", role: "status" });
  answer: Answer | null = null;
  private key_ = "";
  private shown_: Wish | null = null; // what the answer is to
  private readonly requests_: Latest<Wish>;

  constructor(
    work: (wish: Wish, signal: AbortSignal) => Promise<Answer>,
    private readonly take_: (answer: Answer, wish: Wish) => void,
    private readonly waiting_ = "Computing …",
  ) {
    this.requests_ = new Latest<Wish>(async (wish, signal) => {
      const slow = setTimeout(() => setText(this.note, this.waiting_), 200);
      try {
        const answer = await work(wish, signal);
        if (signal.aborted) return;
        this.answer = answer;
        this.shown_ = wish;
        setText(this.note, "");
        this.take_(answer, wish);
      } catch (error) {
        if (isAbort(error)) return;
        this.key_ = "";
        setText(this.note, sentence(error));
      } finally {
        clearTimeout(slow);
      }
    });
  }

  /** Asks unless this very thing was asked last. */
  ask(wish: Wish): void {
    const key = JSON.stringify(wish);
    if (key === this.key_) return;
    this.key_ = key;
    this.requests_.askNow(wish);
  }

  /** Shows the last answer anew. */
  again(): void {
    if (this.answer !== null && this.shown_ !== null) this.take_(this.answer, this.shown_);
  }

  forget(): void {
    this.key_ = "";
    this.requests_.cancel();
  }
}
