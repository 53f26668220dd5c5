// The microphone of the page that a program serves. A browser hears a file in its place.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { scratchFolder } from "../scratch.mjs";
import { deaf, expectHeard, expectUnheard, hearing, refusing, writeSqueal } from "./hearing.mjs";
import { openPage, startExplorer } from "./session.mjs";

const folder = scratchFolder();
let explorer;

before(async () => {
  explorer = await startExplorer();
});

after(async () => {
  assert.equal(await explorer?.stop(), 0);
});

async function listening(t, switches) {
  const browser = await openPage(explorer, { switches });
  t.after(() => browser.close());
  await browser.goto("#view=listen");
  return browser;
}

test("a microphone is judged while it is heard", { timeout: 300_000 }, async (t) => {
  const squeal = join(folder, "squeal.wav");
  await writeSqueal(squeal);
  const { page, sins } = await listening(t, hearing(squeal));
  const sizes = [];
  page.on("request", (request) => {
    if (request.url().endsWith("/api/recording")) sizes.push(request.postDataBuffer()?.length ?? 0);
  });
  await expectHeard(page, process.env.STRIDOR_PICTURE);
  assert.ok(sizes.length >= 5 && Math.max(...sizes) < 2 ** 20, `${sizes}`);
  assert.deepEqual(sins, []);
});

test("a microphone that is refused, or is none, leaves a sentence", { timeout: 300_000 }, async (t) => {
  const refused = await listening(t, refusing);
  await expectUnheard(refused.page, /The microphone was refused .*Allow it beside the page's address/);
  assert.deepEqual(refused.sins, []);
  const none = await listening(t, deaf);
  await expectUnheard(none.page, /There is no microphone\. Plug one in/);
  assert.deepEqual(none.sins, []);
});
