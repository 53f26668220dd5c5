/** Ways out of the page: link, command, TOML, picture, table, report. */
import * as api from "../data/api.ts";
import { hasStructure } from "../data/cases.ts";
import { isAwaited, type ChartData } from "../data/chart_data.ts";
import { oneFile } from "../data/carrier.ts";
import type { Start } from "../data/types.ts";
import { categoryAndQuiet, light } from "../draw/colours.ts";
import { button, download, h, setText } from "../draw/dom.ts";
import { plotBox } from "../draw/map.ts";
import type { Surface } from "../draw/surface.ts";
import { hasAddress, visit } from "../state/place.ts";
import { command, longestFragment, ownPreset, toFragment, type Axis, type Design } from "../state/state.ts";
import type { Store } from "../state/store.ts";
import type { Chart } from "./chart.ts";

export class Share {
  readonly element: HTMLElement;
  private readonly paste_ = h("input", {
    type: "text",
    id: "paste-link",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: "http://…/#preset=…",
  });
  private readonly file_ = h("input", {
    type: "file",
    id: "open-case",
    multiple: true,
    title: "With the files that it names",
  });
  private readonly note_ = h("p", { class: "note", role: "status", id: "share-note" });

  constructor(
    private readonly store_: Store,
    private readonly start_: Start,
    private readonly chart_: Chart,
  ) {
    const entry = (label: string, id: string, hint: string, action: () => Promise<string> | string): HTMLElement =>
      button(label, () => void this.run_(action), { id, title: hint });
    this.element = h(
      "div",
      {},
      ...(hasAddress
        ? [
            entry(
              "Copy link",
              "copy-link",
              "All of the page, with every number of the case; it opens on any machine with Stridor",
              () => this.link_(),
            ),
          ]
        : []),
      entry("Copy as command", "copy-command", "It simulates this design", async () =>
        this.copy_(await this.command_(), "command"),
      ),
      entry("Copy as TOML", "copy-toml", "The design as a case file", async () =>
        this.copy_(await api.toml(store_.state.design, null), "case file"),
      ),
      entry("Copy chart as TOML", "copy-chart-toml", "The chart as a file for stridor chart", async () =>
        this.copy_(await api.toml(store_.state.design, this.axes_()), "chart file"),
      ),
      entry("Chart as PNG", "save-png", "Light, twice the screen's size", () => this.png_()),
      entry("Chart as CSV", "save-csv", "Its cells as a table", () => this.csv_()),
      ...(oneFile()
        ? [
            entry("Save this page", "save-page", "This file with the design in it; it opens anywhere", () =>
              this.page_(),
            ),
            ...(hasAddress ? [h("label", { class: "paste" }, "Open a case or recording", this.file_)] : []),
            h("p", { class: "note" }, "Reports, noise libraries and PDF need the program."),
          ]
        : [entry("Report", "save-report", "One file that opens without Stridor", async () => this.report_())]),
      h("label", { class: "paste" }, "Open a link", this.paste_),
      this.note_,
    );
    this.file_.addEventListener("change", () => void this.run_(() => this.openFile_()));
    this.paste_.addEventListener("change", () => void this.run_(() => this.open_(this.paste_.value.trim())));
  }

  /** A design that leans on no file of this machine. */
  private async whole_(design: Design): Promise<Design> {
    return design.preset === ownPreset ? api.share(design) : design;
  }

  private async link_(): Promise<string> {
    const { state } = this.store_;
    const { other } = state;
    const kept = other && "design" in other ? { ...other, design: await this.whole_(other.design) } : null;
    const fragment = toFragment({ ...state, design: await this.whole_(state.design), other: kept });
    if (fragment.length > longestFragment) throw Error("This is too long for a link. Copy it as TOML.");
    const place = oneFile() ? location.href.replace(/#.*/s, "") : `${location.origin}/`;
    const said = await this.copy_(`${place}#${fragment}`, "link");
    return `${said} Elsewhere: stridor explore 'LINK'.${other && !kept ? " The recording beside it stays here." : ""}`;
  }

  private open_(link: string): string {
    const fragment = link.slice(link.indexOf("#"));
    if (!/^#(.*&)?preset=/.test(fragment)) throw Error("This is no link that the page made.");
    if (fragment.length > longestFragment) throw Error("This link is too long.");
    visit(fragment);
    this.paste_.value = "";
    return "";
  }

  private async openFile_(): Promise<string> {
    await oneFile()?.open([...(this.file_.files ?? [])]);
    return "";
  }

  private async page_(): Promise<string> {
    const toml = await api.toml(this.store_.state.design, this.axes_());
    const file = oneFile()?.saved(toml);
    if (file) download("stridor.html", new Blob([file], { type: "text/html" }));
    return "stridor.html";
  }

  private axes_(): { x: Axis; y: Axis; refine: number } {
    const { x, y } = this.store_.state;
    return { x, y, refine: this.start_.chart.refine };
  }

  private async run_(action: () => Promise<string> | string): Promise<void> {
    try {
      setText(this.note_, "…");
      setText(this.note_, await action());
    } catch (error) {
      setText(this.note_, api.sentence(error));
    }
  }

  private async copy_(text: string, what: string): Promise<string> {
    await navigator.clipboard.writeText(text);
    this.note_.dataset.copied = text;
    return `The ${what} is in the clipboard.`;
  }

  private async png_(): Promise<string> {
    const canvas = paintPicture(this.chart_);
    if (!canvas) return "There is no chart yet.";
    const blob = await new Promise<Blob | null>((take) => canvas.toBlob(take, "image/png"));
    if (blob) download("noise-chart.png", blob);
    return "noise-chart.png";
  }

  private async csv_(): Promise<string> {
    const data = this.chart_.current;
    if (!data) return "There is no chart yet.";
    download(
      "noise-chart.csv",
      new Blob([table(data, this.store_.state.figure, await this.header_())], { type: "text/csv" }),
    );
    return "noise-chart.csv";
  }

  private async report_(): Promise<string> {
    setText(this.note_, "Writing the report …");
    download("stridor-report.html", await api.report(this.store_.state.design, this.axes_()));
    return "stridor-report.html";
  }

  private async header_(): Promise<string[]> {
    return [`program: stridor ${this.start_.version}`, `reproduce: ${await this.command_()}`];
  }

  /** A link may say anything; only what the program knows goes into a command. */
  private async command_(): Promise<string> {
    const { design } = this.store_.state;
    const preset = this.start_.presets.find((one) => one.name === design.preset);
    if (!preset) throw Error("no preset " + design.preset);
    const { drive } = preset.case;
    const isOfFile = hasStructure(preset.case) || (typeof drive === "object" && "file" in drive);
    return command(isOfFile ? design : await this.whole_(design));
  }
}

/** Both directions side by side in the colours of figures, at twice the screen's size. */
function paintPicture(chart: Chart): HTMLCanvasElement | null {
  if (!chart.current) return null;
  const [ratio, width, height] = [2, 560, 420];
  const canvas = h("canvas", { width: 2 * width * ratio, height: height * ratio });
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  pen.fillStyle = "#FFFFFF";
  pen.fillRect(0, 0, canvas.width, canvas.height);
  (["going", "coming"] as const).forEach((direction, k) => {
    pen.setTransform(ratio, 0, 0, ratio, k * width * ratio, 0);
    const surface = { canvas, pen, width, height, ratio, invalidate: () => {}, draw: () => {} } satisfies Surface;
    const onPage = chart.lookOf(direction);
    const look = { ...onPage, title: onPage.title + chart.caption(), palette: light, chosen: false };
    if (plotBox(surface, look).width > 0) chart.paintOn(surface, direction, look);
  });
  return canvas;
}

/** The cells of a chart, direction slowest and x fastest, as `stridor chart` writes them. */
export function table(data: ChartData, figure: string, header: readonly string[]): string {
  const drawn = data.figure ? [figure] : [];
  const lines = [
    "# " + [...header, `x: ${data.x.parameter}`, `y: ${data.y.parameter}`].join(" | "),
    [`x [${data.x.unit}]`, `y [${data.y.unit}]`, "direction", "category", "quiet_because", "source", ...drawn]
      .join(",")
      .replaceAll(" [1]", ""),
  ];
  data.directions.forEach((direction, d) => {
    data.y.values.forEach((y, iy) => {
      data.x.values.forEach((x, ix) => {
        const index = (d * data.y.points + iy) * data.x.points + ix;
        const awaited = isAwaited(data, index);
        const [category, quiet] = awaited ? ["", ""] : categoryAndQuiet(data.category[index] as number);
        const known = data.computed ? (data.computed[index] ? "computed" : "inferred") : "";
        const source = awaited ? "not_computed" : known;
        const value = awaited && data.figure ? NaN : data.figure?.[index];
        const shown = value === undefined ? [] : [Number.isFinite(value) ? String(value) : ""];
        lines.push([x, y, direction, category, quiet, source, ...shown].join(","));
      });
    });
  });
  return lines.join("\n") + "\n";
}
