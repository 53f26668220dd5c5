import assert from "node:assert/strict";
import { test } from "node:test";
import { bytesOf, fileWithCase } from "../../../src/anywhere/parts.ts";

const begin = '<script type="application/json" id="stridor-case">';

test("a case in the file is text, whatever it says", () => {
  const toml = 'title = "</script><script>alert(1)</script> \\ $& é"';
  for (const before of ["null", '"another \\u003c/script>"']) {
    const file = fileWithCase(`<p>${begin}${before}</script><p>`, toml);
    const inside = file.slice(`<p>${begin}`.length, -"</script><p>".length);
    assert.ok(!inside.includes("<"));
    assert.equal(JSON.parse(inside), toml);
  }
});

test("base64 gives its bytes", () => {
  const bytes = Uint8Array.from({ length: 256 }, (_, k) => k);
  assert.deepEqual(bytesOf(`\n${Buffer.from(bytes).toString("base64")}\n`), bytes);
});
