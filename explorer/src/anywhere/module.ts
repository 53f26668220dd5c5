/** One instance of the core (explorer/core/carrier.cpp): a path and a text in, an answer out, part by part. */

import { bytesOfText, openedIn } from "./opened.ts";

export interface Head {
  status: number;
  type: string;
}

export interface Told {
  head(head: Head): void;
  part(bytes: Uint8Array<ArrayBuffer>): void;
}

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  keep(nameLength: number): void;
  room(length: number): number;
  answer(pathLength: number): void;
  share(pathLength: number, bodyLength: number, helpers: number): void;
  help(pathLength: number, bodyLength: number): void;
}

const noSuchCall = 52; // of WASI: not supported
const nothing = new Uint8Array();
const badDescriptor = 8; // of WASI: no such file

export class Core {
  private told_: Told | null = null;
  private readonly exports_: Exports;

  /** Needs a moment: the module is compiled already. */
  constructor(module: WebAssembly.Module) {
    const wasi: Record<string, (...given: never[]) => number> = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module))
      if (from === "wasi_snapshot_preview1") wasi[name] = () => noSuchCall;
    Object.assign(wasi, {
      clock_time_get: (_id: number, _precision: bigint, at: number) => {
        this.view_().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      fd_write: () => badDescriptor,
      fd_prestat_get: () => badDescriptor,
      environ_sizes_get: (count: number, size: number) => {
        this.view_().setUint32(count, 0, true);
        this.view_().setUint32(size, 0, true);
        return 0;
      },
      environ_get: () => 0,
      proc_exit: (code: number) => {
        throw new Error(`the core ended with ${code}`);
      },
    });
    const page = {
      head: (status: number, at: number, length: number) =>
        this.told_?.head({ status, type: new TextDecoder().decode(this.bytes_(at, length)) }),
      part: (at: number, length: number) => this.told_?.part(this.bytes_(at, length).slice()),
    };
    const instance = new WebAssembly.Instance(module, { page, wasi_snapshot_preview1: wasi });
    this.exports_ = instance.exports as unknown as Exports;
    this.exports_._initialize();
  }

  /** Answers a question; `told` hears it while it is made. */
  ask(path: string, body: string, told: Told): void {
    this.call_(path, body, nothing, told, (pathLength) => this.exports_.answer(pathLength));
  }

  /** Opens a case with the files beside it, as the file of the page holds them (opened.ts). */
  open(text: string, told: Told): void {
    const { toml, files } = openedIn(text);
    for (const [name, content] of Object.entries(files)) this.keep_(name, bytesOfText(content));
    this.ask("/api/open", toml, told);
    this.keep_("", nothing);
  }

  /** Judges a recording by ear. */
  hear(name: string, bytes: Uint8Array, told: Told): void {
    this.keep_(name, bytes);
    this.ask("/api/recording", name, told);
    this.keep_("", nothing);
  }

  /** Keeps a file for the next question; without a name: forgets all. */
  private keep_(name: string, bytes: Uint8Array): void {
    this.call_(name, "", bytes, null, (nameLength) => this.exports_.keep(nameLength));
  }

  /** Answers it by results of helpers alone; a head with status 202 says that some are lacking, a part for each. */
  share(path: string, body: string, results: Uint8Array, helpers: number, told: Told): void {
    this.call_(path, body, results, told, (...lengths) => this.exports_.share(...lengths, helpers));
  }

  /** Computes tasks of somebody's question; the answer are their results. */
  help(path: string, body: string, tasks: Uint8Array, told: Told): void {
    this.call_(path, body, tasks, told, (...lengths) => this.exports_.help(...lengths));
  }

  /** [bytes] that it has taken; they never become fewer. */
  get size(): number {
    return this.exports_.memory.buffer.byteLength;
  }

  private call_(
    path: string,
    body: string,
    rest: Uint8Array,
    told: Told | null,
    call: (pathLength: number, bodyLength: number) => void,
  ): void {
    const [first, second] = [path, body].map((text) => new TextEncoder().encode(text)) as [Uint8Array, Uint8Array];
    const length = first.length + second.length + rest.length;
    const room = this.bytes_(this.exports_.room(length), length);
    room.set(first);
    room.set(second, first.length);
    room.set(rest, first.length + second.length);
    this.told_ = told;
    call(first.length, second.length);
    this.told_ = null;
  }

  private bytes_(at: number, length: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.exports_.memory.buffer as ArrayBuffer, at >>> 0, length);
  }

  private view_(): DataView {
    return new DataView(this.exports_.memory.buffer);
  }
}
