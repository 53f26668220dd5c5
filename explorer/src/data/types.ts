/**
 * What the server sends: names and units as the program's own JSON has them. Every key of an answer stands here,
 * whether the page reads it or not. tests/browser/answers.test.mjs holds real answers against them.
 */
import type {
  CarriedLoad,
  Category,
  ContactState,
  Direction,
  Ending,
  Energy,
  FigureName,
  LimitCycle,
  OwnContact,
  Phase,
  QuietReason,
  Rates,
  RunEnding,
  Scale,
  Silence,
  VerdictFigures,
} from "../program/words.ts";
import type { Axis } from "../state/state.ts";

/** What a document begins with. */
export interface Document {
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
export type Section = Record<string, number | string | (number | string)[] | OwnContact[]>;
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

/** By key between which values a quantity of a case is varied, of a velocity its magnitude. */
export type Ranges = Record<string, { from: number; to: number; scale: Scale }>;

export interface Preset {
  name: string;
  title: string;
  case: Case;
  ranges: Ranges;
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

export interface Margin {
  threshold: string;
  figure: string;
  value: number | null;
  threshold_value: number;
  distance: number | null;
  error?: number | null;
}

export interface Verdict extends VerdictFigures {
  category: Category;
  quiet_because: QuietReason | null;
  /** Of an engine that compares two time steps: by how much its rates changed. */
  step_change?: Rates;
  judged_step_change?: Rates;
  mismatch: (number | null)[];
  beat: { from: ContactState; to: ContactState };
  levels: VerdictFigures["levels"] & { reference: string };
  margins: Margin[];
  reasons: string[];
  warnings: string[];
}

/** A contact by itself; without a verdict where it carries nothing. */
export interface ContactResult {
  name: string;
  rates: Rates;
  verdict: Verdict | null;
}

/** Contacts that are judged as a whole. */
export interface InterfaceResult {
  contacts: ({ name: string } & CarriedLoad)[];
  rates: { sticks: number; partly: number; slides: number; open: number };
  free_together: number | null; // none where no contact makes a noise
  leading: string;
  differs: boolean;
  category: Category;
}

export interface PhaseResult {
  phase: Phase;
  window: { from: number; to: number; duration: number; judged: number };
  verdict: Verdict;
  /** Of several joints and of an own structure. */
  contacts?: ContactResult[];
  /** Of an own structure. */
  interfaces?: InterfaceResult[];
}

/** Step, beta_2, the step it is compared with and the limit of the step belong to the engine of this name. */
export interface Engine {
  name: string;
  impact: string;
  steps: number;
  asked?: string;
  chosen_since?: string;
  step?: number;
  beta_2?: number;
  compared_step?: number;
  formulation?: string;
  step_limit?: number;
}

export interface Outcome {
  reason: Ending;
  time: number;
  silence?: Silence;
  limit_cycle?: LimitCycle;
  ending: RunEnding;
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
  /** Why the first cell without a result has none; empty where each has one. */
  gaps?: string;
}

export interface MotionHeader {
  schema: string;
  samples: number;
  start: number;
  interval: number;
  columns: { name: string; unit: string; sentence: string }[];
  contacts: { name: string; intervals: number }[]; // names of their joints, or their own
  /** Points of the line as which a structure is drawn [m]: along the sliding direction, the normal, across both. */
  outline?: number[][];
  states: ContactState[];
}
