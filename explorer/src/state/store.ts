/** Holds the state, tells who listens, and keeps the URL in step with it. */
import * as place from "./place.ts";
import { fromFragment, toFragment, type State } from "./state.ts";

/** push: a step that "back" undoes; replace: no step of its own; drag: not yet in the URL. */
export type Step = "push" | "replace" | "drag";
export type Listener = (state: State, before: State, step: Step) => void;

export class Store {
  private current_: State;
  private listeners_: Listener[] = [];
  private dragged_ = false;

  constructor(private readonly defaults_: State) {
    this.current_ = fromFragment(place.fragment(), defaults_);
    place.write(this.link(), "replace");
    place.onVisit(() => this.take_(fromFragment(place.fragment(), this.defaults_)));
  }

  get state(): State {
    return this.current_;
  }

  get isDragging(): boolean {
    return this.dragged_;
  }

  /** The fragment, with its "#", that brings this state back. */
  link(): string {
    return "#" + toFragment(this.current_);
  }

  listen(listener: Listener): void {
    this.listeners_.push(listener);
  }

  update(change: Partial<State>, step: Step = "push"): void {
    const before = this.current_;
    this.current_ = { ...before, ...change };
    this.dragged_ = step === "drag";
    if (step !== "drag") place.write(this.link(), step);
    for (const listener of this.listeners_) listener(this.current_, before, step);
  }

  private take_(state: State): void {
    const before = this.current_;
    this.current_ = state;
    this.dragged_ = false;
    for (const listener of this.listeners_) listener(state, before, "replace");
  }
}
