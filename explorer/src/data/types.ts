/**
 * What the server sends: names and units as the program's own JSON has them. Every key of an answer stands here,
 * whether the page reads it or not. tests/browser/answers.test.mjs holds real answers against them.
 */
import type {
  Category,
  ContactState,
  Direction,
  Ending,
  FigureName,
  Phase,
  QuietReason,
  Scale,
  StabilityKind,
  VerdictWord,
} from "../program/words.ts";
import type { Axis } from "../state/state.ts";

/** What a document begins with. */
interface Document {
  schema: string;
  version: string;
  commit: string;
}

/** Units by the place in a document: "phases.verdict.period". */
export type Units = Record<string, string>;

/**
 * A resolved case: section -> name -> value; a column over the temperature is a list. The title stands on its own.
 * Several joints are a list, each with its name and its contact.
 */
export type Case = { title: string } & Record<string, Section | JointPart[] | string>;
export type Section = Record<string, number | string | (number | string)[]>;
export type JointPart = { name: string; contact: Section } & Record<string, number | string | Section>;

/** "drive.kind": ["constant"]: the choices without which a field means nothing; empty if it always does. */
export type Homes = Record<string, string[]>;

export interface QuantityField {
  key: string;
  section: string;
  symbol: string;
  sentence: string;
  belongs_to: Homes;
  kind: "quantity";
  unit: string;
  low: number | null;
  high: number | null;
  /** What a choice that needs it begins with; none where a case may leave it out. */
  default?: number;
  /** Between which values a designer varies it (of an imposed velocity: its magnitude); none for settings. */
  usual?: { from: number; to: number; scale: Scale };
}
export interface ChoiceField {
  key: string;
  section: string;
  symbol: string;
  sentence: string;
  belongs_to: Homes;
  kind: "choice";
  choices: string[];
}
export interface TextField {
  key: string;
  section: string;
  symbol: string;
  sentence: string;
  belongs_to: Homes;
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
  name: FigureName;
  unit: string;
  sentence: string;
}

export interface Start {
  schema: string;
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
  quiet_because: QuietReason | null;
  rates: Rates;
  judged_rates: Rates;
  /** Of an engine that compares two time steps: by how much its rates changed. */
  step_change?: Rates;
  judged_step_change?: Rates;
  regularity: number | null;
  repetition: number | null;
  variation: number | null;
  mismatch: (number | null)[];
  intervals: number;
  releases: number;
  lag: number;
  beat: { from: ContactState; to: ContactState };
  period: number | null;
  frequency: number | null;
  levels: { joint: Levels; plate: Levels; reference: string };
  margins: Margin[];
  reasons: string[];
}

export interface PhaseResult {
  phase: Phase;
  window: { from: number; to: number; duration: number; judged: number };
  verdict: Verdict;
}

/** Step, beta_2, the step it is compared with and the limit of the step belong to the engine of this name. */
export interface Engine {
  name: string;
  impact: string;
  steps: number;
  step?: number;
  beta_2?: number;
  compared_step?: number;
  step_limit?: number;
}

export interface Outcome {
  reason: Ending;
  time: number;
  silence?: { time: number; normal_force: number; slip_velocity: number };
  limit_cycle?: { time: number; period: number; residual: number; events: number };
  ending: { state: ContactState; since: number; future: string; release: number | null };
}

export interface Energy {
  stored: number;
  preload_work: number;
  drive_work: number;
  dashpot_loss: number;
  friction_loss: number;
  impact_loss: number;
  residual: number;
  relative_residual: number;
}

export interface Simulation extends Document {
  case: Case;
  engine: Engine;
  outcome: Outcome;
  energy: Energy;
  phases: PhaseResult[];
  units: Units;
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
  directions?: Direction[];
  category: string;
  computed_mask: string;
  figure?: string;
  boundaries?: BoundaryLine[];
}

export interface MotionHeader {
  schema: string;
  samples: number;
  start: number;
  interval: number;
  columns: { name: string; unit: string; sentence: string }[];
  contacts: { name: string; intervals: number }[]; // names of their joints
  states: ContactState[];
}

export interface Mode {
  growth: number;
  frequency: number;
}

/** Steady sliding with one value of what is varied. */
export interface SlidingStability {
  kind: StabilityKind;
  growth: number;
  frequency: number | null;
  normal_force: number;
  modes: Mode[];
}

export interface StabilityPoint extends SlidingStability {
  value: number;
}

export interface StabilityDirection extends SlidingStability {
  direction: Direction;
  points: StabilityPoint[];
  boundaries: { value: number; below: StabilityKind; above: StabilityKind; frequency: number | null }[];
}

export interface Stability extends Document {
  case: Case;
  over?: { parameter: string; unit: string };
  directions: StabilityDirection[];
  units: Units;
}

export interface Analysis {
  schema: string;
  unit: string;
  rate: number;
  duration: number;
  level: { time: number[]; decibels: (number | null)[]; unit: string };
  spectrum: { frequency: number[]; level: (number | null)[]; unit: string };
  spectrogram: { time: number[]; frequency: number[]; rows: number; columns: number; level: string };
  verdict: {
    category: Category;
    reasons: string[];
    segments: { from: number; to: number; category: Category; reasons: string[] }[];
  };
}

/** What is asked of a sound. */
export interface SoundOptions {
  direction: Direction | "whole";
  of: "joint" | "plate";
  quantity: "velocity" | "acceleration";
  rate: number;
  seconds: number;
}

/** A verdict of a design: the loudest phase's word, each phase's, and whether it is quiet since it sticks. */
export interface DesignVerdict {
  category: VerdictWord;
  phases: Partial<Record<Phase, VerdictWord>>;
  sticks: boolean;
}

/** Where the verdict changes: the value beyond, and the last one before. */
export interface AdviceBound extends DesignVerdict {
  value: number;
  before: number;
  distance: number;
  relative: number;
  share: number;
}

export interface AdviceMargin {
  key: string;
  value: number;
  unit: string;
  from: number;
  to: number;
  scale: Scale;
  free: boolean;
  below: AdviceBound | null;
  above: AdviceBound | null;
  quiet_below: AdviceBound | null;
  quiet_above: AdviceBound | null;
  end_below: ScanEnd;
  end_above: ScanEnd;
  scan: { value: number; category: VerdictWord }[];
}

/** The last value that was tried on a side. */
export interface ScanEnd {
  value: number;
  why: string;
  reason?: string;
}

export interface Setting {
  key: string;
  from: number;
  to: number;
  unit: string;
}

export interface DesignChange {
  set: Setting[];
  distance: number;
  options: string;
  verified: DesignVerdict & { runs: number; neighbourhood: number; starts: string[] };
}

/** A share with its interval of confidence. */
export interface Estimate {
  share: number;
  low: number;
  high: number;
}

export interface Chance {
  noise: number;
  low: number;
  high: number;
  confidence: number;
  samples: number;
  seed: number;
  not_quiet: Estimate;
  by_category: Partial<Record<VerdictWord, Estimate>>;
  tolerances: { key: string; value: number; tolerance: number; unit: string; spread: string }[];
}

export interface Advice extends Document {
  case: Case;
  units: Units;
  phases: Phase[];
  present: DesignVerdict & { quiet: boolean; message: string };
  margins: AdviceMargin[];
  ranking: string[];
  nearest: (DesignVerdict & { set: Setting[]; distance: number }) | null;
  change: DesignChange | null;
  changes: DesignChange[];
  chance: Chance | null;
  runs: number;
}

export interface LibraryEntry {
  id: number;
  figures?: Record<string, number>;
  category?: Category;
  [field: string]: unknown;
}

export interface Library extends Document {
  library: string;
  entries: LibraryEntry[];
  units: Units;
}

export interface ServerError {
  what: string;
  why: string;
  suggestion: string;
  /** Of the field that it is about; empty if it is about none. */
  key?: string;
  /** What else is wrong with the same request, and how much more of it was left out. */
  others?: ServerError[];
  untold?: number;
}

/** What the server says in place of an answer. */
export interface Refusal {
  schema: string;
  error: ServerError;
}

export interface Value {
  schema: string;
  value: number;
}

export interface Shared {
  schema: string;
  preset: string;
  set: string[];
}
