/** The tabs below: of several views of one design, the one that is looked at. */
import { sentence } from "../data/api.ts";
import type { Simulation } from "../data/types.ts";
import { h } from "../draw/dom.ts";
import { views, viewTitles, type State, type View } from "../state/state.ts";
import type { Step, Store } from "../state/store.ts";

export interface Context {
  state: State;
  simulation: Simulation | null;
  step: Step;
}

/** A view shows a context when it is looked at, and asks the server only for what it does not show yet. */
export interface ViewPart {
  readonly element: HTMLElement;
  show(context: Context): void;
  hide?(): void;
  /** Of two sounds, lets the other one be heard. */
  switch?(): void;
}

export type Parts = Partial<Record<View, ViewPart>>;
/** What is fetched when it is first looked at: every view but the one that the page opens with. */
export type LaterParts = Record<Exclude<View, "response">, ViewPart>;

export class Views {
  readonly element: HTMLElement;
  private readonly tabs_ = new Map<View, HTMLButtonElement>();
  private readonly panes_ = new Map<View, HTMLElement>();
  private shown_: View | null = null;
  private context_: Context | null = null;
  private loading_ = false;

  /** `parts_` are there at once; `others_` fetches the rest when one of them is first looked at. */
  constructor(
    private readonly store_: Store,
    private parts_: Parts,
    private readonly others_: () => Promise<LaterParts>,
    available: (view: View) => boolean,
  ) {
    const list = h("div", { "class": "tabs", "role": "tablist", "aria-label": "Views" });
    list.addEventListener("keydown", (event) => this.key_(event));
    const body = h("div", { class: "panes" });
    for (const view of views.filter(available)) {
      const tab = h(
        "button",
        { "type": "button", "role": "tab", "id": `tab-${view}`, "aria-controls": `view-${view}`, "data-view": view },
        viewTitles[view],
      );
      tab.addEventListener("click", () => store_.update({ view }, store_.state.view === view ? "replace" : "push"));
      const pane = h(
        "div",
        { "class": "pane", "role": "tabpanel", "id": `view-${view}`, "aria-labelledby": `tab-${view}` },
        parts_[view]?.element ?? null,
      );
      this.tabs_.set(view, tab);
      this.panes_.set(view, pane);
      list.append(tab);
      body.append(pane);
    }
    this.element = h("section", { "class": "panel views", "aria-label": "Views of the design" }, list, body);
  }

  get current(): ViewPart | undefined {
    return this.shown_ ? this.parts_[this.shown_] : undefined;
  }

  show(context: Context): void {
    this.context_ = context;
    const { view } = context.state;
    for (const [name, tab] of this.tabs_) {
      tab.setAttribute("aria-selected", String(name === view));
      tab.tabIndex = name === view ? 0 : -1;
    }
    for (const [name, pane] of this.panes_) pane.hidden = name !== view;
    if (this.shown_ && this.shown_ !== view) this.parts_[this.shown_]?.hide?.();
    this.shown_ = view;
    const part = this.parts_[view];
    if (part) part.show(context);
    else void this.load_(view);
  }

  private async load_(view: View): Promise<void> {
    if (this.loading_) return;
    this.loading_ = true;
    try {
      this.parts_ = { ...(await this.others_()), ...this.parts_ };
      for (const [name, pane] of this.panes_) pane.replaceChildren(this.parts_[name]?.element ?? "");
    } catch (error) {
      this.panes_.get(view)?.replaceChildren(h("p", { class: "note", role: "status" }, sentence(error)));
      return;
    } finally {
      this.loading_ = false;
    }
    if (this.context_) this.show(this.context_);
  }

  private key_(event: KeyboardEvent): void {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (by === undefined) return;
    const names = [...this.tabs_.keys()];
    const next = names[(names.indexOf(this.store_.state.view) + by + names.length) % names.length] as View;
    this.store_.update({ view: next });
    this.tabs_.get(next)?.focus();
    event.preventDefault();
  }
}
