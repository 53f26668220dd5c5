// Zip archives and arrays of NumPy for tests, written by code of their own (APPNOTE 6.3, NEP 1).
import { crc32 as summed, deflateRawSync } from "node:zlib";

/** As in zlib, which node has had since version 20.15. */
function crc32(bytes) {
  if (summed) return summed(bytes);
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

/** An archive of files (bytes or text by name), deflated or stored. */
export function zipOf(files, { deflated = true, flags = 0, remark = "" } = {}) {
  const [bodies, list] = [[], []];
  let at = 0;
  for (const [name, content] of Object.entries(files)) {
    const bytes = Buffer.from(content);
    const packed = deflated ? deflateRawSync(bytes) : bytes;
    const facts = Buffer.alloc(26);
    facts.writeUInt16LE(20, 0);
    facts.writeUInt16LE(flags, 2);
    facts.writeUInt16LE(deflated ? 8 : 0, 4);
    facts.writeUInt32LE(crc32(bytes), 10);
    facts.writeUInt32LE(packed.length, 14);
    facts.writeUInt32LE(bytes.length, 18);
    facts.writeUInt16LE(Buffer.byteLength(name), 22);
    const place = Buffer.alloc(14);
    place.writeUInt32LE(at, 10);
    list.push(Buffer.from("PK\x01\x02\x14\x00"), facts, place, Buffer.from(name));
    bodies.push(Buffer.from("PK\x03\x04"), facts, Buffer.from(name), packed);
    at = Buffer.concat(bodies).length;
  }
  const end = Buffer.alloc(18);
  const count = Object.keys(files).length;
  end.writeUInt16LE(count, 4);
  end.writeUInt16LE(count, 6);
  end.writeUInt32LE(Buffer.concat(list).length, 8);
  end.writeUInt32LE(at, 12);
  end.writeUInt16LE(remark.length, 16);
  return Buffer.concat([...bodies, ...list, Buffer.from("PK\x05\x06"), end, Buffer.from(remark)]);
}

/** A .npy of a text (kind "S"), of whole numbers ("i4", "i8") or of reals ("f8"); `shape` as Python writes it. */
export function npyOf(kind, shape, values) {
  const head = `{'descr': '${kind[0] === "S" ? "|" : "<"}${kind}', 'fortran_order': False, 'shape': ${shape}, }`;
  const padded = head.padEnd(117) + "\n";
  const bytes = {
    S: () => Buffer.from(values),
    i: () => Buffer.from((kind === "i4" ? Int32Array.from(values) : BigInt64Array.from(values, BigInt)).buffer),
    f: () => Buffer.from(Float64Array.from(values).buffer),
  }[kind[0]]();
  return Buffer.concat([Buffer.from("\x93NUMPY\x01\x00\x76\x00", "latin1"), Buffer.from(padded), bytes]);
}
