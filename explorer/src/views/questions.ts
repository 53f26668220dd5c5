/**
 * The questions of the tour. Each shows a design, lets one predict, and says what to try; what is right is read from
 * the simulations alone. Pure, but for what it asks the server.
 */
import * as api from "../data/api.ts";
import { valueIn } from "../data/cases.ts";
import type { Simulation } from "../data/types.ts";
import { plain, quantity } from "../draw/format.ts";
import type { Direction } from "../program/words.ts";
import type { Design, View } from "../state/state.ts";

export type Choice = readonly [value: string, text: string];

export interface Question {
  title: string;
  /** What is shown and what is asked. */
  text: string;
  design: Design;
  view: View;
  choices(shown: Simulation): Choice[];
  /** What to change, on which control, and from when on it is changed; null: the answer is in what is shown. */
  task: { text: string; key: string; to: string; isDone(shown: Simulation, tried: Simulation): boolean } | null;
  /** The choice that the model makes. */
  answer(tried: Simulation): string;
  /** What the model did, with its numbers. */
  says(tried: Simulation, design: Design): string | Promise<string>;
}

const category = (simulation: Simulation, direction: Direction): string =>
  simulation.phases.find(({ phase }) => phase === direction)?.verdict.category ?? "none";

const frequency = (simulation: Simulation, direction: Direction): number =>
  simulation.phases.find(({ phase }) => phase === direction)?.verdict.frequency ?? NaN;

function number(simulation: Simulation, section: string, name: string): number {
  return Number(valueIn(simulation.case, `${section}.${name}`) ?? NaN);
}

const verbs: Record<string, string> = {
  none: "is quiet",
  squeal: "squeals",
  squeak: "squeaks",
  creak: "creaks",
  undecided: "is undecided, too near to a threshold,",
};

const does = (simulation: Simulation, direction: Direction): string => verbs[category(simulation, direction)] ?? "";

function loudWays(simulation: Simulation): string {
  const loud = (["going", "coming"] as const).filter((direction) => category(simulation, direction) !== "none");
  return loud.length === 2 ? "both" : (loud[0] ?? "neither");
}

function isNoisy(simulation: Simulation): boolean {
  return loudWays(simulation) !== "neither";
}

/** What the theory of small motions says of sliding without stop: the noise that needs no stick. */
async function sliding(design: Design): Promise<string> {
  const { directions } = await api.stability(design, null);
  const unstable = directions.find(({ growth }) => growth > 0);
  if (!unstable)
    return (
      "Steady sliding is stable here: this noise lives on sticking, and on friction that falls when it tears loose " +
      "(stick-slip)."
    );
  const { kind, direction, frequency: at } = unstable;
  const what = [kind, direction, at ? quantity(at, "Hz", 3) : ""].filter(Boolean).join(", ");
  return `Steady sliding is unstable here (${what}): two modes couple and feed each other, stick or no stick.`;
}

const friction = (tried: Simulation, kind: "static" | "kinetic"): number =>
  number(tried, "contact", `${kind}_friction`);

const hasDrop = (tried: Simulation): boolean => friction(tried, "static") > friction(tried, "kinetic") * (1 + 1e-9);

const staysOrGoes: Choice[] = [
  ["stays", "the noise stays"],
  ["goes", "the noise goes"],
];

export const questions: readonly Question[] = [
  {
    title: "Raise the friction",
    text:
      "A joint leans at 70° on a plate that is shaken to and fro. Kinetic friction is 0.3, and all is quiet. When " +
      "you raise it, what will the joint do while the plate is going to the right?",
    design: { preset: "squeal", set: { "contact.kinetic_friction": "0.3" } },
    view: "response",
    choices: () => [
      ["none", "stay quiet"],
      ["creak", "creak, slowly"],
      ["squeal", "squeal"],
    ],
    task: {
      text: "Now drag kinetic friction μd up, slowly, until it makes a noise.",
      key: "contact.kinetic_friction",
      to: "0.6",
      // between silence and noise lies a strip in which no category is certain
      isDone: (_, tried) => !["none", "undecided"].includes(category(tried, "going")),
    },
    answer: (tried) => category(tried, "going"),
    says: (tried) =>
      `At μd = ${plain(friction(tried, "kinetic"), 3)} it ${does(tried, "going")}, ` +
      `at ${quantity(frequency(tried, "going"), "Hz", 3)}.`,
  },
  {
    title: "Hear it",
    text: "This is how that sounds: press play below, at A. How often does the joint hit the plate, per second?",
    design: { preset: "squeal", set: {} },
    view: "listen",
    choices: (shown) =>
      [0.1, 1, 10].map((factor) => {
        const wanted = quantity(factor * frequency(shown, "going"), "Hz", 2);
        return [String(factor), `about ${wanted}`] as const;
      }),
    task: null,
    answer: () => "1",
    says: (tried) => `The contact opens and closes ${plain(frequency(tried, "going"))} times per second.`,
  },
  {
    title: "Which way does it lock?",
    text:
      "Going, friction pushes the leaning joint into the plate, so that it presses harder and harder: it squeals. " +
      "Coming, friction lifts it off. Now lean it the other way, from 70° to 110°. Which way will it squeal?",
    design: { preset: "squeal", set: {} },
    view: "response",
    choices: () => [
      ["going", "going"],
      ["coming", "coming"],
      ["both", "both ways"],
      ["neither", "neither way"],
    ],
    task: {
      text: "Now drag the incidence angle α past the upright to 110°.",
      key: "joint.incidence_angle",
      to: "110",
      isDone: (_, tried) => number(tried, "joint", "incidence_angle") >= 105,
    },
    answer: loudWays,
    says: (tried) =>
      `At α = ${plain(number(tried, "joint", "incidence_angle"), 4)}° it ${does(tried, "going")} going, ` +
      `and ${does(tried, "coming")} coming.`,
  },
  {
    title: "What feeds the squeal?",
    text:
      "Friction falls from 0.8 when it sticks to 0.6 when it slips. Such a drop can feed a noise. Take it away: " +
      "static friction as low as kinetic. What becomes of the squeal?",
    design: { preset: "squeal", set: {} },
    view: "modes",
    choices: () => staysOrGoes,
    task: {
      text: "Now type 0.6 into the field of static friction μs.",
      key: "contact.static_friction",
      to: "0.6",
      isDone: (_, tried) => !hasDrop(tried),
    },
    answer: (tried) => (isNoisy(tried) ? "stays" : "goes"),
    says: async (tried, design) => `Without the drop it ${does(tried, "going")} going. ${await sliding(design)}`,
  },
  {
    title: "And the creak?",
    text:
      "Here the joint is pressed a hundred times harder, sticks most of the time and jerks: it creaks. Friction " +
      "falls from 0.8 to 0.2. Take that drop away, too. What becomes of the creak?",
    design: { preset: "creak", set: {} },
    view: "modes",
    choices: () => staysOrGoes,
    task: {
      text: "Now type 0.2 into the field of static friction μs.",
      key: "contact.static_friction",
      to: "0.2",
      isDone: (_, tried) => !hasDrop(tried),
    },
    answer: (tried) => (isNoisy(tried) ? "stays" : "goes"),
    says: async (tried, design) =>
      `Without the drop it ${does(tried, "going")} going, and ${does(tried, "coming")} coming. ` +
      (await sliding(design)),
  },
];
