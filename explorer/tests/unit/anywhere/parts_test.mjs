import assert from "node:assert/strict";
import { test } from "node:test";
import { bytesOf, fileWithCase } from "../../../src/anywhere/parts.ts";

const begin = '<script type="application/json" id="stridor-case">';

test("a case in the file is text, whatever it says", () => {
  const toml = 'title = "</script><script>alert(1)</script> \\ $& é €"';
  for (const before of ["null", '"another \\u003c/script>"']) {
    const file = fileWithCase(`<p>é${begin}${before}</script><p>`, JSON.stringify(toml));
    assert.equal(file[3], 0xe9, "a letter of the file stays its byte");
    const text = Buffer.from(file).toString("latin1");
    const inside = text.slice(`<p>é${begin}`.length, -"</script><p>".length);
    assert.match(inside, /^[ -;=-~]*$/);
    assert.equal(JSON.parse(inside), toml);
  }
});

test("the answers of another case do not stay in the file", () => {
  const file = `${begin}null</script><script type="text/plain" id="stridor-first" data-commit="a">=@x</script><p>`;
  const text = Buffer.from(fileWithCase(file, '"title = 1"')).toString("latin1");
  assert.equal(text, file.replace("null", '"title = 1"').replace("=@x", ""));
});

test("bytes come out of the letters of a page", () => {
  const bytes = Uint8Array.from({ length: 256 }, (_, k) => k);
  const escaped = [...bytes].flatMap((byte) => ([0, 13, 60, 61].includes(byte) ? [61, byte + 64] : [byte]));
  const letters = new TextDecoder("windows-1252").decode(Uint8Array.from(escaped));
  assert.deepEqual(bytesOf(letters), bytes);
});
