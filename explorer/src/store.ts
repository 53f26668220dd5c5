/** Holds the state, tells who listens, and keeps the URL in step with it. */
import { fromFragment, toFragment, type State } from "./state.ts";

/** push: a step that "back" undoes; replace: no step of its own; drag: not yet in the URL. */
export type Step = "push" | "replace" | "drag";
export type Listener = (state: State, before: State, step: Step) => void;

export class Store {
  private current: State;
  private listeners: Listener[] = [];
  private dragged = false;

  constructor(private readonly defaults: State) {
    this.current = fromFragment(location.hash, defaults);
    history.replaceState(null, "", this.link());
    addEventListener("popstate", () => this.take(fromFragment(location.hash, this.defaults)));
  }

  get state(): State {
    return this.current;
  }

  get isDragging(): boolean {
    return this.dragged;
  }

  /** The fragment, with its "#", that brings this state back. */
  link(): string {
    return "#" + toFragment(this.current, this.defaults);
  }

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }

  update(change: Partial<State>, step: Step = "push"): void {
    const before = this.current;
    this.current = { ...before, ...change };
    this.dragged = step === "drag";
    const link = this.link();
    if (step === "push" && link !== location.hash) history.pushState(null, "", link);
    if (step === "replace") history.replaceState(null, "", link);
    for (const listener of this.listeners) listener(this.current, before, step);
  }

  private take(state: State): void {
    const before = this.current;
    this.current = state;
    this.dragged = false;
    for (const listener of this.listeners) listener(state, before, "replace");
  }
}
