/** Level over time and frequency as a picture. Painting only. */
import { floatsOf } from "../data/frames.ts";
import type { Analysis } from "../data/answer_types.ts";
import { paintAxes } from "./axes.ts";
import { sequential } from "./colours.ts";
import { h } from "./dom.ts";
import { plain } from "./format.ts";
import { surface, type Surface } from "./surface.ts";
import { onTheme, palette } from "./theme.ts";

const span = 70; // [dB] from the darkest to the brightest colour

export class Spectrogram {
  readonly element: HTMLElement;
  private readonly surface_: Surface;
  private picture_: HTMLCanvasElement | null = null;
  private top_ = 0;
  private content_: Analysis["spectrogram"] | null = null;

  constructor(private readonly name_: string) {
    const canvas = h("canvas", { "role": "img", "aria-label": name_ });
    this.surface_ = surface(canvas, (s) => this.paint_(s));
    this.element = h("div", { class: "stage spectrogram" }, canvas);
    onTheme(() => this.surface_.invalidate());
  }

  show(content: Analysis["spectrogram"], title = this.name_): void {
    this.content_ = content;
    this.surface_.canvas.setAttribute(
      "aria-label",
      `${title}: spectrogram up to ${plain(content.frequency.at(-1) ?? 0)} Hz`,
    );
    const level = floatsOf(content.level);
    this.top_ = -Infinity;
    for (const value of level) if (Number.isFinite(value) && value > this.top_) this.top_ = value;
    this.top_ = 10 * Math.ceil(this.top_ / 10);
    const { rows, columns } = content;
    if (rows < 1 || columns < 1) return;
    const image = new ImageData(rows, columns);
    for (let row = 0; row < rows; ++row)
      for (let column = 0; column < columns; ++column) {
        const value = level[row * columns + column] as number;
        const part = Number.isFinite(value) ? 1 + (value - this.top_) / span : 0;
        image.data.set([...sequential(part), 255], 4 * ((columns - 1 - column) * rows + row));
      }
    this.picture_ = h("canvas", { width: rows, height: columns });
    (this.picture_.getContext("2d") as CanvasRenderingContext2D).putImageData(image, 0, 0);
    this.surface_.invalidate();
  }

  private paint_(s: Surface): void {
    const { content_: content, picture_: picture } = this;
    if (!content || !picture) return;
    const { pen, width, height } = s;
    const box = { left: 66, top: 6, width: width - 66 - 46, height: height - 46 };
    if (box.width < 20 || box.height < 20) return;
    pen.imageSmoothingEnabled = true;
    pen.drawImage(picture, box.left, box.top, box.width, box.height);
    const [t, f] = [content.time, content.frequency];
    paintAxes(
      pen,
      palette(),
      box,
      { title: "time [s]", from: t[0] ?? 0, to: t.at(-1) ?? 1 },
      { title: "frequency [Hz]", from: f[0] ?? 0, to: f.at(-1) ?? 1 },
    );
    this.paintScale_(s, box);
  }

  private paintScale_(s: Surface, box: { top: number; height: number }): void {
    const { pen, width } = s;
    const left = width - 38;
    for (let k = 0; k < box.height; ++k) {
      pen.fillStyle = `rgb(${sequential(1 - k / box.height).join(" ")})`;
      pen.fillRect(left, box.top + k, 8, 1.5);
    }
    pen.fillStyle = palette().muted;
    pen.textAlign = "left";
    pen.textBaseline = "middle";
    for (const drop of [0, 20, 40, 60])
      pen.fillText(plain(this.top_ - drop, 3), left + 11, box.top + 6 + ((box.height - 6) * drop) / span);
  }
}
