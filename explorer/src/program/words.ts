/** The words of answers and requests. Written by `stridor explore --typescript words`, not by hand. */

/** The way the plate moves. */
export const directions = ["going", "coming"] as const;
export type Direction = (typeof directions)[number];

/** The kinds of drive whose velocity is one for ever, and has a sign. */
export const steadyDrives = ["constant"] as const;
export type SteadyDrive = (typeof steadyDrives)[number];

/** What of a run a verdict is about. */
export const phases = ["all", "going", "coming"] as const;
export type Phase = (typeof phases)[number];

/** How the values of an axis are spaced. */
export const scales = ["linear", "log"] as const;
export type Scale = (typeof scales)[number];

/** What the contact does. */
export const contactStates = ["slip", "stick", "separation"] as const;
export type ContactState = (typeof contactStates)[number];

/** What is heard. */
export const categories = ["none", "squeal", "squeak", "creak", "undecided"] as const;
export type Category = (typeof categories)[number];

/** Why nothing is heard. */
export const quietReasons = ["slides", "sticks", "locks"] as const;
export type QuietReason = (typeof quietReasons)[number];

/** What each number in a chart's frame stands for; 255: no result. */
export const chartKinds = ["none", "squeal", "squeak", "creak", "undecided", "none (sticks)", "locks"] as const;
export type ChartKind = (typeof chartKinds)[number];

/** A category, or why there is none. */
export const verdictWords = [
  "none",
  "squeal",
  "squeak",
  "creak",
  "undecided",
  "invalid",
  "step_limit",
  "diverged",
  "failed",
  "locks",
] as const;
export type VerdictWord = (typeof verdictWords)[number];

/** How a run ended. */
export const endings = [
  "completed",
  "settled",
  "diverged",
  "step_limit",
  "cancelled",
  "chattering",
  "unbalanced",
  "no_forces",
  "painleve",
] as const;
export type Ending = (typeof endings)[number];

/** How steady sliding answers to a small push. */
export const stabilityKinds = ["stable", "flutter", "divergence", "locked"] as const;
export type StabilityKind = (typeof stabilityKinds)[number];

/** What is known of a cell in numbers. */
export const figureNames = [
  "slip",
  "stick",
  "separation",
  "judged_slip",
  "judged_stick",
  "judged_separation",
  "regularity",
  "repetition",
  "variation",
  "intervals",
  "releases",
  "lag",
  "period",
  "frequency",
  "joint_rms",
  "joint_peak",
  "joint_level",
  "plate_rms",
  "plate_peak",
  "plate_level",
  "growth_rate",
  "mode_frequency",
  "energy_residual",
  "proof_time",
] as const;
export type FigureName = (typeof figureNames)[number];

/** A contact of a structure of the user's own, as [structure] lists it. */
export interface OwnContact {
  /** what results call it */
  name: string;
  /** gap without load; negative: pressed together so far [m] */
  initial_gap: number;
  /** its own mu_s [1] */
  static_friction: number;
  /** its own mu_d [1] */
  kinetic_friction: number;
  /** part of V that the surface has along the tangent [1] */
  drive_share: number;
  /** preload; none of one that a load or a negative gap presses [N] */
  preload?: number;
  /** contacts of one name are judged as a whole */
  interface?: string;
  /** where it is, for drawings; it changes no result [m] */
  position?: number[];
  /** for which it has stuck at the start [s] */
  initial_rest: number;
  /** friction state at the start: what bristles bear, or psi [1] */
  initial_friction_state: number;
  /** How far along the line of contacts that is [m], where all are known and differ. */
  along_line?: number;
}

/** Shares of the time in each state of a contact. */
export interface Rates {
  /** share of the time in slip [1] */
  slip: number;
  /** share of the time in stick [1] */
  stick: number;
  /** share of the time in separation [1] */
  separation: number;
}

/** What is proven of a contact that slides for ever. */
export interface Silence {
  /** from when on [s] */
  time: number;
  /** what the normal force never falls below [N] */
  normal_force: number;
  /** what the magnitude of the slip velocity never falls below [m/s] */
  slip_velocity: number;
}

/** A motion that repeats itself. */
export interface LimitCycle {
  /** when the second of two equal periods ended [s] */
  time: number;
  /** of the motion [s] */
  period: number;
  /** distance of the states one period apart, as a share of the velocities [1] */
  residual: number;
  /** changes of state or of the slip's direction, and impacts, per period */
  events: number;
}

/** How a run ends, and how it would go on. */
export interface RunEnding {
  /** the last one of the first contact */
  state: ContactState;
  /** when it entered that [s] */
  since: number;
  /** what is known of the time after the run */
  future: string;
  /** about when a contact that sticks will slip [s] */
  release: number | null;
  /** of a small disturbance of sliding that does not last [1/s] */
  growth: number | null;
  /** about when that ends the sliding [s] */
  grown: number | null;
}

/** The energy balance of a run. */
export interface Energy {
  /** change of kinetic and elastic energy [J] */
  stored: number;
  /** work of the constant load [J] */
  preload_work: number;
  /** work of the drive [J] */
  drive_work: number;
  /** what the dampers took [J] */
  dashpot_loss: number;
  /** what friction took [J] */
  friction_loss: number;
  /** what impacts took [J] */
  impact_loss: number;
  /** what is left over [J] */
  residual: number;
  /** that as a share of all energy that went in or out [1] */
  relative_residual: number;
}

/** What one contact of an interface carries. */
export interface CarriedLoad {
  /** mean of the normal force [N] */
  normal_force: number;
  /** of the load of the interface [1] */
  load_share: number;
  /** mean of what friction takes [W] */
  friction_power: number;
  /** enough for a verdict */
  is_loaded: boolean;
}

/** A mode of steady sliding. */
export interface Mode {
  /** real part of the eigenvalue [1/s] */
  growth: number;
  /** 0 of a real eigenvalue [Hz] */
  frequency: number;
}

/** The figures of a verdict. */
export interface VerdictFigures {
  rates: {
    /** share of the window in slip [1] */
    slip: number;
    /** share of the window in stick [1] */
    stick: number;
    /** share of the window in separation [1] */
    separation: number;
  };
  judged_rates: {
    /** share of the judged time in slip [1] */
    slip: number;
    /** share of the judged time in stick [1] */
    stick: number;
    /** share of the judged time in separation [1] */
    separation: number;
  };
  /** regularity of the beats: 1 when all intervals are equal [1] */
  regularity: number | null;
  /** repetition of the pattern, perhaps after several unequal beats [1] */
  repetition: number | null;
  /** coefficient of variation of the intervals between beats [1] */
  variation: number | null;
  /** number of intervals between beats */
  intervals: number;
  /** number of sticks that ended in the judged time */
  releases: number;
  /** beats per period of the pattern */
  lag: number;
  /** period of the pattern [s] */
  period: number | null;
  /** dominant frequency of the alternation [Hz] */
  frequency: number | null;
  normal_force: {
    /** normal force at rest [N] */
    preload: number;
    /** largest normal force in the judged time, where states end [N] */
    largest: number;
  };
  drag: {
    /** normal force where the last stick began, without vibration [N] */
    from: number | null;
    /** normal force at the end of the run, without vibration [N] */
    to: number | null;
    /** way over which the contact was dragged in between [m] */
    way: number | null;
    /** how the normal force goes on with the way [N/m] */
    slope: number | null;
  };
  levels: {
    joint: {
      /** root mean square velocity of the joint [m/s] */
      rms: number | null;
      /** peak velocity of the joint [m/s] */
      peak: number | null;
      /** velocity level of the joint [dB re 1e-9 m/s] */
      level: number | null;
      /** peak velocity level of the joint [dB re 1e-9 m/s] */
      peak_level: number | null;
    };
    plate: {
      /** root mean square velocity of the plate [m/s] */
      rms: number | null;
      /** peak velocity of the plate [m/s] */
      peak: number | null;
      /** velocity level of the plate [dB re 1e-9 m/s] */
      level: number | null;
      /** peak velocity level of the plate [dB re 1e-9 m/s] */
      peak_level: number | null;
    };
  };
}
