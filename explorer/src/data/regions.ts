/**
 * What a chart's picture needs to know of its areas: where their names fit, and what to paint between
 * computed cells. Pure.
 */

/** The middle of the largest square of one category, in cells from the lower left corner. */
export interface NamePlace {
  d: number; // direction
  category: number;
  x: number;
  y: number;
  cells: number; // side of the square
}

/** For each direction and category the largest square that lies within it. */
export function namePlaces(category: Uint8Array, nx: number, ny: number): NamePlace[] {
  const best = new Map<string, NamePlace>();
  const side = new Uint16Array(category.length); // of the largest square that ends in this cell
  for (let index = 0; index < category.length; ++index) {
    const [ix, iy, d] = [index % nx, Math.floor(index / nx) % ny, Math.floor(index / (nx * ny))];
    const own = category[index] as number;
    const before = [1, nx, nx + 1].map((step) => (category[index - step] === own ? (side[index - step] as number) : 0));
    const cells = ix === 0 || iy === 0 ? 1 : 1 + Math.min(...before);
    side[index] = cells;
    const key = `${d} ${own}`;
    if (cells > (best.get(key)?.cells ?? 0))
      best.set(key, { d, category: own, x: ix + 1 - cells / 2, y: iy + 1 - cells / 2, cells });
  }
  return [...best.values()];
}

/** A figure with the values of computed cells spread over those beside them that were not; within each direction. */
export function spread(figure: Float32Array, computed: Uint8Array | null, nx: number, ny: number): Float32Array {
  const result = figure.slice();
  if (!computed) return result;
  const known = computed.slice();
  let front = [...known.keys()].filter((index) => known[index]);
  while (front.length > 0) {
    const next: number[] = [];
    for (const index of front) {
      const column = index % nx;
      for (const beside of [column > 0 ? index - 1 : -1, column < nx - 1 ? index + 1 : -1, index - nx, index + nx]) {
        const leaves = beside < 0 || Math.floor(beside / (nx * ny)) !== Math.floor(index / (nx * ny));
        if (leaves || known[beside]) continue;
        known[beside] = 1;
        result[beside] = result[index] as number;
        next.push(beside);
      }
    }
    front = next;
  }
  return result;
}
