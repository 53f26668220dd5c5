// A program of WebAssembly with files, within a browser's page: what WASI asks for, of files in memory.

/**
 * Runs there: all of it is handed over as text. `files` are texts by path below `root`, `program` base64.
 * @returns {Promise<string>} what it printed
 */
export async function runInPage(program, root, files) {
  const bytes = Uint8Array.from(atob(program), (letter) => letter.charCodeAt(0));
  const module = await WebAssembly.compile(bytes);
  const [good, badFile, noFile, noCall] = [0, 8, 44, 52];
  const opened = new Map(); // by descriptor: { bytes, at }
  let [next, printed, memory] = [10, "", null];
  const view = () => new DataView(memory.buffer);
  const text = (at, length) => new TextDecoder().decode(new Uint8Array(memory.buffer, at, length));
  const put = (at, letters) => new Uint8Array(memory.buffer).set(new TextEncoder().encode(letters), at);
  const spans = (at, count) =>
    Array.from({ length: count }, (_, k) => [
      view().getUint32(at + 8 * k, true),
      view().getUint32(at + 8 * k + 4, true),
    ]);
  const stat = (at, kind) => {
    new Uint8Array(memory.buffer, at, 24).fill(0);
    view().setUint8(at, kind);
    view().setBigUint64(at + 8, 0xffffffffffffffffn, true);
    view().setBigUint64(at + 16, 0xffffffffffffffffn, true);
    return good;
  };
  const calls = {
    args_sizes_get(count, size) {
      view().setUint32(count, 1, true);
      view().setUint32(size, 2, true);
      return good;
    },
    args_get(list, at) {
      view().setUint32(list, at, true);
      put(at, "g\0");
      return good;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return good;
    },
    environ_get: () => good,
    clock_time_get(_id, _precision, at) {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return good;
    },
    fd_prestat_get(file, at) {
      if (file !== 3) return badFile;
      view().setUint32(at, 0, true);
      view().setUint32(at + 4, root.length, true);
      return good;
    },
    fd_prestat_dir_name(_file, at) {
      put(at, root);
      return good;
    },
    fd_fdstat_get: (file, at) => stat(at, file === 3 ? 3 : file < 3 ? 2 : 4),
    path_open(_folder, _look, at, length, _flags, _base, _inheriting, _more, into) {
      const content = files[text(at, length)];
      if (content === undefined) return noFile;
      opened.set(next, { bytes: new TextEncoder().encode(content), at: 0 });
      view().setUint32(into, next++, true);
      return good;
    },
    fd_read(file, list, count, read) {
      const from = opened.get(file);
      if (!from) return badFile;
      let sum = 0;
      for (const [at, length] of spans(list, count)) {
        const part = from.bytes.subarray(from.at, from.at + length);
        new Uint8Array(memory.buffer).set(part, at);
        from.at += part.length;
        sum += part.length;
      }
      view().setUint32(read, sum, true);
      return good;
    },
    fd_write(file, list, count, written) {
      let sum = 0;
      for (const [at, length] of spans(list, count)) {
        if (file === 1) printed += text(at, length);
        sum += length;
      }
      view().setUint32(written, sum, true);
      return good;
    },
    fd_close: (file) => (opened.delete(file) ? good : badFile),
    proc_exit(code) {
      throw new Error(`ended with ${code}`);
    },
  };
  const asked = WebAssembly.Module.imports(module).map(({ name }) => [name, calls[name] ?? (() => noCall)]);
  const instance = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: Object.fromEntries(asked) });
  ({ memory } = instance.exports);
  try {
    instance.exports._start();
  } catch (error) {
    if (error.message !== "ended with 0") throw error;
  }
  return printed;
}
