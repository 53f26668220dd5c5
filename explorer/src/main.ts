/** Puts the page together: one state, one simulation of it, and the views that show it. */
import "uplot/dist/uPlot.min.css";
import "./page.css";
import * as api from "./api.ts";
import { Chart } from "./chart.ts";
import { Clock } from "./clock.ts";
import { button, h } from "./dom.ts";
import { Latest } from "./latest.ts";
import { Mechanism } from "./mechanism.ts";
import { Motions } from "./motions.ts";
import { Complaint, Parameters } from "./parameters.ts";
import { themes, type Design, type State } from "./state.ts";
import { Store } from "./store.ts";
import { onTheme, setTheme } from "./theme.ts";
import type { Simulation, Start } from "./types.ts";
import { VerdictBar } from "./verdict.ts";

function defaultsOf(start: Start): State {
  const own = start.presets.find(({ name }) => name === "file") ?? start.presets.find(({ name }) => name === "squeal");
  return {
    design: { preset: (own ?? start.presets[0])?.name ?? "squeal", set: {} },
    x: start.chart.x,
    y: start.chart.y,
    figure: "category",
    direction: "going",
    view: "response",
    span: null,
    other: null,
    theme: "auto",
  };
}

function begin(start: Start): void {
  const store = new Store(defaultsOf(start));
  setTheme(store.state.theme);
  const complaint = new Complaint();
  const verdict = new VerdictBar((direction) => store.update({ direction }, "replace"));
  const parameters = new Parameters(store, start);
  const chart = new Chart(store, start);
  const motions = new Motions();
  const mechanism = new Mechanism(new Clock());
  const presetCase = (name: string) => start.presets.find((preset) => preset.name === name)?.case;
  let simulation: Simulation | null = null;

  const simulate = async (design: Design, signal: AbortSignal): Promise<void> => {
    verdict.busy();
    try {
      simulation = await api.simulate(design, signal);
      complaint.show("");
      parameters.blame(null);
      verdict.show(simulation, store.state.direction);
      parameters.show(store.state, simulation.case);
      chart.know(simulation);
      if (!store.isDragging) motions.renew(design, simulation);
    } catch (error) {
      if (api.isAbort(error)) return;
      complaint.show(api.sentence(error));
      parameters.blame(error instanceof api.Failure ? error.error : null);
    }
  };
  const runs = new Latest<Design>(simulate, 150);

  motions.listen(() => {
    if (motions.motion && simulation) mechanism.show(motions.motion, simulation, store.state.direction);
  });

  const theme = button("◐", () => {
    const next = themes[(themes.indexOf(store.state.theme) + 1) % themes.length] ?? "auto";
    store.update({ theme: next }, "replace");
  }, { id: "theme", class: "icon", title: "Theme: as the system, light, dark", "aria-label": "Change the theme" });

  store.listen((state, before, step) => {
    if (state.theme !== before.theme) setTheme(state.theme);
    if (JSON.stringify(state.design) !== JSON.stringify(before.design)) runs.ask(state.design);
    if (state.direction !== before.direction) {
      verdict.repaint(state.direction);
      mechanism.goTo(state.direction);
    }
    const known = state.design.preset === before.design.preset ? simulation?.case : presetCase(state.design.preset);
    if (known) parameters.show(state, known);
    chart.follow(state, step);
  });
  onTheme(() => verdict.repaint(store.state.direction));

  document.body.replaceChildren(
    h("header", {}, h("h1", {}, "Stridor"), verdict.element, verdict.announcement, theme),
    complaint.element,
    h("main", {}, parameters.element, mechanism.element, chart.element),
  );
  const first = presetCase(store.state.design.preset) ?? start.presets[0]?.case;
  if (first) parameters.show(store.state, first);
  runs.ask(store.state.design);
  chart.follow(store.state, "replace");
}

api.start().then(begin, (error: unknown) => {
  document.body.replaceChildren(h("p", { class: "complaint", role: "alert" }, api.sentence(error)));
});
