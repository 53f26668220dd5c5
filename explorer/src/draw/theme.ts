/** Which palette is shown, and who wants to know when it or the units change. */
import type { Theme } from "../state/state.ts";
import { dark, fillOf, light, tile, type Palette } from "./colours.ts";

const system = matchMedia("(prefers-color-scheme: dark)");
const listeners: (() => void)[] = [];
let wanted: Theme = "auto";
let current: Palette = light;

export function palette(): Palette {
  return current;
}

export function onLook(listener: () => void): void {
  listeners.push(listener);
}

/** Has all that shows something show it anew. */
export function relook(): void {
  for (const listener of listeners) listener();
}

export function setTheme(theme: Theme): void {
  wanted = theme;
  apply();
}

/** A swatch of a category, with its hatching, as a background of an element. */
export function paintSwatch(element: HTMLElement, category: string): void {
  const fill = fillOf(current, category);
  element.style.backgroundColor = fill.ground;
  const marks = tile(fill, 2);
  element.style.backgroundImage = marks ? `url(${marks.toDataURL()})` : "none";
  element.style.backgroundSize = "8px 8px";
}

function apply(): void {
  const next = wanted === "dark" || (wanted === "auto" && system.matches) ? dark : light;
  const root = document.documentElement;
  root.dataset.theme = next.name;
  root.style.colorScheme = next.name;
  for (const name of ["page", "panel", "field", "ink", "muted", "line", "grid", "accent", "onAccent", "warn"] as const)
    root.style.setProperty(`--${name}`, next[name]);
  for (const [state, colour] of Object.entries(next.state)) root.style.setProperty(`--${state}`, colour);
  if (next === current && root.dataset.painted) return;
  root.dataset.painted = "yes";
  current = next;
  relook();
}

system.addEventListener("change", apply);
