/** What the chart says of the cell under the pointer: what it knows at once, and figures of a run after a rest. */
import * as api from "../data/api.ts";
import { rubbing } from "../data/cases.ts";
import { isAwaited, wordAt, type ChartData } from "../data/chart_data.ts";
import { Latest } from "../data/latest.ts";
import type { Case } from "../data/types.ts";
import { h, setText } from "../draw/dom.ts";
import { level, percent, plain, quantity, words } from "../draw/format.ts";
import { indexOf } from "../draw/map.ts";
import type { Direction } from "../program/words.ts";
import type { Design } from "../state/state.ts";
import { phaseOf } from "./verdict.ts";

const rest = 140; // [ms] of the pointer, before a cell is run

/** A cell of a chart, and the design that it stands for. */
export interface Cell {
  direction: Direction;
  ix: number;
  iy: number;
}

/** What the chart shows now. */
export interface Shown {
  data: ChartData;
  figure: string;
  unit: string; // of the figure
  resolved: Case;
}

export class ChartReadout {
  readonly element = h("p", { id: "chart-readout", class: "readout" });
  private readonly probe_ = new Latest<Cell>((cell, signal) => this.look_(cell, signal));
  private timer_ = 0;

  /** `shown_` is null while there is no chart; `designOf_` while a hand moves a slider. */
  constructor(
    private readonly shown_: () => Shown | null,
    private readonly designOf_: (cell: Cell) => Design | null,
  ) {
    this.rest();
  }

  rest(): void {
    this.cancel_();
    setText(this.element, "Click a cell to run it, drag a rectangle to zoom; arrow keys move the cell.");
  }

  read(cell: Cell): void {
    this.cancel_();
    const shown = this.shown_();
    if (!shown) return this.rest();
    setText(this.element, cellText(shown, cell));
    this.timer_ = window.setTimeout(() => this.probe_.askNow(cell), rest);
  }

  private cancel_(): void {
    clearTimeout(this.timer_);
    this.probe_.cancel();
  }

  private async look_(cell: Cell, signal: AbortSignal): Promise<void> {
    const shown = this.shown_();
    const design = this.designOf_(cell);
    if (!shown || !design) return;
    try {
      const simulation = await api.simulate(design, signal);
      const phase = phaseOf(simulation, cell.direction);
      if (!phase || signal.aborted) return;
      const { judged_rates: shares, frequency, regularity, levels } = phase.verdict;
      const figures = [
        `slip ${percent(shares.slip)} stick ${percent(shares.stick)} separation ${percent(shares.separation)}`,
        frequency ? quantity(frequency, "Hz") : "",
        regularity === null ? "" : `regularity ${plain(regularity, 3)}`,
        `${rubbing(shown.resolved)} ${level(levels.joint.level)} re 1 nm/s`,
      ];
      setText(this.element, [cellText(shown, cell), ...figures].filter(Boolean).join(" · "));
    } catch (error) {
      if (!api.isAbort(error)) setText(this.element, api.sentence(error));
    }
  }
}

function cellText({ data, figure, unit }: Shown, { direction, ix, iy }: Cell): string {
  const index = indexOf(data, direction, ix, iy);
  const part = (axis: ChartData["x"], i: number): string =>
    `${words(axis.parameter)} ${quantity(axis.values[i], axis.unit)}`;
  const where = [direction, part(data.x, ix), part(data.y, iy)];
  const category = wordAt(data, index);
  if (isAwaited(data, index)) return [...where, category].join(" · ");
  const value = data.figure ? `${words(figure)} ${quantity(data.figure[index], unit)}` : "";
  const source = data.computed ? (data.computed[index] ? "" : "inferred") : "";
  return [...where, category, value, source].filter(Boolean).join(" · ");
}
