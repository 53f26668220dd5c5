/** Recordings that were opened in the page: they stand where those of a noise library stand, and stay in this tab. */
import { wavHead, wavHeadSize } from "../data/last_seconds.ts";

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

/** As a WAV file of 32-bit numbers. */
function wavOf(sound: AudioBuffer): Uint8Array<ArrayBuffer> {
  const { numberOfChannels: channels, length, sampleRate } = sound;
  const view = wavHead(length, channels, sampleRate, { bytes: 4, kind: 3 });
  for (let channel = 0; channel < channels; ++channel) {
    const samples = sound.getChannelData(channel);
    for (let k = 0; k < length; ++k)
      view.setFloat32(wavHeadSize + 4 * (k * channels + channel), samples[k] as number, true);
  }
  return new Uint8Array(view.buffer);
}
