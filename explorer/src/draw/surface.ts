/** A canvas that fills its box at the screen's own resolution and is redrawn once per frame at most. */

export interface Surface {
  canvas: HTMLCanvasElement;
  pen: CanvasRenderingContext2D;
  width: number; // [CSS px]
  height: number;
  ratio: number; // device pixels per CSS px
  /** Draws in the next frame. */
  invalidate(): void;
  /** Draws now. */
  draw(): void;
}

export const font = (size: number, weight = 400): string =>
  `${weight} ${size}px system-ui, -apple-system, "Segoe UI", "Liberation Sans", "DejaVu Sans", sans-serif`;

/** @param paint draws on a cleared surface, in CSS px */
export function surface(canvas: HTMLCanvasElement, paint: (surface: Surface) => void): Surface {
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  let pending = 0;
  const self: Surface = {
    canvas,
    pen,
    width: 0,
    height: 0,
    ratio: 1,
    invalidate: () => {
      if (!pending) pending = requestAnimationFrame(self.draw);
    },
    draw: () => {
      cancelAnimationFrame(pending);
      pending = 0;
      if (self.width < 2 || self.height < 2) return;
      pen.setTransform(self.ratio, 0, 0, self.ratio, 0, 0);
      pen.clearRect(0, 0, self.width, self.height);
      paint(self);
    },
  };
  const fit = (): void => {
    const box = canvas.getBoundingClientRect();
    self.ratio = devicePixelRatio || 1;
    self.width = Math.round(box.width);
    self.height = Math.round(box.height);
    canvas.width = Math.round(self.width * self.ratio);
    canvas.height = Math.round(self.height * self.ratio);
    self.draw();
  };
  new ResizeObserver(fit).observe(canvas);
  return self;
}
