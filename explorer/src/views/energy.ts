/** Where the energy comes from and where it goes, and how the verdict came about. */
import { rubbing } from "../data/cases.ts";
import { worstFirst } from "../data/interfaces.ts";
import type { Case, InterfaceResult, PhaseResult, Simulation } from "../data/types.ts";
import { kindOf, wordOf } from "../draw/colours.ts";
import { h } from "../draw/dom.ts";
import { level, percent, plain, quantity, words } from "../draw/format.ts";
import { paintSwatch } from "../draw/theme.ts";
import type { Context, ViewPart } from "./views.ts";

const sources = ["drive_work", "preload_work"] as const;
const losses = ["friction_loss", "impact_loss", "dashpot_loss"] as const;
const parts = [...sources, ...losses, "stored"] as const;

export class Energy implements ViewPart {
  readonly element = h("div", { class: "energy" });

  show({ simulation }: Context): void {
    if (!simulation) return;
    const several = simulation.phases.filter((phase) => (phase.contacts?.length ?? 0) > 1);
    this.element.replaceChildren(
      ...several.map(contacts),
      balance(simulation),
      ...simulation.phases.map((phase) => reasons(phase, simulation.case)),
    );
  }
}

function balance({ energy, engine }: Simulation): HTMLElement {
  const turnover = Math.max(...parts.map((name) => Math.abs(energy[name])), 1e-300);
  const rows = parts.map((name) => {
    const value = energy[name];
    const bar = h("span", { class: `bar-fill ${name.endsWith("_loss") ? "loss" : "gain"}` });
    bar.style.width = `${(100 * Math.abs(value)) / turnover}%`;
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, words(name)),
      h("td", { class: "bar-cell" }, bar),
      h("td", { class: "number" }, quantity(value, "J")),
      h("td", { class: "number muted" }, percent(value / turnover)),
    );
  });
  return h(
    "div",
    { class: "card" },
    h("h3", {}, "Energy of the whole run"),
    h("table", { id: "energy" }, h("tbody", {}, ...rows)),
    h(
      "p",
      { class: "muted" },
      `created or lost by the ${engine.name} engine: `,
      h("span", { class: "number" }, quantity(energy.residual, "J", 2)),
      " (",
      h("span", { class: "number" }, plain(energy.relative_residual, 2)),
      " of the turnover)",
    ),
  );
}

function reasons(result: PhaseResult, resolved: Case): HTMLElement {
  const { phase, verdict } = result;
  const isPlate = rubbing(resolved) === "joint";
  const swatch = h("span", { "class": "swatch", "aria-hidden": "true" });
  paintSwatch(swatch, kindOf(verdict));
  const rows = verdict.margins.map((margin) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, words(margin.figure)),
      h("td", { class: "number" }, margin.value === null ? "–" : plain(margin.value, 3)),
      h(
        "td",
        { class: "muted" },
        `${(margin.distance ?? 0) >= 0 ? "≥" : "<"}\u00a0${plain(margin.threshold_value, 3)}`,
      ),
      h("td", { class: "muted" }, words(margin.threshold)),
    ),
  );
  const figures: [string, string][] = [
    ["frequency", quantity(verdict.frequency, "Hz")],
    ["period", quantity(verdict.period, "s")],
    [`${rubbing(resolved)}, velocity level`, `${level(verdict.levels.joint.level)} re 1 nm/s`],
    ...(isPlate
      ? [["plate, velocity level", `${level(verdict.levels.plate.level)} re 1 nm/s`] satisfies [string, string]]
      : []),
  ];
  return h(
    "div",
    { class: "card" },
    h("h3", {}, phase),
    h("p", { class: "entry" }, swatch, h("strong", {}, wordOf(verdict))),
    h("ul", {}, ...verdict.reasons.map((text) => h("li", {}, text))),
    ...verdict.warnings.map((text) => h("p", { class: "note" }, `Warning: ${text}`)),
    h("table", {}, h("tbody", {}, ...rows)),
    h("dl", {}, ...figures.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)])),
  );
}

/** What the contacts of an interface do together. */
function together({ rates, leading, differs, contacts: all }: InterfaceResult): HTMLElement | null {
  if (all.length < 2) return null;
  return h(
    "p",
    { class: "muted" },
    `${all.length} contacts as a whole: all stick ${percent(rates.sticks)}, some slip ${percent(rates.partly)}, ` +
      `all slip ${percent(rates.slides)}, all separated ${percent(rates.open)} of the time; ${leading} leads` +
      (differs ? ", and their verdicts differ" : ""),
  );
}

const columns = ["contact", "verdict", "slip", "stick", "separation", "frequency", "level", "load", "friction"];

/** Each contact by itself, the worst first. */
function contacts(result: PhaseResult): HTMLElement {
  const rows = worstFirst(result).map(({ name, verdict, load }) => {
    const shares = verdict?.judged_rates;
    const swatch = h("span", { "class": "swatch", "aria-hidden": "true" });
    paintSwatch(swatch, verdict ? kindOf(verdict) : "none");
    const numbers = [
      percent(shares?.slip),
      percent(shares?.stick),
      percent(shares?.separation),
      quantity(verdict?.frequency, "Hz"),
      level(verdict?.levels.joint.level ?? null),
      load ? percent(load.load_share) : "–",
      load ? quantity(load.friction_power, "W", 3) : "–",
    ];
    return h(
      "tr",
      { "data-contact": name },
      h("th", { scope: "row" }, name),
      h("td", {}, swatch, verdict ? wordOf(verdict) : "carries nothing"),
      ...numbers.map((text) => h("td", { class: "number" }, text)),
    );
  });
  return h(
    "div",
    { class: "card contacts" },
    h("h3", {}, `${result.phase}: each contact by itself, the worst first`),
    ...(result.interfaces ?? []).map(together),
    h(
      "table",
      {},
      h("thead", {}, h("tr", {}, ...columns.map((name) => h("th", { scope: "col" }, name)))),
      h("tbody", {}, ...rows),
    ),
  );
}
