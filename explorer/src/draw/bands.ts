/** The states of contacts over time: three rows of one contact, or one row each of many. Painting only. */
import type { Motion, Stays } from "../data/frames.ts";
import { staysWithin } from "../data/motions.ts";
import type { ContactState } from "../program/words.ts";
import type { Palette } from "./colours.ts";
import { mostLaned } from "./lane_specs.ts";
import { font, type Surface } from "./surface.ts";

export const marginLeft = 62;
export const marginRight = 10;

const bandRow = 8;
export const bandStates: readonly ContactState[] = ["separation", "stick", "slip"];
const bandHeight = bandRow * bandStates.length + 6;
const nameHeight = 12; // above a band, where several contacts have one each
const legendHeight = 14; // above the rows of many contacts
const rowHeight = 10; // of one of many contacts, as long as there is room
const mostOfHeight = 0.42; // of the canvas, for the rows of many contacts

export interface BandsView {
  span: readonly [number, number];
  palette: Palette;
  chosen: number;
}

function rowOf(contacts: number, height: number): number {
  return Math.min(rowHeight, (mostOfHeight * height) / contacts);
}

export function bandsHeight({ contacts }: Motion, height: number): number {
  if (contacts.length < 2) return bandHeight;
  if (contacts.length <= mostLaned) return contacts.length * (nameHeight + bandHeight);
  return legendHeight + contacts.length * rowOf(contacts.length, height) + 4;
}

/** The least height of a canvas that has so much left below its bands. */
export function heightAround({ contacts }: Motion, below: number): number {
  if (contacts.length <= mostLaned) return bandsHeight({ contacts } as Motion, 0) + below;
  const above = legendHeight + 4 + below;
  return Math.ceil(Math.min(above + contacts.length * rowHeight, above / (1 - mostOfHeight)));
}

/** The contact whose band is at a height of the canvas; none where there is one contact, or no band. */
export function contactAt({ contacts }: Motion, height: number, y: number): number | null {
  if (contacts.length < 2) return null;
  const isMany = contacts.length > mostLaned;
  const place = isMany ? (y - legendHeight) / rowOf(contacts.length, height) : y / (nameHeight + bandHeight);
  const contact = Math.floor(place);
  return contact >= 0 && contact < contacts.length ? contact : null;
}

/** A band per contact; of several each has its name above, of many it is a row. */
export function paintBands(surface: Surface, { contacts }: Motion, view: BandsView, inner: number): void {
  const { pen } = surface;
  if (contacts.length > mostLaned) return paintRows(surface, contacts, view, inner);
  contacts.forEach((stays, k) => {
    if (contacts.length < 2) return paintBand(surface, stays, view, 0, inner);
    const top = k * (nameHeight + bandHeight);
    pen.font = font(10, 600);
    pen.textAlign = "left";
    pen.textBaseline = "top";
    pen.fillStyle = k === view.chosen ? view.palette.accent : view.palette.ink;
    pen.fillText(stays.name, marginLeft, top + 1);
    paintBand(surface, stays, view, top + nameHeight, inner);
  });
}

/** The share of each state in each of `count` equal parts of a span, in the order of `bandStates`. */
export function sharesOf(stays: Stays, span: readonly [number, number], count: number): Float32Array[] {
  const [from, to] = span;
  const shares = bandStates.map(() => new Float32Array(count));
  const perSecond = count / (to - from);
  const [first, last] = staysWithin(stays, from, to);
  for (let stay = first; stay <= last; ++stay) {
    const share = shares[bandStates.indexOf(stays.state[stay] as ContactState)];
    if (!share) continue;
    const start = Math.max(0, ((stays.from[stay] as number) - from) * perSecond);
    const end = Math.min(count, ((stays.from[stay + 1] as number) - from) * perSecond);
    for (let k = Math.floor(start); k < end; ++k)
      share[k] = (share[k] as number) + Math.min(end, k + 1) - Math.max(start, k);
  }
  return shares;
}

/** A row per state; as dark as the state's share of the time in that pixel. */
function paintBand(surface: Surface, stays: Stays, view: BandsView, above: number, inner: number): void {
  const { pen } = surface;
  const count = Math.round(inner);
  const shares = sharesOf(stays, view.span, count);
  pen.font = font(9);
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  bandStates.forEach((state, row) => {
    const top = above + row * bandRow + 1;
    pen.fillStyle = view.palette.muted;
    pen.fillText(state, marginLeft - 5, top + bandRow / 2);
    pen.fillStyle = view.palette.grid;
    pen.fillRect(marginLeft, top, inner, bandRow - 1);
    pen.fillStyle = view.palette.state[state];
    const share = shares[row] as Float32Array;
    for (let k = 0; k < count;) {
      const value = share[k] as number;
      let end = k + 1;
      while (end < count && Math.abs((share[end] as number) - value) < 0.02) ++end;
      if (value > 0.004) {
        pen.globalAlpha = Math.min(1, 0.15 + 0.85 * value);
        pen.fillRect(marginLeft + k, top, end - k, bandRow - 1);
      }
      k = end;
    }
    pen.globalAlpha = 1;
  });
}

/** One row a contact, in the order along the line: a pixel is split by the shares of its time, stick lowest. */
function paintRows(surface: Surface, contacts: readonly Stays[], view: BandsView, inner: number): void {
  const row = rowOf(contacts.length, surface.height);
  paintLegend(surface, view);
  const named = Math.max(1, Math.ceil(8.5 / row)); // every so many have room for their names
  contacts.forEach((stays, k) => {
    const top = legendHeight + k * row;
    if (k % named === 0 || k === view.chosen) paintName(surface, view, stays.name, k, top + row / 2);
    paintRow(surface, stays, view, { top, height: row > 4 ? row - 1 : row, inner });
  });
  const { pen } = surface;
  pen.strokeStyle = view.palette.accent;
  pen.lineWidth = 1.5;
  pen.strokeRect(marginLeft - 1, legendHeight + view.chosen * row - 0.5, inner + 2, Math.max(row, 2));
}

function paintName({ pen }: Surface, { palette, chosen }: BandsView, name: string, k: number, y: number): void {
  pen.font = font(9, k === chosen ? 700 : 400);
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  pen.fillStyle = k === chosen ? palette.accent : palette.muted;
  let shown = name;
  while (shown.length > 2 && pen.measureText(shown).width > marginLeft - 8) shown = `…${shown.slice(2)}`;
  pen.fillText(shown, marginLeft - 5, y);
}

function paintRow(
  { pen }: Surface,
  stays: Stays,
  view: BandsView,
  box: { top: number; height: number; inner: number },
): void {
  const count = Math.round(box.inner);
  const shares = sharesOf(stays, view.span, count);
  const part = (state: number, k: number): number => (shares[state] as Float32Array)[k] as number;
  const isLike = (a: number, b: number): boolean =>
    bandStates.every((_, state) => Math.abs(part(state, a) - part(state, b)) < 0.02);
  for (let k = 0; k < count;) {
    let end = k + 1;
    while (end < count && isLike(k, end)) ++end;
    let top = box.top;
    for (const state of ["separation", "slip", "stick"] as const) {
      const height = box.height * part(bandStates.indexOf(state), k);
      pen.fillStyle = view.palette.state[state];
      if (height > 0) pen.fillRect(marginLeft + k, top, end - k, height);
      top += height;
    }
    k = end;
  }
}

function paintLegend({ pen }: Surface, { palette }: BandsView): void {
  pen.font = font(10);
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  let left = marginLeft;
  for (const state of bandStates) {
    pen.fillStyle = palette.state[state];
    pen.fillRect(left, 2, 9, 9);
    pen.fillStyle = palette.muted;
    pen.fillText(state, left + 13, 7);
    left += pen.measureText(state).width + 28;
  }
}
