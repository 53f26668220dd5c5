/** The places of a slider and the values they stand for. Pure: what was shown is found again, to the last digit. */
import type { Scale } from "../program/words.ts";
import { rounded } from "./format.ts";
import { at, share } from "./scale.ts";

export interface Range {
  from: number;
  to: number;
  scale: Scale;
}

/** The last place of a slider: of two decades each is half a per cent from the next. */
export const lastPlace = 1000;

/** A value that stands at a place as it is, not as the place would have it. */
interface Kept {
  place: number;
  value: number;
}

/**
 * A range with room above the own value, which else may lie at its end: a hand that went there and came back by as many
 * steps would not find it. As far as the quantity goes at most.
 */
export function roomy(range: Range, own: number, most: number | null): Range {
  return { ...range, to: Math.max(range.to, Math.min(1.5 * own, most ?? Infinity)) };
}

/** By magnitude, where the range has no sign: the sign stays as it is. */
export class Places {
  /** Where the hand is. */
  place = 0;
  private range_: Range; // the given one, and what was shown beyond it
  private sign_ = 1;
  private shown_: Kept | null = null; // what was last set by other means than a place
  private own_: Kept | null = null; // what the case holds without changes

  constructor(private given_: Range) {
    this.range_ = given_;
  }

  /** Shows a value, of a case that holds `own` without changes and varies it in a range; gives its place. */
  show(value: number, own: number | undefined, range: Range | null): number {
    if (range && (range.from !== this.given_.from || range.to !== this.given_.to)) this.range_ = this.given_ = range;
    this.sign_ = value < 0 && this.given_.from >= 0 ? -1 : 1;
    this.reach_(value * this.sign_);
    this.own_ = own === undefined || own * this.sign_ < 0 ? null : { place: this.placeOf_(own), value: own };
    if (value !== this.at(this.place)) {
      this.place = this.placeOf_(value);
      this.shown_ = { place: this.place, value };
    }
    return this.place;
  }

  /** The value at a place. */
  at(place: number): number {
    const kept = [this.shown_, this.own_].find((each) => each?.place === place);
    const { from, to, scale } = this.range_;
    return kept ? kept.value : this.sign_ * rounded(at(place / lastPlace, from, to, scale), 4);
  }

  private reach_(size: number): void {
    const { from, to, scale } = this.range_;
    if (!Number.isFinite(size) || (scale === "log" && !(size > 0))) return;
    if (size < from || size > to) this.range_ = { from: Math.min(from, size), to: Math.max(to, size), scale };
  }

  private placeOf_(value: number): number {
    const { from, to, scale } = this.range_;
    const part = share(value * this.sign_, from, to, scale);
    return Math.round(lastPlace * Math.min(Math.max(Number.isFinite(part) ? part : 0, 0), 1));
  }
}
