/** What the page asks of the server. Every call may be aborted, which ends the work on the other side as well. */
import { body, type Axis, type Design } from "../state/state.ts";
import { carry, oneFile } from "./carrier.ts";
import { Lines, motionOf, type Motion } from "./frames.ts";
import type {
  Advice,
  DesignAnswer,
  Analysis,
  FrictionLaw,
  Library,
  ModalLines,
  Refusal,
  ServerError,
  Shared,
  SoundOptions,
  Stability,
  Value,
} from "./answer_types.ts";
import type { ChartFrame, Simulation, Start } from "./types.ts";

/** The server refused, in its own words. */
export class Failure extends Error {
  /** All that it named, the first first. */
  readonly complaints: readonly ServerError[];

  constructor(readonly error: ServerError) {
    super(told(error));
    this.complaints = [error, ...(error.others ?? [])];
  }
}

function told({ what, why, suggestion }: ServerError): string {
  return [what, why ? `(${why})` : "", suggestion].filter(Boolean).join(" ");
}

export function isAbort(error: unknown): boolean {
  return error instanceof DOMException && error.name === "AbortError";
}

/** The first thing that went wrong. */
export function sentence(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** Everything that went wrong, each in a sentence or two. */
export function sentences(error: unknown): string[] {
  if (!(error instanceof Failure)) return [sentence(error)];
  const { untold = 0 } = error.error;
  return [...error.complaints.map(told), ...(untold > 0 ? [`${untold} more`] : [])];
}

async function checked(response: Response): Promise<Response> {
  if (response.ok) return response;
  let error: ServerError = { what: `The server answered ${response.status}`, why: response.statusText, suggestion: "" };
  try {
    const answer = (await response.json()) as Partial<Refusal>;
    if (answer.error) error = answer.error;
  } catch {
    // an answer that is no JSON leaves the status to say what went wrong
  }
  throw new Failure(error);
}

async function asked(path: string, init: RequestInit): Promise<Response> {
  try {
    return await checked(await carry(path, init));
  } catch (error) {
    if (error instanceof TypeError && oneFile())
      throw new Failure({ what: "The computation ended", why: error.message, suggestion: "Reload the page." });
    if (error instanceof TypeError)
      throw new Failure({
        what: "Stridor does not answer",
        why: "was it stopped?",
        suggestion: "Start `stridor explore` again.",
      });
    throw error;
  }
}

function post(path: string, content: unknown, signal?: AbortSignal): Promise<Response> {
  const headers = { "Content-Type": "application/json" };
  return asked(path, { method: "POST", headers, body: JSON.stringify(content), signal: signal ?? null });
}

async function json<T>(response: Promise<Response>): Promise<T> {
  return (await (await response).json()) as T;
}

/** Asks whether a case (TOML) can be opened; fails with what is wrong with it. Of a page in one file alone. */
export async function openable(toml: string): Promise<void> {
  await asked("/api/open", { method: "POST", body: toml });
}

export function start(): Promise<Start> {
  return json(asked("/api/start", {}));
}

export function simulate(design: Design, signal?: AbortSignal): Promise<Simulation> {
  return json(post("/api/simulate", body(design), signal));
}

/** The motion between two times; without an interval, as finely as the server gives it at once. */
export async function motion(
  design: Design,
  range: { from: number; to: number; interval: number | null },
  signal?: AbortSignal,
): Promise<Motion> {
  const response = await post("/api/motion", { ...body(design), ...range }, signal);
  return motionOf(await response.arrayBuffer());
}

export interface ChartWish {
  design: Design;
  chart: { x: Axis; y: Axis; refine: number };
  preview: boolean;
  figure: string;
}

/** The chart as it is refined, frame by frame; the last one is done. */
export async function* chart(wish: ChartWish, signal: AbortSignal): AsyncGenerator<ChartFrame> {
  const { design, ...rest } = wish;
  const response = await post("/api/chart", { ...body(design), ...rest }, signal);
  if (!response.body) return;
  const lines = new Lines();
  const frame = (line: string): ChartFrame => {
    const value = JSON.parse(line) as ChartFrame & { error?: ServerError };
    if (value.error) throw new Failure(value.error);
    return value;
  };
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    for (const line of lines.add(value)) yield frame(line);
  }
  for (const line of lines.end()) yield frame(line);
}

export function stability(
  design: Design,
  over: { key: string; from: number; to: number } | null,
  signal?: AbortSignal,
): Promise<Stability> {
  return json(post("/api/stability", { ...body(design), ...(over ? { over } : {}) }, signal));
}

/** The law of friction with the speeds at which the case slips; up to `reach` and without them, where that is given. */
export function friction(design: Design, reach: number | null, signal?: AbortSignal): Promise<FrictionLaw> {
  return json(post("/api/friction", { ...body(design), ...(reach === null ? { visited: true } : { reach }) }, signal));
}

export async function sound(design: Design, options: SoundOptions, signal?: AbortSignal): Promise<Blob> {
  return (await post("/api/sound", { ...body(design), ...options }, signal)).blob();
}

export function analysis(design: Design, options: SoundOptions, signal?: AbortSignal): Promise<Analysis> {
  return json(post("/api/analysis", { ...body(design), ...options }, signal));
}

export function modalLines(design: Design, of: string, signal?: AbortSignal): Promise<ModalLines> {
  return json(post("/api/modal", { ...body(design), of }, signal));
}

/** How a design stands; `around`: with what lies close to it, should it be quiet. */
export function design(design: Design, around: boolean, signal?: AbortSignal): Promise<DesignAnswer> {
  return json(post("/api/design", { ...body(design), around }, signal));
}

export interface AdviceWish {
  over?: { key: string; from: number; to: number }[];
  tolerance?: { key: string; relative: number }[];
}

export function advice(design: Design, wish: AdviceWish, signal?: AbortSignal): Promise<Advice> {
  return json(post("/api/advice", { ...body(design), ...wish }, signal));
}

export function library(signal?: AbortSignal): Promise<Library> {
  return json(asked("/api/library", { signal: signal ?? null }));
}

export async function recording(id: number, signal?: AbortSignal): Promise<Blob> {
  return (await asked(`/api/library/${id}/audio`, { signal: signal ?? null })).blob();
}

export function recordingAnalysis(id: number, signal?: AbortSignal): Promise<Analysis> {
  return json(asked(`/api/library/${id}/analysis`, { signal: signal ?? null }));
}

/** A sound, as a WAV file, judged by ear. */
export function heard(wav: Uint8Array<ArrayBuffer>, signal: AbortSignal): Promise<Analysis> {
  const headers = { "Content-Type": "audio/wav" };
  return json(asked("/api/recording", { method: "POST", headers, body: wav, signal }));
}

/** The number that a text with a unit is for a quantity, as `--set` takes it. */
export async function value(key: string, text: string): Promise<number> {
  return (await json<Value>(post("/api/value", { key, text }))).value;
}

/** The same case as one of the paper's with all that differs: it needs no file. */
export async function share(design: Design): Promise<Design> {
  const { preset, set } = await json<Shared>(post("/api/share", body(design)));
  return { preset, set: Object.fromEntries(set.map((text) => text.split("=", 2) as [string, string])) };
}

export async function toml(design: Design, axes: { x: Axis; y: Axis; refine: number } | null): Promise<string> {
  return (await post("/api/toml", { ...body(design), ...(axes ? { chart: axes } : {}) })).text();
}

export async function report(design: Design, axes: { x: Axis; y: Axis; refine: number }): Promise<Blob> {
  return (await post("/api/report", { ...body(design), chart: axes })).blob();
}
