/** What the chart's colours mean: swatches of categories, or a scale of the figure. */
import { isAwaited, type ChartData } from "../data/chart_data.ts";
import type { Start } from "../data/types.ts";
import { sequential } from "../draw/colours.ts";
import { h } from "../draw/dom.ts";
import { quantity, words } from "../draw/format.ts";
import { paintSwatch } from "../draw/theme.ts";

export class Legend {
  readonly element = h("div", { class: "legend", id: "legend" });
  private shown_ = "";

  show(data: ChartData | null, figure: string, start: Start): void {
    const key = data?.figure
      ? `${figure} ${data.figureRange.join(" ")} ${isWaiting(data)}`
      : `categories ${hasGaps(data)} ${isWaiting(data)}`;
    const theme = document.documentElement.dataset.theme ?? "";
    if (this.shown_ === key + theme) return;
    this.shown_ = key + theme;
    if (data?.figure) this.scale_(data, figure, start);
    else this.swatches_(hasGaps(data), isWaiting(data));
  }

  private swatches_(gaps: boolean, waits: boolean): void {
    const quiet = ["none", "none (sticks)", "locks"];
    const names = [...quiet, "squeak", "squeal", "creak", "undecided", ...(gaps ? ["failed"] : [])];
    const pale = waits ? h("span", { class: "entry muted" }, "pale: not computed yet") : "";
    this.element.replaceChildren(
      ...names.map((name) => {
        const swatch = h("span", { "class": "swatch", "aria-hidden": "true" });
        paintSwatch(swatch, name);
        return h("span", { class: "entry" }, swatch, name === "failed" ? "no result" : name);
      }),
      pale,
    );
  }

  private scale_(data: ChartData, figure: string, start: Start): void {
    const unit = start.figures.find(({ name }) => name === figure)?.unit ?? "";
    const [low, high] = data.figureRange;
    const bar = h("span", { "class": "scale", "aria-hidden": "true" });
    const stops = Array.from({ length: 11 }, (_, k) => `rgb(${sequential(k / 10).join(" ")})`);
    bar.style.backgroundImage = `linear-gradient(to right, ${stops.join(", ")})`;
    this.element.replaceChildren(
      h(
        "span",
        { class: "entry" },
        `${words(figure)}  ${unit.startsWith("dB") ? low.toFixed(1) : quantity(low, unit)}`,
      ),
      bar,
      h("span", { class: "entry" }, quantity(high, unit)),
      unit.startsWith("dB") ? h("span", { class: "muted" }, "vibration, not sound pressure") : "",
      isWaiting(data) ? h("span", { class: "entry muted" }, "pale: not computed yet") : "",
    );
  }
}

function isWaiting(data: ChartData | null): boolean {
  return data !== null && data.category.some((_, index) => isAwaited(data, index));
}

function hasGaps(data: ChartData | null): boolean {
  return data !== null && data.done && data.category.includes(255);
}
