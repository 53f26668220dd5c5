/**
 * Carries questions to workers, each with a core of its own. A worker has one question at a time; an aborted question
 * ends its worker, since nothing else stops what it computes. One that has taken much memory is ended after its answer:
 * the memory of WebAssembly never becomes less. A chart is computed by all of them.
 */
import type { Begin, Letter, Question } from "./letters.ts";

const mostMemory = 96e6; // [bytes] of a worker that waits for its next question
const mostWaiting = 2; // workers without a question; with more the others are ended
const noMemory = "The browser gives the page no more memory. Close other tabs and reload it, or ask for fewer points.";
export const noWorkers =
  "This browser runs no workers from a file (a policy may forbid them). Open the file in another browser.";
const lacking = 202; // the status of an answer that lacks results of helpers

/** Who hears an answer. */
export interface Hearer {
  head(status: number, type: string): void;
  part(bytes: Uint8Array<ArrayBuffer>): void;
  end(): void;
  fail(error: unknown): void;
}

interface Labour {
  question: Question;
  signal: AbortSignal | null;
  hearer: Hearer;
}

export class Pool {
  private begin_: Begin | null = null;
  private ready_: Worker[] = [];
  private readonly asked_: Labour[] = [];
  private working_ = 0;

  /**
   * @param make a new worker, which has not begun
   * @param most workers at a time
   */
  constructor(
    private readonly make_: () => Worker,
    private readonly most_: number,
  ) {}

  /** Makes so many workers, which load their script while the core is still unpacked. */
  prepare(count: number): void {
    while (this.ready_.length < count) this.keep_(this.newWorker_());
  }

  /** Gives the workers their core. From now on it answers. */
  begin(begin: Begin): void {
    this.begin_ = begin;
    for (const worker of this.ready_) worker.postMessage(begin);
  }

  /** The answer, as `fetch` gives it. */
  carry(path: string, init: RequestInit, recording?: Uint8Array<ArrayBuffer>): Promise<Response> {
    return new Promise((take, fail) => {
      let body: ReadableStreamDefaultController<Uint8Array> | null = null;
      const hearer: Hearer = {
        head(status, type) {
          const stream = new ReadableStream<Uint8Array>({ start: (controller) => void (body = controller) });
          take(new Response(stream, { status, headers: { "Content-Type": type } }));
        },
        part: (bytes) => body?.enqueue(bytes),
        end: () => body?.close(),
        fail(error) {
          body?.error(error);
          fail(error);
        },
      };
      const question: Question = { path, body: typeof init.body === "string" ? init.body : "" };
      if (recording) question.recording = recording;
      const signal = init.signal ?? null;
      const helpers = this.most_ - 1; // one stays for what is asked meanwhile
      if (path === "/api/chart" && helpers > 1)
        this.share_(question, helpers, signal, hearer).catch((error: unknown) => hearer.fail(error));
      else this.ask({ question, signal, hearer }, "first");
    });
  }

  /** Asks as soon as a worker is free; what somebody waits for goes before the tasks of charts. */
  ask(labour: Labour, place: "first" | "last"): void {
    const { signal, hearer } = labour;
    if (signal?.aborted) return hearer.fail(aborted());
    signal?.addEventListener("abort", () => {
      const at = this.asked_.indexOf(labour);
      if (at < 0) return;
      this.asked_.splice(at, 1);
      hearer.fail(aborted());
    });
    if (place === "first") this.asked_.unshift(labour);
    else this.asked_.push(labour);
    this.fill_();
  }

  /** Asks again and again, each time with the results of what was lacking the time before. */
  private async share_(question: Question, helpers: number, signal: AbortSignal | null, hearer: Hearer): Promise<void> {
    let results: Uint8Array = new Uint8Array();
    let hasTold = false;
    for (let asks = 0; ; ++asks) {
      const shared = { results, helpers };
      const answers = await this.heard_({ ...question, shared }, signal);
      const last = answers.at(-1) as Heard;
      const isWhole = last.status !== lacking;
      const [told] = answers as [Heard];
      if (asks === 0) hearer.head(told.status, told.type);
      // what was told before is told again: of it the newest alone is news
      const news: Uint8Array<ArrayBuffer>[] = hasTold ? told.parts.slice(-1) : told.parts;
      hasTold ||= news.length > 0;
      for (const part of news) hearer.part(part);
      if (isWhole) return hearer.end();
      const found = await Promise.all(last.parts.map((tasks) => this.heard_({ ...question, tasks }, signal)));
      results = joined([results, ...found.flatMap((each) => (each.at(-1) as Heard).parts)]);
    }
  }

  /** All answers to a question, whole: one, or one that was begun and then what is lacking. */
  private heard_(question: Question, signal: AbortSignal | null): Promise<Heard[]> {
    return new Promise((take, fail) => {
      const answers: Heard[] = [];
      const hearer: Hearer = {
        head: (status, type) => void answers.push({ status, type, parts: [] }),
        part: (bytes) => void answers.at(-1)?.parts.push(bytes),
        end: () => take(answers),
        fail,
      };
      this.ask({ question, signal, hearer }, "last");
    });
  }

  private fill_(): void {
    while (this.asked_.length > 0 && this.working_ < this.most_)
      this.work_(this.ready_.pop() ?? this.newWorker_(), this.asked_.shift() as Labour);
    // the next question does not wait for a core to begin
    if (this.ready_.length === 0 && this.working_ < this.most_) this.keep_(this.newWorker_());
  }

  // one that fails before it is asked is made anew for the next question, and tells why there
  private keep_(worker: Worker): void {
    worker.onerror = () => (this.ready_ = this.ready_.filter((kept) => kept !== worker));
    this.ready_.push(worker);
  }

  private newWorker_(): Worker {
    const worker = this.make_();
    if (this.begin_) worker.postMessage(this.begin_);
    return worker;
  }

  private work_(worker: Worker, { question, signal, hearer }: Labour): void {
    ++this.working_;
    const leave = (isKept: boolean): void => {
      signal?.removeEventListener("abort", stop);
      worker.onmessage = worker.onerror = null;
      --this.working_;
      if (isKept && this.ready_.length < mostWaiting) this.keep_(worker);
      else worker.terminate();
      this.fill_();
    };
    const lose = (error: unknown): void => {
      hearer.fail(error);
      leave(false);
    };
    const stop = (): void => lose(aborted());
    signal?.addEventListener("abort", stop);
    worker.onerror = (event) => lose(event.message ? new TypeError(event.message) : new Error(noWorkers));
    worker.onmessage = ({ data }: MessageEvent<Letter>) => {
      if (data.kind === "head") hearer.head(data.status, data.type);
      else if (data.kind === "part") hearer.part(data.bytes);
      else if (data.kind === "failed") lose(data.lacksMemory ? new Error(noMemory) : new TypeError(data.why));
      else {
        hearer.end();
        leave(data.size <= mostMemory);
      }
    };
    worker.postMessage(question);
  }
}

interface Heard {
  status: number;
  type: string;
  parts: Uint8Array<ArrayBuffer>[];
}

function joined(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

function aborted(): DOMException {
  return new DOMException("The question was taken back.", "AbortError");
}
