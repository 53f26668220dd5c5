import assert from "node:assert/strict";
import { test } from "node:test";
import { zipOf } from "../zip_writer.mjs";
import { bytesOfText, chosen, openedIn, textOf, withNamedFiles } from "../../../src/anywhere/opened.ts";

const file = (name, content) => new File([content], name);

test("a case and its files come out of the text as they went into it", async () => {
  const bytes = Uint8Array.from({ length: 100_000 }, (_, k) => (k * 7) % 256);
  const opened = await chosen([file("k.mtx", bytes), file("seal.TOML", "title = 'é'\n")]);
  assert.equal(opened.toml, "title = 'é'\n");
  const again = openedIn(textOf(opened));
  assert.deepEqual(again, opened);
  assert.deepEqual(bytesOfText(again.files["k.mtx"]), bytes);
  assert.deepEqual(openedIn(textOf({ toml: "a", files: {} })), { toml: "a", files: {} });
  assert.equal(textOf({ toml: "a", files: {} }), '"a"');
});

test("with a design go the files alone that it still names", () => {
  const files = { "speed.csv": "YQ==", "k.mtx": "Yg==" };
  assert.deepEqual(withNamedFiles({ toml: 'file = "speed.csv"', files }).files, { "speed.csv": "YQ==" });
});

test("a file of pairs beside a case is no second case", async () => {
  const opened = await chosen([file("pairs.toml", "[[pair]]"), file("seal.toml", 'pair = "pairs.toml"')]);
  assert.equal(opened.toml, 'pair = "pairs.toml"');
  assert.deepEqual(Object.keys(opened.files), ["pairs.toml"]);
});

test("an archive of matrices beside a case is unpacked", async () => {
  const archive = zipOf({ "K.npy": "stiff", "M.npy": "heavy" });
  const opened = await chosen([file("part.npz", archive), file("seal.toml", 'stiffness = "folder/part.npz:K"')]);
  const texts = Object.entries(opened.files).map(([name, text]) => [name, Buffer.from(text, "base64").toString()]);
  const wanted = { "part.npz": "PK\x03\x04", "part.npz/K.npy": "stiff", "part.npz/M.npy": "heavy" };
  assert.deepEqual(Object.fromEntries(texts), wanted);
  assert.deepEqual(withNamedFiles(opened), opened);
  const damaged = file("part.npz", archive.subarray(0, 50));
  await assert.rejects(chosen([damaged, file("seal.toml", "")]), {
    message: /part\.npz is no whole zip.*Write it anew/,
  });
  const large = file("part.npz", zipOf({ "K.npy": new Uint8Array(4e6) }));
  await assert.rejects(chosen([large, file("seal.toml", "")]), { message: /too large for the page/ });
});

test("what is no case, or too large, is said in a sentence with a way out", async () => {
  await assert.rejects(chosen([file("a.csv", "1")]), { message: /no case \(\.toml\).*Choose it together/ });
  await assert.rejects(chosen([file("a.toml", "a"), file("b.toml", "b")]), { message: /several cases\. Choose one/ });
  const large = { name: "a.toml", size: 4e6, arrayBuffer: () => assert.fail("it is not read") };
  await assert.rejects(chosen([large]), {
    message: /too large for the page \(3 MB in all, unpacked\).*stridor explore/,
  });
});
