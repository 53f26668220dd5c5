import assert from "node:assert/strict";
import { test } from "node:test";
import { Latest } from "../../../src/data/latest.ts";
import { until } from "../../until.mjs";

const settle = () => new Promise((done) => setImmediate(done));

/** Work that ends when told to; says what was started and what was aborted. */
function bench(patience) {
  const log = [];
  const open = [];
  const latest = new Latest((wish, signal, shown) => {
    log.push(`start ${wish}`);
    return new Promise((done) => {
      open.push({ done, shown });
      signal.addEventListener("abort", () => {
        log.push(`abort ${wish}`);
        done();
      });
    });
  }, patience);
  return { latest, log, open };
}

test("at most one is in flight, and the newest wish wins", async () => {
  const { latest, log, open } = bench(0);
  latest.ask(1);
  latest.ask(2);
  latest.ask(3);
  assert.deepEqual(log, ["start 1"]);
  open[0].done();
  await settle();
  assert.deepEqual(log, ["start 1", "start 3"]);
});

test("however fast wishes come, each that starts shows something", async () => {
  const { latest, log, open } = bench(0);
  for (let wish = 1; wish <= 100; ++wish) latest.ask(wish);
  assert.deepEqual(log, ["start 1"]);
  open[0].shown();
  await settle();
  assert.deepEqual(log, ["start 1", "abort 1", "start 100"]);
});

test("what has shown something has its time, then gives way", async () => {
  const { latest, log, open } = bench(40);
  latest.ask(1);
  open[0].shown();
  latest.ask(2);
  await settle();
  assert.deepEqual(log, ["start 1"]);
  await until(() => log.length > 1, "the first to give way");
  await settle();
  assert.deepEqual(log, ["start 1", "abort 1", "start 2"]);
});

test("a wish that must be now aborts the one before", async () => {
  const { latest, log } = bench(1e9);
  latest.ask(1);
  latest.askNow(2);
  await settle();
  assert.deepEqual(log, ["start 1", "abort 1", "start 2"]);
});

test("what is cancelled neither goes on nor is followed", async () => {
  const { latest, log } = bench(0);
  latest.ask(1);
  latest.ask(2);
  latest.cancel();
  await settle();
  assert.deepEqual(log, ["start 1", "abort 1"]);
});

test("what shows something when nothing waits goes on", async () => {
  const { latest, log, open } = bench(0);
  latest.ask(1);
  open[0].shown();
  await settle();
  assert.deepEqual(log, ["start 1"]);
});
