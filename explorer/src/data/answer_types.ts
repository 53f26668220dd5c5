/** What the server sends of one design when a view asks: stability, sounds, advice, recordings, refusals. */
import type { Category, Direction, Mode, Phase, Scale, StabilityKind, VerdictWord } from "../program/words.ts";
import type { Case, Document, Ranges, Units } from "./types.ts";

/** Steady sliding with one value of what is varied. */
export interface SlidingStability {
  kind: StabilityKind;
  growth: number;
  frequency: number | null;
  normal_force: number;
  modes: Mode[];
  /** Contacts of an own structure that steady sliding lifts off. */
  open?: string[];
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

/** A point of a law's curve that may be moved, up and down or along the speed. It sets origin + rate · where it is. */
export interface Grip {
  key: string;
  speed: number;
  friction: number;
  along: "speed" | "friction";
  low: number;
  high: number | null;
  origin: number;
  rate: number;
  way: string;
}

/** A law of friction over the speed of slip [m/s]: friction over normal force, each way where they differ. */
export interface FrictionLaw {
  schema: string;
  friction: string;
  speeds: number[];
  /** `limit`: of the stick; null of a law that creeps. One with a state is drawn as steady slip has it. */
  curves: { way: string; limit: number | null; friction: number[] }[];
  grips: Grip[];
  /** Of a table as measured: points that may be moved both ways. */
  rows: { speed: number; friction: number }[];
  visited: { from: number; to: number } | null;
}

/** Level over time and frequency: a row per moment, in base64 of floats. */
export interface LevelMap {
  time: number[];
  frequency: number[];
  rows: number;
  columns: number;
  level: string;
}

export interface SoundSegment {
  from: number;
  to: number;
  category: Category;
  reasons: string[];
}

/** What the ear follows in a recording: nothing of a simulated motion. */
export interface Tracks {
  pitch: { time: number[]; frequency: number[] };
  onsets: number[];
}

export interface Analysis {
  schema: string;
  unit: string;
  rate: number;
  duration: number;
  level: { time: number[]; decibels: (number | null)[]; unit: string };
  spectrum: { frequency: number[]; level: (number | null)[]; unit: string };
  spectrogram: LevelMap;
  /** The loudest passage of a recording through short frames, which tell impulses apart. */
  impulses: LevelMap | null;
  tracks: Tracks;
  /** The probability is the ear's, of a recording; the rules for motions know none. */
  verdict: { category: Category; probability: number | null; reasons: string[]; segments: SoundSegment[] };
}

/** The strongest lines in the spectrum of a velocity, and the free modes that have most of each. */
export interface ModalLines {
  schema: string;
  of: string;
  lines: { frequency: number; shares: { mode: number; frequency: number; share: number }[] }[];
}

/** What is asked of a sound. */
export interface SoundOptions {
  direction: Direction | "whole";
  of: string; // "joint", "plate", or the name of a contact or output
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
  verified: DesignVerdict & { runs: number; designs: number; neighbourhood: number; starts: string[] };
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
  /** Nobody named the tolerances. */
  usual: boolean;
  seed: number;
  not_quiet: Estimate;
  by_category: Partial<Record<VerdictWord, Estimate>>;
  tolerances: { key: string; value: number; tolerance: number; unit: string; spread: string }[];
}

/** What lies close to a quiet design: each change of one quantity that ends the silence, in words too. */
export interface Near {
  within: number;
  turns: (DesignVerdict & { key: string; relative: number; value: number; unit: string; words: string })[];
}

/** How a design stands, judged both ways and from every start. */
export interface Standing {
  headline: string;
  /** "quiet_here": what lies around was not looked at. */
  standing: "quiet" | "barely_quiet" | "quiet_here" | "not_quiet";
  phases: Phase[];
  starts: string[];
  present: DesignVerdict & { quiet: boolean; message: string };
  near: Near | null;
}

export interface DesignAnswer extends Document, Standing {
  case: Case;
  ranges: Ranges;
}

export interface Advice extends Document, Standing {
  case: Case;
  units: Units;
  margins: AdviceMargin[];
  ranking: string[];
  nearest: (DesignVerdict & { set: Setting[]; distance: number; words: string }) | null;
  change: DesignChange | null;
  /** The design that the change leads to. */
  changed: (Standing & { words: string; chance: Chance | null }) | null;
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
