import assert from "node:assert/strict";
import { test } from "node:test";
import { isZip, unzipped } from "../../../src/anywhere/zip.ts";
import { random } from "../random.mjs";
import { zipOf } from "../zip_writer.mjs";

const much = 1e6; // [bytes]
const number = random(3);
const files = {
  "empty.npy": "",
  "text.npy": "squeak ".repeat(3000),
  "noise.npy": Uint8Array.from({ length: 5000 }, () => Math.floor(number() * 256)),
};
const bytesOf = (buffer) => Uint8Array.from(buffer);

for (const deflated of [true, false])
  test(`an archive of ${deflated ? "deflated" : "stored"} files gives them back`, async () => {
    for (const remark of ["", "by hand"]) {
      const archive = bytesOf(zipOf(files, { deflated, remark }));
      assert.ok(isZip(archive));
      const found = await unzipped(archive, much);
      assert.deepEqual([...found.keys()], Object.keys(files));
      for (const [name, content] of found) assert.ok(Buffer.from(content).equals(Buffer.from(files[name])), name);
    }
  });

test("an archive that is damaged anywhere gives what was packed, or fails", async () => {
  const whole = bytesOf(zipOf(files));
  const said = Object.values(files).map((content) => Buffer.from(content));
  let failed = 0;
  for (let turn = 0; turn < 300; ++turn) {
    const damaged = whole.slice();
    damaged[Math.floor(number() * damaged.length)] ^= 1 << Math.floor(number() * 8);
    try {
      const found = [...(await unzipped(damaged, much)).values()];
      assert.equal(found.length, said.length);
      assert.ok(found.every((content, k) => said[k].equals(Buffer.from(content))));
    } catch (error) {
      assert.ok(!(error instanceof assert.AssertionError), error);
      ++failed;
    }
  }
  assert.ok(failed > 200, `${failed}`);
  for (const length of [0, 3, 21, 200, whole.length - 1])
    await assert.rejects(unzipped(whole.slice(0, length), much), { name: "RangeError" });
});

test("an archive that grows too much, or is locked, is not unpacked", async () => {
  const bomb = bytesOf(zipOf({ "zeros.npy": new Uint8Array(2 * much) }));
  assert.ok(bomb.length < much / 100);
  await assert.rejects(unzipped(bomb, much), { message: "too large" });
  // one that lies about its size
  const size = new DataView(bomb.buffer);
  const line = Buffer.from(bomb).indexOf("PK\x01\x02");
  size.setUint32(line + 24, 10, true);
  await assert.rejects(unzipped(bomb, much));
  await assert.rejects(unzipped(bytesOf(zipOf(files, { flags: 1 })), much), { name: "RangeError" });
});
