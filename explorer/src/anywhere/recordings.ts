/** Recordings that were opened in the page: they stand where those of a noise library stand, and stay in this tab. */

const largest = 64e6; // [bytes]
const rate = 48_000; // [Hz] at which the browser decodes what the core does not read

/** What the core reads itself, with the samples that the file has. */
const readByCore = /\.(wav|bwf|rf64|csv|txt|uff|unv|uf|58)$/i;
const known = /\.(wav|bwf|rf64|csv|txt|uff|unv|uf|58|mp3|flac|ogg|oga|opus|m4a|mp4|aac|webm|aif|aiff|caf)$/i;

interface Recording {
  name: string;
  file: Blob;
  bytes: Uint8Array<ArrayBuffer>;
}

export class Recordings {
  private readonly all_: Recording[] = [];

  /** Whether these files are recordings: a table beside a case is none. */
  static are(files: readonly File[]): boolean {
    return files.length > 0 && files.every(({ name, type }) => known.test(name) || type.startsWith("audio/"));
  }

  /** Takes recordings; gives the number of the last. */
  async take(files: readonly File[]): Promise<number> {
    for (const file of files) {
      if (file.size > largest)
        throw new Error(`${file.name} is too large for the page (64 MB). Judge it with stridor classify.`);
      const bytes = new Uint8Array(await file.arrayBuffer());
      this.all_.push({
        name: file.name,
        file,
        bytes: readByCore.test(file.name) ? bytes : await decoded(file.name, bytes),
      });
    }
    return this.all_.length;
  }

  /** That of a number, from 1. */
  at(number: number): Recording | undefined {
    return this.all_[number - 1];
  }
}

/** Sounds that browsers decode, as a WAV file of 32-bit numbers. */
async function decoded(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const context = new OfflineAudioContext(1, 1, rate);
  try {
    return wavOf(await context.decodeAudioData(bytes.slice().buffer));
  } catch {
    throw new Error(
      `${name} is no sound that this browser decodes. Write a WAV file, or judge it with stridor classify.`,
    );
  }
}

export function wavOf(sound: Pick<AudioBuffer, "numberOfChannels" | "length" | "sampleRate" | "getChannelData">) {
  const { numberOfChannels: channels, length, sampleRate } = sound;
  const head = 44;
  const size = 4 * channels * length;
  const view = new DataView(new ArrayBuffer(head + size));
  const words = (at: number, text: string): void => [...text].forEach((c, k) => view.setUint8(at + k, c.charCodeAt(0)));
  words(0, "RIFF");
  view.setUint32(4, head - 8 + size, true);
  words(8, "WAVEfmt ");
  view.setUint32(16, 16, true);
  view.setUint16(20, 3, true); // floating point
  view.setUint16(22, channels, true);
  view.setUint32(24, sampleRate, true);
  view.setUint32(28, 4 * channels * sampleRate, true);
  view.setUint16(32, 4 * channels, true);
  view.setUint16(34, 32, true);
  words(36, "data");
  view.setUint32(40, size, true);
  for (let channel = 0; channel < channels; ++channel) {
    const samples = sound.getChannelData(channel);
    for (let k = 0; k < length; ++k) view.setFloat32(head + 4 * (k * channels + channel), samples[k] as number, true);
  }
  return new Uint8Array(view.buffer);
}
