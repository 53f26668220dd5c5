// The page in a frame: of the one site that `--frame` names, and of no other.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { createServer, request } from "node:http";
import { after, before, test } from "node:test";
import { until } from "../until.mjs";
import { lacking } from "./needs.mjs";
import { openPage, program, startExplorer } from "./session.mjs";

const executablePath = process.env.STRIDOR_CHROMIUM ?? "/usr/bin/chromium";
const skip = lacking(existsSync(executablePath), "Chromium", "chromium");

let notebook; // a site that shows a frame, at every name of this machine
let neighbour; // another one, at another port
let explorer;
let port;

// "/?LINK" shows LINK in a frame
function site() {
  const server = createServer((asked, answer) => {
    const link = decodeURIComponent(new URL(asked.url, "http://a").search.slice(1));
    answer.setHeader("Content-Type", "text/html");
    answer.end(
      `<!doctype html><link rel="icon" href="data:,"><iframe src="${link}" width="1200" height="720"></iframe>`,
    );
  });
  return new Promise((resolve) => server.listen(0, () => resolve(server)));
}

before(async () => {
  [notebook, neighbour] = [await site(), await site()];
  explorer = await startExplorer(["--frame", `http://localhost:${notebook.address().port}`]);
  port = Number(new URL(explorer.origin).port);
});

after(async () => {
  notebook.close();
  neighbour.close();
  assert.equal(await explorer?.stop(), 0);
});

function ask({ path = "/", method = "GET", headers = {}, body = "" }) {
  return new Promise((resolve, reject) => {
    const sent = request(
      { host: "127.0.0.1", port, path, method, agent: false, headers: { Host: `localhost:${port}`, ...headers } },
      (response) => response.resume().on("end", () => resolve(response)),
    );
    sent.on("error", reject);
    sent.end(body);
  });
}

test("the link has the name of the site round it, and the policy names this site alone", async () => {
  assert.equal(new URL(explorer.link()).hostname, "localhost");
  for (const path of ["/", "/page.js", "/open?token=x", "/nothing"]) {
    const policy = (await ask({ path })).headers["content-security-policy"];
    assert.ok(policy.endsWith(`; frame-ancestors http://localhost:${notebook.address().port}`), policy);
    assert.ok(policy.startsWith("default-src 'none'; script-src 'self';"), policy);
  }
});

test("the site round it can show the page, and ask it for nothing", async () => {
  const link = explorer.link();
  const opened = await ask({ path: `/open${new URL(link).search}`, headers: { "Sec-Fetch-Site": "same-site" } });
  await until(() => explorer.link() !== link, "the next link");
  const cookie = opened.headers["set-cookie"][0];
  assert.match(cookie, /; HttpOnly; SameSite=Strict; Path=\/$/);
  const Cookie = cookie.split(";")[0];
  const post = (Origin, more = {}) =>
    ask({
      path: "/api/simulate",
      method: "POST",
      headers: { Cookie, Origin, "Content-Type": "application/json", ...more },
      body: '{"preset":"squeal"}',
    });
  assert.equal((await post(`http://localhost:${port}`)).statusCode, 200);
  for (const origin of [
    `http://localhost:${notebook.address().port}`,
    `http://localhost:${neighbour.address().port}`,
    "http://evil.example",
    `https://localhost:${port}`,
    "null",
  ])
    assert.equal((await post(origin)).statusCode, 403, origin);
  assert.equal((await post(`http://localhost:${port}`, { "Sec-Fetch-Site": "same-site" })).statusCode, 403);
  assert.equal((await ask({ headers: { Cookie, "Sec-Fetch-Site": "same-site" } })).statusCode, 403);
  assert.equal((await ask({ headers: { Cookie, "Sec-Fetch-Site": "cross-site" } })).statusCode, 403);
  assert.equal((await ask({ headers: { Cookie, Host: "evil.example" } })).statusCode, 421);
  assert.equal((await ask({})).statusCode, 401);
});

test("what is no origin, and the name of another machine, are refused", () => {
  for (const origin of [
    "*",
    "",
    "http://localhost:8888/",
    "http://localhost *",
    "http://evil.example",
    "http://[::1]:1",
  ]) {
    const { status, stderr } = spawnSync(program, ["explore", "--no-browser", "--frame", origin], { timeout: 20000 });
    assert.equal(status, 2, `${origin}: ${stderr}`);
  }
});

// what stands in the frame of a page, once it is known
async function framed(address) {
  const browser = await openPage(explorer);
  try {
    const link = explorer.link();
    await browser.page.goto(`http://${address}/?${encodeURIComponent(link)}`);
    await until(() => explorer.link() !== link, "the link to be used");
    const frame = await (await browser.page.waitForSelector("iframe")).contentFrame();
    let going = null;
    await until(async () => {
      if (frame.url().startsWith("chrome-error:")) return true;
      going = await frame.evaluate("document.querySelector('#verdict')?.dataset.going ?? null").catch(() => null);
      return going !== null;
    }, "the frame to show something");
    return { going, url: frame.url(), sins: browser.sins.filter((sin) => !sin.includes(`http://${address}/`)) };
  } finally {
    await browser.close();
  }
}

test("a browser shows it in the site that is named", { skip, timeout: 200_000 }, async () => {
  const { going, url, sins } = await framed(`localhost:${notebook.address().port}`);
  assert.equal(going, "squeal");
  assert.ok(url.startsWith(`http://localhost:${port}/`) && !url.includes("token"), url);
  assert.deepEqual(sins, []);
});

test("a browser shows it in no other site, be it one of this machine", { skip, timeout: 200_000 }, async () => {
  for (const address of [`localhost:${neighbour.address().port}`, `127.0.0.1:${notebook.address().port}`]) {
    const { going, url } = await framed(address);
    assert.equal(going, null, address);
    assert.ok(url.startsWith("chrome-error:"), `${address}: ${url}`);
  }
});
