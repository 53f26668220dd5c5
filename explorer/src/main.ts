/** Puts the page together: one state, one simulation of it, and the views that show it. */
import "uplot/dist/uPlot.min.css";
import "./page.css";
import * as api from "./data/api.ts";
import { oneFile } from "./data/carrier.ts";
import { withJoints } from "./data/cases.ts";
import { Latest } from "./data/latest.ts";
import { Motions } from "./data/motions.ts";
import type { Case, Simulation, Start } from "./data/types.ts";
import { button, h, menu, select } from "./draw/dom.ts";
import { setUnits, unitSystems, type UnitSystem } from "./draw/format.ts";
import { onLook, relook, setTheme } from "./draw/theme.ts";
import { Clock } from "./state/clock.ts";
import { kept, keptInTab } from "./state/place.ts";
import { ownPreset, paperPreset, themes, type Design, type State } from "./state/state.ts";
import { Shown } from "./state/shown.ts";
import { Store, type Step } from "./state/store.ts";
import { Chart } from "./views/chart.ts";
import { Mechanism } from "./views/mechanism.ts";
import { begun, Complaint, Parameters } from "./views/parameters.ts";
import { Response } from "./views/response.ts";
import type { Tour } from "./views/tour.ts";
import { VerdictBar } from "./views/verdict.ts";
import { Views } from "./views/views.ts";

const purpose =
  "Change a part and its contact, and see at once whether it squeals, squeaks or creaks, and how to quiet it.";
const alone = "All is computed in this file: nothing leaves this machine.";
const unitsKept = "stridor-units"; // in the browser's storage: which units are written
const tourSeen = "stridor-tour"; // in the session's storage: the tour was begun

/** What is not needed at once comes when it is first asked for. */
const later = () => import("./later.ts");

function defaultsOf(start: Start): State {
  const named = (preset: string) => start.presets.find(({ name }) => name === preset);
  const own = named(ownPreset) ?? named(paperPreset);
  return {
    design: { preset: (own ?? start.presets[0])?.name ?? paperPreset, set: {} },
    ...{ figure: "category", x: start.chart.x, y: start.chart.y, ...own?.chart },
    direction: "going",
    view: "response",
    span: null,
    other: null,
    theme: "auto",
  };
}

class Page {
  private readonly store_: Store;
  private readonly clock_ = new Clock();
  private readonly motions_ = new Motions();
  private readonly complaint_ = new Complaint();
  private readonly tourButton_ = button("Tour", () => void this.takeTour_(), {
    id: "tour-button",
    class: keptInTab.get(tourSeen) ? "" : "primary",
    title: "Two minutes: predict, then try (t)",
  });
  private readonly verdict_: VerdictBar;
  private readonly parameters_: Parameters;
  private readonly chart_: Chart;
  private readonly mechanism_: Mechanism;
  private readonly views_: Views;
  private readonly runs_ = new Latest<Design>((design, signal) => this.simulate_(design, signal));
  private readonly judged_ = new Latest<Design>((design, signal) => this.judge_(design, signal));
  private tour_: Tour | null = null;
  private simulation_: Simulation | null = null;
  private simulated_: Design | null = null; // what the simulation is of
  private moved_: Design | null = null; // what the motion is of

  constructor(private readonly start_: Start) {
    const store = (this.store_ = new Store(defaultsOf(start_)));
    setTheme(store.state.theme);
    setUnits(kept.get(unitsKept) === "engineering" ? "engineering" : "si");
    this.verdict_ = new VerdictBar((direction) => store.update({ direction }, "replace"));
    this.parameters_ = new Parameters(store, start_, (error) => this.complain_(error));
    this.chart_ = new Chart(store, start_, (error) => this.complain_(error));
    const shown = new Shown();
    this.mechanism_ = new Mechanism(this.clock_, shown, async () => (await later()).paintStructure);
    const first = {
      response: new Response(store, this.motions_, this.clock_, shown, async (...click) =>
        (await later()).beginAt(store, ...click),
      ),
    };
    this.views_ = new Views(
      store,
      first,
      async () => (await later()).viewsOf(store, start_),
      (view) => view !== "library" || start_.library,
    );
    this.motions_.listen(() => {
      const { motion, problem } = this.motions_;
      if (problem !== null) this.complain_(problem);
      if (motion && this.simulation_) this.mechanism_.show(motion, this.simulation_, store.state.direction);
    });
    onLook(() => {
      this.verdict_.repaint(store.state.direction);
      this.follow_(store.state, store.state, "replace");
    });
    store.listen((state, before, step) => this.follow_(state, before, step));
    document.addEventListener("keydown", (event) => this.key_(event));
    this.layOut_();
    this.begin_();
  }

  private unitPicker_(): HTMLElement {
    const choices = Object.entries(unitSystems);
    const pick = (name: string): void => {
      kept.set(unitsKept, name);
      setUnits(name as UnitSystem);
      relook();
    };
    const title = "Units of all that is shown; the case and what is sent stay as they are";
    const picker = select("Units", choices, pick, { id: "units", title });
    picker.value = kept.get(unitsKept) ?? "si";
    return picker;
  }

  private shareMenu_(): HTMLElement {
    const sheet = h("div", { class: "sheet" });
    const fill = async (): Promise<void> => {
      if (sheet.childElementCount > 0) return;
      try {
        sheet.replaceChildren((await later()).share(this.store_, this.start_, this.chart_));
      } catch (error) {
        this.complain_(error);
      }
    };
    return menu("Share", sheet, { id: "share" }, () => void fill());
  }

  private layOut_(): void {
    const tools = h(
      "div",
      { class: "tools" },
      this.tourButton_,
      this.shareMenu_(),
      this.unitPicker_(),
      button("◐", () => this.nextTheme_(), {
        "id": "theme",
        "class": "icon",
        "aria-label": "Change the theme",
        "title": "Theme: the system's, light, dark",
      }),
      button("?", () => void this.help_(), {
        "id": "help-button",
        "class": "icon",
        "aria-label": "Keys",
        "title": "Keys (?)",
      }),
    );
    document.body.replaceChildren(
      h(
        "header",
        {},
        h("h1", { title: `Stridor ${this.start_.version}` }, "Stridor"),
        h("p", { class: "purpose", id: "purpose" }, oneFile() ? `${purpose} ${alone}` : purpose),
        tools,
      ),
      this.verdict_.element,
      this.complaint_.element,
      h(
        "main",
        {},
        h("div", { class: "design" }, this.parameters_.element, this.chart_.element),
        this.mechanism_.element,
        this.views_.element,
      ),
    );
  }

  private begin_(): void {
    const { state } = this.store_;
    const first = this.presetCase_(state.design.preset);
    if (first) this.parameters_.show(state, first, { ...state.design, set: {} });
    this.runs_.ask(state.design);
    this.chart_.follow(state, "replace");
    this.views_.show({ state, simulation: null, step: "replace" });
  }

  private presetCase_(name: string): Case | undefined {
    return this.start_.presets.find((preset) => preset.name === name)?.case;
  }

  private follow_(state: State, before: State, step: Step): void {
    if (state.theme !== before.theme) setTheme(state.theme);
    const isNew = !same(state.design, before.design);
    if (isNew && step === "drag") this.runs_.ask(state.design);
    else if (isNew) this.runs_.askNow(state.design);
    else if (step !== "drag") this.settle_();
    if (state.direction !== before.direction) {
      this.verdict_.repaint(state.direction);
      this.mechanism_.goTo(state.direction);
    }
    const { preset } = state.design;
    const [known, of] =
      this.simulation_ && this.simulated_?.preset === preset
        ? [this.simulation_.case, this.simulated_]
        : [this.presetCase_(preset), { preset, set: {} }];
    if (known) this.parameters_.show(state, known, of);
    const isOnlyView = !isNew && state.span !== before.span && state.direction === before.direction;
    if (!isOnlyView) this.chart_.follow(state, step);
    if (!isNew) this.views_.show({ state, simulation: this.simulation_, step });
  }

  /** A slider was let go: what was left out while it moved is done now. */
  private settle_(): void {
    const { design } = this.store_.state;
    if (!this.simulation_ || !same(this.simulated_, design) || same(this.moved_, design)) return;
    this.moved_ = design;
    this.motions_.renew(design, this.simulation_);
    this.judged_.askNow(design);
  }

  /** Says how the design stands, both ways and from every start; then, of a quiet one, what lies close to it. */
  private async judge_(design: Design, signal: AbortSignal): Promise<void> {
    try {
      for (const around of [false, true]) {
        const { headline, standing } = await api.design(design, around, signal);
        if (signal.aborted) return;
        this.verdict_.say(headline);
        if (standing !== "quiet_here") return;
      }
    } catch (error) {
      if (!api.isAbort(error)) this.verdict_.say("");
    }
  }

  private async simulate_(design: Design, signal: AbortSignal): Promise<void> {
    this.verdict_.busy();
    this.judged_.cancel();
    this.verdict_.say("");
    try {
      const simulation = await api.simulate(design, signal);
      if (signal.aborted) return;
      this.simulation_ = simulation;
      this.simulated_ = design;
      this.complain_(null);
      const { state } = this.store_;
      this.verdict_.show(simulation, state.direction);
      this.parameters_.show(state, simulation.case, design);
      this.chart_.know(simulation);
      this.tour_?.know(simulation, design);
      const step = this.store_.isDragging ? "drag" : "replace";
      if (step !== "drag") this.settle_();
      this.views_.show({ state, simulation, step });
    } catch (error) {
      if (api.isAbort(error)) return;
      this.verdict_.fail();
      this.complain_(error);
    }
  }

  /** Says what was refused; null: nothing any more. */
  private complain_(error: unknown): void {
    this.complaint_.show(error === null ? [] : api.sentences(error));
    this.parameters_.blame(error instanceof api.Failure ? error.complaints : []);
  }

  private async takeTour_(): Promise<void> {
    try {
      this.tour_ ??= (await later()).tour(this.store_);
      keptInTab.set(tourSeen, "yes");
      this.tourButton_.classList.remove("primary");
      this.tour_.begin();
      if (this.simulation_ && same(this.simulated_, this.store_.state.design))
        this.tour_.know(this.simulation_, this.store_.state.design);
    } catch (error) {
      this.complain_(error);
    }
  }

  private async help_(): Promise<void> {
    try {
      (await later()).help(this.start_);
    } catch (error) {
      this.complain_(error);
    }
  }

  private nextTheme_(): void {
    const { theme } = this.store_.state;
    this.store_.update({ theme: themes[(themes.indexOf(theme) + 1) % themes.length] ?? "auto" }, "replace");
  }

  private key_(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches("input[type=text], select, dialog *, .tour *"))
      return;
    const { state } = this.store_;
    const preset = this.start_.presets[Number(event.key) - 1];
    if (event.key === "?") void this.help_();
    else if (event.key === "t") void this.takeTour_();
    else if (event.key === "p") this.clock_.toggle();
    else if (event.key === "d")
      this.store_.update({ direction: state.direction === "going" ? "coming" : "going" }, "replace");
    else if (event.key === "x" && state.view === "listen") this.views_.current?.switch?.();
    else if (preset) this.store_.update(begun(this.start_, preset, state));
    else return;
    event.preventDefault();
  }
}

function same(one: Design | null, other: Design): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}

api.start().then(
  (start) => new Page({ ...start, fields: withJoints(start.fields, start.presets) }),
  (error: unknown) => {
    document.body.replaceChildren(h("p", { class: "complaint", role: "alert" }, api.sentence(error)));
  },
);
