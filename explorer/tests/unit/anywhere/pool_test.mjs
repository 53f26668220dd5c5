import assert from "node:assert/strict";
import { test } from "node:test";
import { Pool } from "../../../src/anywhere/pool.ts";

/** A worker that answers as it is told; `made` holds all there are. */
function fakes(answer) {
  const made = [];
  class Fake {
    ended = false;
    constructor() {
      made.push(this);
    }
    postMessage(letter) {
      if ("module" in letter) return;
      for (const each of answer(letter, this)) queueMicrotask(() => this.ended || this.onmessage?.({ data: each }));
    }
    terminate() {
      this.ended = true;
    }
  }
  return { made, make: () => new Fake() };
}

const bytes = (text) => new TextEncoder().encode(text);
const head = (status = 200) => ({ kind: "head", status, type: "text/plain" });
const part = (text) => ({ kind: "part", bytes: bytes(text) });
const end = (size = 1e6) => ({ kind: "end", size });
const begin = { module: null, opened: null };

function begun(make, most) {
  const pool = new Pool(make, most);
  pool.begin(begin);
  return pool;
}

test("an answer comes as fetch gives it, part by part", async () => {
  const { make } = fakes(({ path, body }) => [head(400), part(path), part(body), end()]);
  const pool = begun(make, 2);
  const response = await pool.carry("/api/toml", { body: "{}" });
  assert.equal(response.status, 400);
  assert.equal(response.headers.get("content-type"), "text/plain");
  assert.equal(await response.text(), "/api/toml{}");
});

test("no more workers than there may be have a question at a time", async () => {
  const open = [];
  const { made, make } = fakes((_letter, worker) => (open.push(worker), []));
  const pool = begun(make, 3);
  const answers = [1, 2, 3, 4, 5].map((k) => pool.carry(`/${k}`, {}));
  assert.equal(open.length, 3);
  for (let k = 0; k < 5; ++k) {
    open[k].onmessage({ data: head() });
    open[k].onmessage({ data: end() });
  }
  await Promise.all(answers);
  assert.ok(made.filter(({ ended }) => !ended).length <= 3);
});

test("a question that is taken back ends its worker, and a waiting one never gets one", async () => {
  const { made, make } = fakes(() => [head()]);
  const pool = begun(make, 1);
  const [first, second] = [new AbortController(), new AbortController()];
  const one = await pool.carry("/1", { signal: first.signal });
  const other = pool.carry("/2", { signal: second.signal });
  second.abort();
  await assert.rejects(other, { name: "AbortError" });
  first.abort();
  await assert.rejects(one.text(), { name: "AbortError" });
  assert.equal(made[0].ended, true);
  await assert.rejects(pool.carry("/3", { signal: AbortSignal.abort() }), { name: "AbortError" });
  assert.equal(await (await pool.carry("/4", {})).status, 200);
});

test("a worker that has taken much memory is ended after its answer", async () => {
  const { made, make } = fakes(() => [head(), end(2e8)]);
  const pool = begun(make, 1);
  for (let k = 0; k < 3; ++k) await (await pool.carry("/api/motion", {})).text();
  assert.deepEqual(
    made.slice(0, 3).map(({ ended }) => ended),
    [true, true, true],
  );
});

test("a worker that fails fails its question alone", async () => {
  const { make } = fakes(({ path }) =>
    path === "/bad" ? [{ kind: "failed", why: "unreachable", lacksMemory: false }] : [head(), end()],
  );
  const pool = begun(make, 2);
  await assert.rejects(pool.carry("/bad", {}), { name: "TypeError", message: "unreachable" });
  assert.equal((await pool.carry("/good", {})).status, 200);
});

test("a chart is computed by helpers until nothing is lacking, and no line of it comes twice", async () => {
  const text = (array) => new TextDecoder().decode(array);
  const helped = [];
  const { make } = fakes(({ shared, tasks }) => {
    if (tasks) {
      helped.push(text(tasks));
      return [head(), part(`<${text(tasks)}>`), end()];
    }
    const results = text(shared.results);
    if (results === "") return [head(), head(202), part("a"), part("b"), end()];
    if (results === "<a><b>") return [head(), part("0\n"), head(202), part("c"), end()];
    assert.equal(results, "<a><b><c>");
    return [head(), part("0\n"), part("1\n"), part("done\n"), end()];
  });
  const pool = begun(make, 4);
  const response = await pool.carry("/api/chart", { body: "{}" });
  assert.equal(await response.text(), "0\ndone\n");
  assert.deepEqual(helped.sort(), ["a", "b", "c"]);
});

test("a refused chart is refused with its status", async () => {
  const { make } = fakes(() => [head(400), part("no"), end()]);
  const response = await begun(make, 8).carry("/api/chart", { body: "{}" });
  assert.equal(response.status, 400);
  assert.equal(await response.text(), "no");
});

test("a worker without memory, and a browser without workers, are told in words", async () => {
  const { make } = fakes(() => [{ kind: "failed", why: "Out of memory", lacksMemory: true }]);
  await assert.rejects(begun(make, 1).carry("/api/motion", {}), { name: "Error", message: /no more memory/ });
  const silent = fakes((_letter, worker) => (queueMicrotask(() => worker.onerror({})), []));
  await assert.rejects(begun(silent.make, 1).carry("/api/motion", {}), { message: /runs no workers/ });
});

test("a worker that fails before it is asked is asked no more", async () => {
  const dead = new Set();
  const { made, make } = fakes((_letter, worker) => (dead.has(worker) ? [] : [head(), part("a"), end()]));
  const pool = begun(make, 2);
  await (await pool.carry("/1", {})).text();
  for (const worker of made) {
    dead.add(worker);
    worker.onerror?.({});
  }
  assert.equal(await (await pool.carry("/2", {})).text(), "a");
});

test("workers that were made early have the core as soon as it is there, and are those that answer", async () => {
  const { made, make } = fakes(() => [head(), part("a"), end()]);
  const posted = [];
  const pool = new Pool(() => {
    const worker = make();
    const { postMessage } = worker;
    worker.postMessage = (letter) => (posted.push(Object.keys(letter)[0]), postMessage.call(worker, letter));
    return worker;
  }, 2);
  pool.prepare(2);
  assert.deepEqual([made.length, posted], [2, []]);
  pool.begin(begin);
  assert.deepEqual(posted, ["module", "module"]);
  assert.equal(await (await pool.carry("/1", {})).text(), "a");
  assert.equal(made.length, 2);
});
