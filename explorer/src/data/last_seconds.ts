/** The last seconds of a sound that goes on: older samples are forgotten. */

const brief = 0.125; // [s] of the level now, as the "fast" of sound level meters
const step = 128; // [1] samples that a browser's audio takes at a time
const compared = 4 * step; // by which what is new is told from what is known

export class LastSeconds {
  private readonly ring_: Float32Array;
  private heard_ = 0; // [1] samples so far

  /**
   * @param rate [Hz]
   * @param seconds how many are held
   */
  constructor(
    private readonly rate: number,
    seconds: number,
  ) {
    this.ring_ = new Float32Array(Math.max(1, Math.floor(rate * seconds)));
  }

  push(samples: Float32Array): void {
    const { length } = this.ring_;
    const news = samples.subarray(Math.max(0, samples.length - length));
    const at = (this.heard_ + samples.length - news.length) % length;
    const first = news.subarray(0, length - at);
    this.ring_.set(first, at);
    this.ring_.set(news.subarray(first.length), 0);
    this.heard_ += samples.length;
  }

  /**
   * Takes what is new among the newest samples of the sound: about `expected`, a few steps more or less, as those tell
   * that are held. Where too much was missed for that, what was missed is left out.
   */
  follow(newest: Float32Array, expected: number): void {
    const known = Math.min(compared, this.heard_);
    const fits = (news: number): boolean => {
      if (news < 0 || news + known > newest.length) return false;
      for (let k = 1; k <= known; ++k) if (newest[newest.length - news - k] !== this.at_(this.heard_ - k)) return false;
      return true;
    };
    const shifts = Array.from({ length: 17 }, (_, k) => (k % 2 ? -step : step) * Math.ceil(k / 2));
    const news = shifts.map((shift) => expected + shift).find(fits) ?? Math.min(expected, newest.length);
    this.push(newest.subarray(newest.length - news));
  }

  /** [s] heard from the beginning on. */
  get heard(): number {
    return this.heard_ / this.rate;
  }

  /** [s] that are held. */
  get held(): number {
    return Math.min(this.heard_, this.ring_.length) / this.rate;
  }

  /** [dB] mean level of the last eighth of a second; 0 is that of a square wave as loud as a sample can be. */
  get level(): number {
    const count = Math.min(this.heard_, this.ring_.length, Math.ceil(brief * this.rate));
    let sum = 0;
    for (let k = this.heard_ - count; k < this.heard_; ++k) sum += this.at_(k) ** 2;
    return count === 0 ? -Infinity : 10 * Math.log10(sum / count);
  }

  /** What is held as a WAV file of 16 bits, oldest first. */
  wav(): Uint8Array<ArrayBuffer> {
    const count = Math.min(this.heard_, this.ring_.length);
    const file = wavHead(count, 1, this.rate, { bytes: 2, kind: 1 });
    const largest = 32767;
    for (let k = 0; k < count; ++k) {
      const sample = Math.max(-1, Math.min(1, this.at_(this.heard_ - count + k)));
      file.setInt16(wavHeadSize + 2 * k, Math.round(largest * sample), true);
    }
    return new Uint8Array(file.buffer);
  }

  private at_(sample: number): number {
    return this.ring_[sample % this.ring_.length] as number;
  }
}

export const wavHeadSize = 44;

/** A WAV file, its samples still zero behind the head; of a `kind`: whole numbers (1) or floating point (3). */
export function wavHead(
  frames: number,
  channels: number,
  rate: number,
  { bytes, kind }: { bytes: number; kind: number },
): DataView<ArrayBuffer> {
  const size = bytes * channels * frames;
  const view = new DataView(new ArrayBuffer(wavHeadSize + size));
  const words = (at: number, text: string): void => [...text].forEach((c, k) => view.setUint8(at + k, c.charCodeAt(0)));
  words(0, "RIFF");
  view.setUint32(4, wavHeadSize - 8 + size, true);
  words(8, "WAVEfmt ");
  view.setUint32(16, 16, true);
  view.setUint16(20, kind, true);
  view.setUint16(22, channels, true);
  view.setUint32(24, rate, true);
  view.setUint32(28, bytes * channels * rate, true);
  view.setUint16(32, bytes * channels, true);
  view.setUint16(34, 8 * bytes, true);
  words(36, "data");
  view.setUint32(40, size, true);
  return view;
}
