/** A slider of a quantity. Its thumb goes with the hand that takes it, from where it is. */
import type { QuantityField } from "../data/types.ts";
import { h } from "../draw/dom.ts";
import { exact } from "../draw/format.ts";
import { lastPlace, Places, type Range } from "../draw/places.ts";

export class Slider {
  readonly input: HTMLInputElement;
  private readonly places_: Places;

  constructor(
    field: QuantityField,
    range: Range,
    private readonly change_: (value: string, step: "push" | "drag") => void,
  ) {
    this.places_ = new Places(range);
    this.input = h("input", {
      "type": "range",
      "min": 0,
      "max": lastPlace,
      "step": 1,
      "data-key": field.key,
      "aria-label": field.sentence,
    });
    this.input.addEventListener("input", () => this.move_("drag"));
    this.input.addEventListener("change", () => this.move_("push"));
    this.input.addEventListener("pointerdown", (event) => this.take_(event));
  }

  /** Shows a value and what it is as text; `own` is what the case holds without changes. */
  show(value: number, text: string, own: number | undefined, range: Range | null): void {
    const place = this.places_.show(value, own, range);
    if (this.input.valueAsNumber !== place) this.input.value = String(place);
    this.input.setAttribute("aria-valuetext", text);
    this.input.style.setProperty("--part", `${(100 * place) / lastPlace}%`);
  }

  private move_(step: "push" | "drag"): void {
    this.places_.place = this.input.valueAsNumber;
    this.change_(exact(this.places_.at(this.places_.place)), step);
  }

  /** A thumb that is taken beside its middle does not jump there, as browsers have it. */
  private take_(taken: PointerEvent): void {
    const { input } = this;
    const box = input.getBoundingClientRect();
    const thumb = parseFloat(getComputedStyle(input).getPropertyValue("--thumb")); // [px] its width
    const travel = box.width - thumb;
    const first = input.valueAsNumber;
    const middle = box.left + thumb / 2 + (travel * first) / lastPlace;
    if (taken.button !== 0 || Math.abs(taken.clientX - middle) > 0.75 * thumb || !(travel > 0)) return;
    taken.preventDefault();
    input.focus();
    input.setPointerCapture(taken.pointerId);
    const stop = new AbortController();
    let hasMoved = false;
    const follow = (event: PointerEvent): void => {
      const place = Math.round(first + ((event.clientX - taken.clientX) / travel) * lastPlace);
      const inside = Math.min(Math.max(place, 0), lastPlace);
      if (inside === input.valueAsNumber) return;
      input.value = String(inside);
      hasMoved = true;
      this.move_("drag");
    };
    const end = (): void => {
      stop.abort();
      if (hasMoved) this.move_("push");
    };
    const { signal } = stop;
    input.addEventListener("pointermove", follow, { signal });
    input.addEventListener("pointerup", end, { signal });
    input.addEventListener("pointercancel", end, { signal });
    // a finger that moves the thumb neither scrolls nor moves it once more
    input.addEventListener("touchmove", (event) => event.preventDefault(), { signal, passive: false });
  }
}
