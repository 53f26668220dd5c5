/**
 * The microphone of this machine: how loud it is now, and every two seconds what the last ten were by ear. Of the sound
 * nothing else is kept. Fetched when it is first asked for; what it uses of the page is handed in, to stand there once.
 */
import type * as api from "../data/api.ts";
import { LastSeconds } from "../data/last_seconds.ts";
import type { Analysis } from "../data/answer_types.ts";
import type { button, h, setText } from "../draw/dom.ts";
import type { Spectrogram } from "../draw/spectrogram.ts";

export interface Tools {
  h: typeof h;
  button: typeof button;
  setText: typeof setText;
  Spectrogram: typeof Spectrogram;
  byEar: (verdict: Analysis["verdict"]) => string;
  heard: typeof api.heard;
  sentence: typeof api.sentence;
  isAbort: typeof api.isAbort;
}

const longest = 10; // [s] that are judged
const pace = 100; // [ms] between two looks at what is new; the browser keeps two thirds of a second at 48 kHz
const patience = 30; // [1] such looks before it is told that nothing comes
const mostKept = 32_768; // [1] samples that it keeps
const often = 2; // [s] between two verdicts
const mostBytes = 1e6; // of a question that the program takes; of 16 bits, ten seconds at 48 kHz
const lowest = -90; // [dB] of the level that is shown

/** What somebody can do about a microphone that is not heard. */
const problems: Record<string, string> = {
  NotAllowedError:
    "The microphone was refused (by you, by the system, or by a page around this one). " +
    "Allow it beside the page's address, and start once more.",
  NotFoundError: "There is no microphone. Plug one in and start once more, or open a recording by Share.",
  NotReadableError: "The microphone gives nothing (another program may hold it). End that one, and start once more.",
};
const closed =
  "This browser gives the page no microphone (it is too old, or the address is neither this machine's nor https). " +
  "Record with another program, and open the recording by Share.";
const still =
  "The browser's audio does not run (some want a loudspeaker for it). Connect one and start once more, " +
  "or open a recording by Share.";

/** One time of listening, from start to stop. */
interface Session {
  stream: MediaStream;
  context: AudioContext;
  analyser: AnalyserNode;
  last: LastSeconds;
  asking: AbortController;
  timer: number;
}

export class Microphone {
  readonly element: HTMLElement;
  private readonly toggle_: HTMLButtonElement;
  private readonly meter_: HTMLMeterElement;
  private readonly level_: HTMLElement;
  private readonly verdict_: HTMLElement;
  private readonly spectrogram_: Spectrogram;
  private session_: Session | null = null;
  private starting_ = false;
  private wanted_ = false; // somebody may leave while the browser asks
  private judged_ = 0; // [s] heard at the last verdict
  private judging_ = false;

  /** `where` the sound is judged. */
  constructor(
    private readonly tools_: Tools,
    where: string,
  ) {
    const { h, button } = tools_;
    this.toggle_ = button("Stop", () => void (this.session_ ? this.stop() : this.start()), { id: "microphone-stop" });
    this.meter_ = h("meter", { "min": lowest, "max": 0, "high": -3, "value": lowest, "aria-label": "Level now" });
    this.level_ = h("span", { class: "muted" });
    this.verdict_ = h("p", { role: "status", id: "microphone-verdict" });
    this.spectrogram_ = new tools_.Spectrogram("Spectrogram of the microphone");
    this.spectrogram_.element.hidden = true;
    this.element = h(
      "div",
      { class: "card slot", id: "microphone-heard" },
      h("h3", {}, "Microphone"),
      h("div", { class: "bar" }, this.toggle_, this.meter_, this.level_),
      this.verdict_,
      h(
        "p",
        { class: "note" },
        `The last ${longest} s are judged ${where} and kept nowhere; nothing is sent elsewhere.`,
      ),
      this.spectrogram_.element,
    );
  }

  async start(): Promise<void> {
    this.wanted_ = true;
    if (this.session_ || this.starting_) return;
    this.starting_ = true;
    this.say_("Waiting for the microphone …");
    try {
      const session = await this.opened_();
      if (this.wanted_) this.begin_(session);
      else end(session);
    } catch (error) {
      const { sentence } = this.tools_;
      this.say_((error instanceof DOMException && problems[error.name]) || sentence(error));
    }
    this.starting_ = false;
    this.name_();
  }

  stop(): void {
    this.wanted_ = false;
    if (!this.session_) return;
    end(this.session_);
    this.session_ = null;
    this.meter_.value = lowest;
    this.tools_.setText(this.level_, "");
    this.name_();
  }

  private async opened_(): Promise<Session> {
    if (!navigator.mediaDevices) throw new Error(closed);
    // as it sounds: what calls need would take a squeal for noise, and turn it down
    const audio = { channelCount: 1, echoCancellation: false, noiseSuppression: false, autoGainControl: false };
    const stream = await navigator.mediaDevices.getUserMedia({ audio });
    const context = new AudioContext();
    const { sampleRate } = context;
    // not a script in the audio's own thread: a file would have to allow scripts that are not in it
    const analyser = new AnalyserNode(context, { fftSize: mostKept });
    context.createMediaStreamSource(stream).connect(analyser);
    const last = new LastSeconds(sampleRate, Math.min(longest, mostBytes / (2 * sampleRate)));
    return { stream, context, analyser, last, asking: new AbortController(), timer: 0 };
  }

  private begin_(session: Session): void {
    const { stream, context, analyser, last } = session;
    this.session_ = session;
    this.judged_ = 0;
    this.say_("Listening …");
    const newest = new Float32Array(mostKept);
    const framesNow = (): number => Math.round(context.currentTime * context.sampleRate);
    let before = framesNow();
    let looks = 0;
    void context.resume();
    session.timer = setInterval(() => {
      const now = framesNow();
      analyser.getFloatTimeDomainData(newest);
      last.follow(newest, now - before);
      before = now;
      if (++looks === patience && last.heard === 0) this.say_(still);
      this.showLevel_(last.level);
      if (last.heard - this.judged_ >= often && !this.judging_) void this.judge_(session);
    }, pace);
    for (const track of stream.getTracks())
      track.onended = () => {
        if (this.session_ !== session) return;
        this.stop();
        this.say_("The microphone ended (it was unplugged, or the permission taken back). Start once more.");
      };
  }

  private async judge_({ last, asking: { signal } }: Session): Promise<void> {
    const { heard, byEar, isAbort, sentence } = this.tools_;
    this.judging_ = true;
    this.judged_ = last.heard;
    const seconds = Math.round(last.held);
    try {
      const { verdict, spectrogram, tracks } = await heard(last.wav(), signal);
      if (!signal.aborted) {
        this.say_(`The last ${seconds} s, ${byEar(verdict)}.`);
        this.spectrogram_.element.hidden = false;
        this.spectrogram_.show(spectrogram, "Microphone", { ...tracks, segments: verdict.segments });
      }
    } catch (error) {
      if (!isAbort(error)) this.say_(sentence(error));
    }
    this.judging_ = false;
  }

  private showLevel_(decibels: number): void {
    this.meter_.value = Math.max(lowest, decibels);
    const isAny = decibels > lowest;
    this.tools_.setText(this.level_, isAny ? `${decibels.toFixed(0)} dB of full scale` : "silence");
  }

  private say_(text: string): void {
    this.tools_.setText(this.verdict_, text);
  }

  private name_(): void {
    this.tools_.setText(this.toggle_, this.session_ ? "Stop" : "Start");
  }
}

function end({ stream, context, asking, timer }: Session): void {
  clearInterval(timer);
  asking.abort();
  for (const track of stream.getTracks()) track.stop();
  void context.close();
}
