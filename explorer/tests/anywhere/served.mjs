// The native program's answers, and the comparison of the core's with them.
import assert from "node:assert/strict";
import { startExplorer } from "../browser/session.mjs";

/** A program that serves: `ask(path, body)` gives {status, bytes}. */
export async function startServed(options) {
  const explorer = await startExplorer(options);
  const opened = await fetch(explorer.link(), { redirect: "manual" });
  const headers = {
    "Cookie": opened.headers.get("set-cookie").split(";")[0],
    "Origin": explorer.origin,
    "Content-Type": "application/json",
  };
  const outOfTime = 503; // on a machine that does much else beside
  return {
    async ask(path, body) {
      for (let turn = 1; ; ++turn) {
        const response = await fetch(explorer.origin + path, { headers, method: "POST", body: JSON.stringify(body) });
        const bytes = Buffer.from(await response.arrayBuffer());
        if (response.status !== outOfTime || turn === 5) return { status: response.status, bytes };
      }
    },
    async get(path) {
      const response = await fetch(explorer.origin + path, { headers });
      return { status: response.status, bytes: Buffer.from(await response.arrayBuffer()) };
    },
    stop: () => explorer.stop(),
  };
}

/** Of a chart all lines as one: how often it was looked at before its end depends on the clock. */
function comparable(path, bytes) {
  const text = bytes.toString("latin1").replace(/"commit": *"[^"]*"/g, "");
  if (path !== "/api/chart") return text;
  const looks = text
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line));
  return JSON.stringify(Object.assign({}, ...looks, { round: 0 }));
}

/** Fails where the two answers are not the same bytes; gives the status. */
export async function compare(served, core, path, body) {
  const native = await served.ask(path, body);
  const inside = core.ask(path, body);
  assert.equal(inside.status, native.status, `${path} ${JSON.stringify(body)}: ${inside.bytes.subarray(0, 300)}`);
  const [one, other] = [native, inside].map(({ bytes }) => comparable(path, bytes));
  if (one === other) return native.status;
  const at = [...one].findIndex((letter, k) => letter !== other[k]);
  const near = (text) => JSON.stringify(text.slice(Math.max(0, at - 60), at + 60));
  assert.fail(`${path} of ${JSON.stringify(body)} differs at byte ${at}: native ${near(one)}, core ${near(other)}`);
}
