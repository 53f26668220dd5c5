/** Level over time and frequency as a picture. Painting only. */
import { floatsOf } from "../data/frames.ts";
import type { LevelMap, SoundSegment, Tracks } from "../data/answer_types.ts";
import { paintAxes, type Box } from "./axes.ts";
import { fillOf, sequential, tile } from "./colours.ts";
import { h } from "./dom.ts";
import { plain } from "./format.ts";
import type { Scale } from "../program/words.ts";
import { share } from "./scale.ts";
import { surface, type Surface } from "./surface.ts";
import { onLook, palette } from "./theme.ts";

const span = 70; // [dB] from the darkest to the brightest colour
const pitchColour = "#E62E2E"; // on every colour of the scale
const segmentsHeight = 8; // [px]
const onsetsHeight = 8;

/** What is drawn over a spectrogram and above it. */
export interface Overlay extends Partial<Tracks> {
  segments: SoundSegment[];
}

export class Spectrogram {
  readonly element: HTMLElement;
  private readonly surface_: Surface;
  private picture_: HTMLCanvasElement | null = null;
  private top_ = 0;
  private content_: LevelMap | null = null;
  private overlay_: Overlay | null = null;
  private scale_: Scale = "linear";

  constructor(private readonly name_: string) {
    const canvas = h("canvas", { "role": "img", "aria-label": name_ });
    this.surface_ = surface(canvas, (s) => this.paint_(s));
    this.element = h("div", { class: "stage spectrogram" }, canvas);
    onLook(() => this.surface_.invalidate());
  }

  /** `scale` is that of the frequency; what is laid over is over a linear one. */
  show(content: LevelMap, title = this.name_, overlay: Overlay | null = null, scale: Scale = "linear"): void {
    this.content_ = content;
    this.overlay_ = overlay;
    this.scale_ = scale;
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
    const overlay = this.overlay_;
    const above = overlay ? segmentsHeight + 3 + (overlay.onsets?.length ? onsetsHeight : 0) : 0;
    const box = { left: 66, top: 6 + above, width: width - 66 - 46, height: height - 46 - above };
    if (box.width < 20 || box.height < 20) return;
    pen.imageSmoothingEnabled = true;
    const [t, f] = [reach(content.time), reach(content.frequency)];
    if (this.scale_ === "log") {
      f.from = content.frequency.find((each) => each > 0) ?? 1;
      paintRows(pen, picture, box, content.frequency, f);
    } else {
      pen.drawImage(picture, box.left, box.top, box.width, box.height);
    }
    paintAxes(pen, palette(), box, { title: "time [s]", ...t }, { title: "frequency [Hz]", scale: this.scale_, ...f });
    this.paintScale_(s, box);
    if (overlay) paintOverlay(pen, box, overlay, t, f);
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

interface Reach {
  from: number;
  to: number;
}

// from the first edge to the last one of cells with these middles
function reach(middles: number[]): Reach {
  const [first = 0.5, second = 3 * first] = middles;
  const half = 0.5 * (second - first);
  return { from: first - half, to: (middles.at(-1) ?? first) + half };
}

// each frequency as high as a logarithmic axis has it
function paintRows(
  pen: CanvasRenderingContext2D,
  picture: HTMLCanvasElement,
  box: Box,
  middles: number[],
  { from, to }: Reach,
): void {
  const half = 0.5 * ((middles[1] ?? 1) - (middles[0] ?? 0));
  const y = (frequency: number): number =>
    box.top + box.height * (1 - Math.max(share(Math.max(frequency, from), from, to, "log"), 0));
  middles.forEach((middle, k) => {
    const [top, bottom] = [y(middle + half), y(middle - half)];
    if (bottom <= top) return;
    pen.drawImage(picture, 0, middles.length - 1 - k, picture.width, 1, box.left, top, box.width, bottom - top + 0.5);
  });
}

function paintOverlay(pen: CanvasRenderingContext2D, box: Box, overlay: Overlay, t: Reach, f: Reach): void {
  const x = (time: number): number => box.left + ((time - t.from) / (t.to - t.from)) * box.width;
  const right = box.left + box.width;
  for (const { from, to, category } of overlay.segments) {
    const [begin, end] = [Math.max(x(from), box.left), Math.min(x(to), right)];
    if (end <= begin) continue;
    const fill = fillOf(palette(), category);
    const marks = tile(fill, devicePixelRatio);
    for (const style of [fill.ground, marks && pen.createPattern(marks, "repeat")]) {
      if (!style) continue;
      pen.fillStyle = style;
      pen.fillRect(begin, 6, end - begin, segmentsHeight);
    }
  }
  pen.fillStyle = palette().ink;
  for (const onset of overlay.onsets ?? [])
    if (onset >= t.from && onset <= t.to) pen.fillRect(x(onset) - 0.5, box.top - onsetsHeight, 1, onsetsHeight - 1);
  pen.fillStyle = pitchColour;
  overlay.pitch?.time.forEach((time, k) => {
    const part = ((overlay.pitch?.frequency[k] ?? 0) - f.from) / (f.to - f.from);
    if (time >= t.from && time <= t.to && part <= 1)
      pen.fillRect(x(time) - 1, box.top + (1 - part) * box.height - 1, 2, 2);
  });
}
