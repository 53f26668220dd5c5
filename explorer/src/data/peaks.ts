/** The peaks of a spectrum. Pure. */

export interface Peak {
  frequency: number; // [Hz]
  level: number; // [dB]
}

const prominence = 6; // [dB] by which a peak rises above the lowest ground between it and any higher one

/** The highest peaks, the highest first, each where the parabola through three lines has its vertex. */
export function peaksOf(frequency: readonly number[], level: readonly (number | null)[], most: number): Peak[] {
  const at = (k: number): number => level[k] ?? -Infinity;
  const tops = frequency.map((_, k) => k).filter((k) => at(k) > at(k - 1) && at(k) >= at(k + 1));
  const drop = (k: number, step: number): number => {
    let lowest = at(k);
    for (let j = k + step; j >= 0 && j < level.length && at(j) <= at(k); j += step) lowest = Math.min(lowest, at(j));
    return at(k) - lowest;
  };
  return tops
    .filter((k) => drop(k, -1) >= prominence && drop(k, 1) >= prominence)
    .map((k) => vertex(frequency, k, [at(k - 1), at(k), at(k + 1)]))
    .sort((a, b) => b.level - a.level)
    .slice(0, most);
}

function vertex(frequency: readonly number[], k: number, [before, top, after]: [number, number, number]): Peak {
  const part = (before - after) / (2 * (before - 2 * top + after)); // of a line, from -0.5 to 0.5
  const [here = 0, next = here] = [frequency[k], frequency[k + 1]];
  if (!Number.isFinite(part)) return { frequency: here, level: top };
  return { frequency: here + part * (next - here), level: top - ((before - after) * part) / 4 };
}

/** The peak that is nearest to a frequency, in octaves. */
export function nearestPeak(peaks: readonly Peak[], frequency: number): Peak | undefined {
  const far = (peak: Peak): number => Math.abs(Math.log(peak.frequency / frequency));
  return [...peaks].sort((a, b) => far(a) - far(b))[0];
}
