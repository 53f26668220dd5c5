/**
 * Smallest and largest value of any span of samples, fast: a tree of minima and maxima over blocks. A picture made from
 * it keeps every peak, however short, at any zoom. Pure.
 */

const fan = 8; // samples or blocks that make one block of the next level

export interface Pyramid {
  samples: Float32Array;
  levels: { low: Float32Array; high: Float32Array }[]; // of blocks of 8, 64, 512, ... samples
}

export function pyramid(samples: Float32Array): Pyramid {
  const levels: Pyramid["levels"] = [];
  let low = samples;
  let high = samples;
  while (low.length > fan) {
    const count = Math.ceil(low.length / fan);
    const nextLow = new Float32Array(count);
    const nextHigh = new Float32Array(count);
    for (let block = 0; block < count; ++block) {
      const end = Math.min((block + 1) * fan, low.length);
      let smallest = Infinity;
      let largest = -Infinity;
      for (let k = block * fan; k < end; ++k) {
        if ((low[k] as number) < smallest) smallest = low[k] as number;
        if ((high[k] as number) > largest) largest = high[k] as number;
      }
      nextLow[block] = smallest;
      nextHigh[block] = largest;
    }
    levels.push({ low: nextLow, high: nextHigh });
    [low, high] = [nextLow, nextHigh];
  }
  return { samples, levels };
}

/**
 * Smallest and largest of the samples from index `from` up to, without, `to`; [Infinity,
 * -Infinity] if there are none.
 */
export function extremes(tree: Pyramid, from: number, to: number): [number, number] {
  let first = Math.max(0, Math.floor(from));
  let end = Math.min(tree.samples.length, Math.ceil(to));
  let lowest = Infinity;
  let highest = -Infinity;
  let low = tree.samples;
  let high = tree.samples;
  const take = (k: number): void => {
    if ((low[k] as number) < lowest) lowest = low[k] as number;
    if ((high[k] as number) > highest) highest = high[k] as number;
  };
  for (let level = 0; first < end; ++level) {
    const above = tree.levels[level];
    const [firstBlock, endBlock] = [Math.ceil(first / fan), Math.floor(end / fan)];
    if (!above || firstBlock >= endBlock) {
      for (let k = first; k < end; ++k) take(k);
      break;
    }
    for (let k = first; k < firstBlock * fan; ++k) take(k);
    for (let k = endBlock * fan; k < end; ++k) take(k);
    [first, end] = [firstBlock, endBlock];
    [low, high] = [above.low, above.high];
  }
  return [lowest, highest];
}

/** Extremes of equal parts of a span of (fractional) sample indices: low and high, alternating, 2 per part. */
export function columns(tree: Pyramid, from: number, to: number, count: number): Float32Array {
  const result = new Float32Array(2 * count);
  const width = (to - from) / count;
  for (let part = 0; part < count; ++part) {
    const start = from + part * width;
    const [low, high] = extremes(tree, Math.floor(start), Math.max(Math.ceil(start + width), Math.floor(start) + 1));
    result[2 * part] = low;
    result[2 * part + 1] = high;
  }
  return result;
}
