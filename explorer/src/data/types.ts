/** What the server sends: names and units as the program's own JSON has them. */
import type { Category, ContactState, Direction, Phase, Scale } from "../program/words.ts";
import type { Axis } from "../state/state.ts";

/** A resolved case: section -> name -> value; the title stands on its own. */
export type Case = { title: string } & Record<string, Record<string, number | string> | string>;

export interface QuantityField {
  key: string;
  section: string;
  symbol: string;
  sentence: string;
  kind: "quantity";
  unit: string;
  low: number | null;
  high: number | null;
  /** Between which values a designer varies it (of an imposed velocity: its magnitude); null for settings. */
  usual: { from: number; to: number; scale: Scale } | null;
}
export interface ChoiceField {
  key: string;
  section: string;
  symbol: string;
  sentence: string;
  kind: "choice";
  choices: string[];
}
export interface TextField {
  key: string;
  section: string;
  symbol: string;
  sentence: string;
  kind: "text";
}
export type Field = QuantityField | ChoiceField | TextField;

export interface Preset {
  name: string;
  title: string;
  case: Case;
  /** That of its file, should it have one, with the quantity it draws. */
  chart?: { x: Axis; y: Axis; figure: string };
}

export interface Figure {
  name: string;
  unit: string;
  sentence: string;
}

export interface Start {
  version: string;
  presets: Preset[];
  fields: Field[];
  figures: Figure[];
  chart: { x: Axis; y: Axis; refine: number };
  library: boolean;
}

export interface Rates {
  slip: number;
  stick: number;
  separation: number;
}

export interface Margin {
  threshold: string;
  figure: string;
  value: number | null;
  threshold_value: number;
  distance: number | null;
}

export interface Levels {
  rms: number | null;
  peak: number | null;
  level: number | null;
  peak_level: number | null;
}

export interface Verdict {
  category: Category;
  quiet_because: "slides" | "sticks" | null;
  rates: Rates;
  judged_rates: Rates;
  regularity: number | null;
  repetition: number | null;
  intervals: number | null;
  period: number | null;
  frequency: number | null;
  levels: { joint: Levels; plate: Levels };
  margins: Margin[];
  reasons: string[];
}

export interface PhaseResult {
  phase: Phase;
  window: { from: number; to: number; duration: number; judged: number };
  verdict: Verdict;
}

export interface Simulation {
  schema: string;
  version: string;
  case: Case;
  engine: Record<string, number | string>;
  outcome: { reason: string; time: number } & Record<string, unknown>;
  energy: Record<string, number>;
  phases: PhaseResult[];
}

export interface ChartAxisFrame extends Axis {
  unit: string;
  values: number[];
}

export interface BoundaryLine {
  direction: number;
  first: string;
  second: string;
  closed: boolean;
  x: number[];
  y: number[];
}

export interface ChartFrame {
  schema: string;
  round: number;
  done: boolean;
  computed: number;
  total: number;
  x?: ChartAxisFrame;
  y?: ChartAxisFrame;
  directions: Direction[];
  category: string;
  computed_mask?: string;
  figure?: string;
  boundaries?: BoundaryLine[];
}

export interface MotionHeader {
  schema: string;
  samples: number;
  start: number;
  interval: number;
  columns: { name: string; unit: string; sentence: string }[];
  intervals: number;
  states: ContactState[];
}

export interface Mode {
  growth: number;
  frequency: number;
}

export interface StabilityPoint {
  value: number;
  kind: string;
  growth: number;
  frequency: number | null;
  modes: Mode[];
}

export interface StabilityDirection extends Omit<StabilityPoint, "value"> {
  direction: Direction;
  points: StabilityPoint[];
  boundaries: { value: number; below: string; above: string; frequency: number | null }[];
}

export interface Stability {
  over?: { parameter: string; unit: string };
  directions: StabilityDirection[];
}

export interface Analysis {
  level: { time: number[]; decibels: (number | null)[]; unit: string };
  spectrum: { frequency: number[]; level: (number | null)[]; unit: string };
  spectrogram: { time: number[]; frequency: number[]; rows: number; columns: number; level: string };
  verdict: { category: Category | null; reasons: string[] };
}

/** What is asked of a sound. */
export interface SoundOptions {
  direction: Direction | "whole";
  of: "joint" | "plate";
  quantity: "velocity" | "acceleration";
  rate: number;
  seconds: number;
}

/** A verdict of a design: the loudest phase's category, and each phase's. */
export interface DesignVerdict {
  category: string;
  phases: Partial<Record<Phase, string>>;
}

export interface AdviceBound extends DesignVerdict {
  value: number;
  distance: number;
}

export interface AdviceMargin {
  key: string;
  value: number;
  unit: string;
  from: number;
  to: number;
  scale: Scale;
  below: AdviceBound | null;
  above: AdviceBound | null;
  scan: { value: number; category: string }[];
}

export interface Advice {
  present: DesignVerdict;
  margins: AdviceMargin[];
  ranking: string[];
  nearest: { distance: number } | null;
  change: {
    set: { key: string; from: number; to: number }[];
    distance: number;
    verified: DesignVerdict & { runs: number };
  } | null;
  chance: { noise: number; low: number; high: number; samples: number; confidence: number } | null;
}

export interface LibraryEntry {
  id: number;
  figures?: Record<string, number>;
  category?: Category;
  [field: string]: unknown;
}

export interface Library {
  library?: string;
  entries: LibraryEntry[];
  units: Record<string, string>;
}

export interface ServerError {
  what: string;
  why: string;
  suggestion: string;
  key?: string;
  /** What else is wrong with the same request, and how much more of it was left out. */
  others?: ServerError[];
  untold?: number;
}
