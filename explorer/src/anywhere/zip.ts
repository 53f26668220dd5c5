/** Zip archives as NumPy packs them: files that are stored or deflated (APPNOTE 6.3). */

const listEnd = 0x06054b50; // "PK\5\6"
const listLine = 0x02014b50; // "PK\1\2"
const deflated = 8;
const gzipHead = [0x1f, 0x8b, deflated, 0, 0, 0, 0, 0, 0, 0];

/** Whether bytes begin as an archive does. */
export const isZip = (bytes: Uint8Array): boolean =>
  bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] === 3 && bytes[3] === 4;

/** The files of an archive by name; fails where it is damaged, or grows beyond `most` bytes. */
export async function unzipped(
  bytes: Uint8Array<ArrayBuffer>,
  most: number,
): Promise<Map<string, Uint8Array<ArrayBuffer>>> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let end = bytes.length - 22;
  while (view.getUint32(end, true) !== listEnd) --end; // a remark may stand behind
  let at = view.getUint32(end + 16, true);
  let grown = 0;
  const files = new Map<string, Uint8Array<ArrayBuffer>>();
  for (let left = view.getUint16(end + 10, true); left > 0; --left) {
    const short = (offset: number): number => view.getUint16(at + offset, true);
    const long = (offset: number): number => view.getUint32(at + offset, true);
    if (long(0) !== listLine || short(8) & 1) throw new RangeError("no line of the list, or a password");
    const [method, size] = [short(10), long(24)];
    grown += size;
    if (grown > most) throw new RangeError("too large");
    const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + short(28)));
    const head = long(42);
    const from = head + 30 + view.getUint16(head + 26, true) + view.getUint16(head + 28, true);
    const packed = bytes.subarray(from, from + long(20));
    // with the checksum that the list has of it, the browser finds damage
    const tail = bytes.slice(at + 16, at + 28);
    tail.copyWithin(4, 8);
    const content = method === deflated ? await inflated(packed, tail.subarray(0, 8)) : packed;
    if (content.length !== size || (method !== 0 && method !== deflated)) throw new RangeError("damaged");
    files.set(name, content);
    at += 46 + short(28) + short(30) + short(32);
  }
  return files;
}

/** A deflated text; `tail` is its checksum and its length. */
async function inflated(packed: Uint8Array<ArrayBuffer>, tail: Uint8Array<ArrayBuffer>) {
  const gzip = new Blob([Uint8Array.from(gzipHead), packed, tail]);
  const stream = gzip.stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
