// The running program under attack: refused, memory bounded, still answering. What each layer does by itself is tested
// in tests/unit/explorer.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { chmod, mkdtemp, readFile, rm, stat, writeFile } from "node:fs/promises";
import { request } from "node:http";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { until } from "../until.mjs";
import { program, startExplorer } from "./session.mjs";

// what an attack may leave behind [MB]; sanitizers keep what is freed for a while
const room = process.env.STRIDOR_SANITIZED ? 400 : 32;

let explorer;
let port;
let host;
let cookie;

before(async () => {
  explorer = await startExplorer();
  port = Number(new URL(explorer.origin).port);
  host = `127.0.0.1:${port}`;
  const opened = await ask({ path: `/open${new URL(explorer.link()).search}`, cookie: "" });
  assert.equal(opened.status, 303);
  cookie = opened.headers["set-cookie"][0].split(";")[0];
  await post("/api/simulate", { preset: "squeal" }); // so that memory has its usual size
});

after(async () => assert.equal(await explorer?.stop(), 0));

function ask({ path = "/", method = "GET", headers = {}, body = null, cookie: session = cookie, at = port }) {
  return new Promise((resolve, reject) => {
    const sent = request(
      {
        host: "127.0.0.1",
        port: at,
        path,
        method,
        agent: false,
        headers: { Host: host, ...(session ? { Cookie: session } : {}), ...headers },
      },
      (response) => {
        const parts = [];
        response.on("data", (part) => parts.push(part));
        response.on("end", () =>
          resolve({
            status: response.statusCode,
            headers: response.headers,
            body: Buffer.concat(parts).toString(),
          }),
        );
        response.on("error", reject);
      },
    );
    sent.on("error", reject);
    if (body !== null) sent.write(body);
    sent.end();
  });
}

function post(path, body, headers = {}) {
  return ask({
    path,
    method: "POST",
    body: typeof body === "string" || Buffer.isBuffer(body) ? body : JSON.stringify(body),
    headers: { "Content-Type": "application/json", "Origin": `http://${host}`, ...headers },
  });
}

// bytes on a bare connection, as many as it takes
function pour(head, piece, most) {
  return new Promise((resolve) => {
    const socket = connect(port, "127.0.0.1");
    let poured = 0;
    let answer = "";
    const go = () => {
      while (poured < most && !socket.destroyed) {
        poured += piece.length;
        if (!socket.write(piece)) return socket.once("drain", go);
      }
      socket.end();
    };
    socket.on("data", (data) => (answer += data));
    socket.on("error", () => {});
    socket.on("close", () => resolve({ poured, answer }));
    socket.on("connect", () => {
      socket.write(head);
      go();
    });
    setTimeout(() => socket.destroy(), 30000).unref();
  });
}

async function residentMegabytes() {
  const status = await readFile(`/proc/${explorer.pid}/status`, "utf8");
  return Number(/VmHWM:\s+(\d+)/.exec(status)[1]) / 1024;
}

// the processor time that a process has taken [1/100 s]
async function ticks(pid) {
  const fields = (await readFile(`/proc/${pid}/stat`, "utf8")).split(") ")[1].split(" ");
  return Number(fields[11]) + Number(fields[12]);
}

async function isStillAnswering() {
  assert.equal((await ask({})).status, 200);
}

test("foreign names, origins and sessions are refused", async () => {
  for (const name of ["evil.example", `evil.example:${port}`, "127.0.0.1.evil.example"])
    assert.equal((await ask({ headers: { Host: name } })).status, 421, name);
  for (const origin of ["http://evil.example", "null", "http://localhost:1", `https://${host}`])
    assert.equal((await post("/api/simulate", { preset: "squeal" }, { Origin: origin })).status, 403, origin);
  assert.equal((await ask({ headers: { "Sec-Fetch-Site": "cross-site" } })).status, 403);
  for (const session of ["", "stridor-1=1", `stridor-${port}=${"0".repeat(64)}`])
    assert.equal((await ask({ cookie: session })).status, 401, session);
  for (const token of ["", "token=", "token=1", `token=${"f".repeat(64)}`])
    assert.equal((await ask({ path: `/open?${token}`, cookie: "" })).status, 403, token);
  for (const method of ["PUT", "DELETE", "OPTIONS"]) assert.equal((await ask({ method })).status, 405, method);
  await isStillAnswering();
});

test("a link opens once, and the next one is printed", async () => {
  const link = explorer.link();
  const path = `/open${new URL(link).search}`;
  assert.equal((await ask({ path, cookie: "" })).status, 303);
  assert.equal((await ask({ path, cookie: "" })).status, 403);
  await until(() => explorer.link() !== link, "the next link");
});

test("paths reach no file", async () => {
  for (const path of [
    "/../../../etc/passwd",
    "/..%2f..%2fetc/passwd",
    "/%2e%2e/%2e%2e/etc/passwd",
    "//etc/passwd",
    "/page.js/..",
    "/api/library/../../etc/passwd",
    "/api/library/1/audio/../../x",
    "/\\..\\..",
    "/page.js%00.html",
  ]) {
    const answer = await ask({ path });
    assert.notEqual(answer.status, 200, path);
    assert.ok(!answer.body.includes("root:"), path);
  }
});

test("600 MB of chunks are refused after a few, in little memory", async () => {
  const before = await residentMegabytes();
  const head = `POST /api/simulate HTTP/1.1\r\nHost: ${host}\r\nTransfer-Encoding: chunked\r\n\r\n`;
  const piece = `100000\r\n${"x".repeat(0x100000)}\r\n`;
  const { poured } = await pour(head, piece, 600e6);
  assert.ok(poured < 100e6, `${poured}`);
  await isStillAnswering();
  assert.ok((await residentMegabytes()) - before < room);
});

test("three million header lines are refused after a few, in little memory", async () => {
  const before = await residentMegabytes();
  const { poured } = await pour(`GET / HTTP/1.1\r\nHost: ${host}\r\n`, "X-Header-Line: 1\r\n".repeat(10000), 54e6);
  assert.ok(poured < 20e6, `${poured}`);
  await isStillAnswering();
  assert.ok((await residentMegabytes()) - before < room);
});

test("a chunk of negative size is no chunk", async () => {
  const head = `POST /api/simulate HTTP/1.1\r\nHost: ${host}\r\nTransfer-Encoding: chunked\r\n\r\n`;
  const { answer } = await pour(head, "-2\r\nab\r\n", 8);
  assert.match(answer, /^HTTP\/1\.1 400/);
  await isStillAnswering();
});

test("two hundred connections that say nothing do not keep others out for ever", async () => {
  const sockets = Array.from({ length: 200 }, () => connect(port, "127.0.0.1").on("error", () => {}));
  await Promise.all(sockets.map((socket) => new Promise((resolve) => socket.once("connect", resolve))));
  sockets.forEach((socket) => socket.destroy());
  // the server notices one by one that they have left
  await until(async () => (await ask({}).catch(() => ({}))).status === 200, "an answer");
});

test("a hundred connections that stay, silent or refused, keep the owner neither out nor waiting", async () => {
  const sockets = Array.from({ length: 100 }, (_, k) => {
    const socket = connect(port, "127.0.0.1").on("error", () => {});
    if (k % 2) socket.write(`GET / HTTP/1.1\r\nHost: ${host}\r\n${k % 4 === 1 ? "\r\n" : ""}`);
    return socket;
  });
  try {
    await Promise.all(sockets.map((socket) => new Promise((resolve) => socket.once("connect", resolve))));
    const began = Date.now();
    await isStillAnswering();
    assert.equal((await post("/api/simulate", { preset: "squeal" })).status, 200);
    assert.ok(Date.now() - began < 5000, "the owner waits");
  } finally {
    sockets.forEach((socket) => socket.destroy());
  }
});

test("cookies that others set for this host lock nobody out", async () => {
  const name = cookie.split("=")[0];
  const many = Array.from({ length: 179 }, (_, k) => `c${k}=${"x".repeat(4080)}`).join("; ");
  for (const cookies of [
    `${name}=${"0".repeat(64)}; ${cookie}`,
    `${name}=; ${name}=x; stridor-1=y; ${cookie}; ${name}=z`,
    `${many}; ${cookie}`,
  ])
    assert.equal((await ask({ cookie: cookies })).status, 200, cookies.slice(0, 200));
  assert.equal((await ask({ cookie: many })).status, 401);
});

test("no request opens a file, whatever bytes stand around its key", async () => {
  const folder = await mkdtemp(join(tmpdir(), "stridor-attack-"));
  const pipe = join(folder, "pipe.csv");
  const canary = join(folder, "canary.csv");
  await writeFile(canary, "canary-in-the-mine\n1,2\n");
  assert.equal(spawnSync("mkfifo", [pipe]).status, 0);
  try {
    for (const file of [canary, pipe, "/dev/zero", "/etc/hostname"])
      for (const byte of ["\n", "\r", "\t", "\0", "\x0b", "\x7f", " ", '"'])
        for (const key of [`${byte}drive.file`, `drive${byte}.file`, `drive.file${byte}`]) {
          const answer = await Promise.race([
            post("/api/simulate", { preset: "squeal", set: ["drive.kind=sampled", `${key}=${file}`] }),
            new Promise((resolve) => setTimeout(() => resolve({ status: "none", body: "" }), 5000).unref()),
          ]);
          assert.equal(answer.status, 400, JSON.stringify([key, file]));
          assert.doesNotMatch(answer.body, /canary-in/, JSON.stringify([key, file]));
          // a short name may stand in the name of a folder by chance
          if (file === "/etc/hostname") {
            const said = answer.body.replaceAll(file, "");
            assert.ok(!said.includes(readFileSync(file, "utf8").trim()), JSON.stringify([key, file]));
          }
        }
  } finally {
    await rm(folder, { recursive: true });
  }
  await isStillAnswering();
});

test("runs that do not stop when their clients leave keep neither the page nor Ctrl-C waiting", async () => {
  const own = await startExplorer();
  const there = { port: Number(new URL(own.origin).port) };
  there.host = `127.0.0.1:${there.port}`;
  const opened = await ask({
    path: `/open${new URL(own.link()).search}`,
    cookie: "",
    headers: { Host: there.host },
    at: there.port,
  });
  const session = opened.headers["set-cookie"][0].split(";")[0];
  for (const set of [
    ["plate.damping=1e308"],
    ["plate.stiffness=1e308"],
    ["drive.frequency=1e9", "run.duration=60", "run.window=60"],
  ])
    for (let k = 0; k < 2; ++k) {
      const body = JSON.stringify({ preset: "squeal", set });
      const idle = await ticks(own.pid);
      const socket = connect(there.port, "127.0.0.1").on("error", () => {});
      socket.write(
        `POST /api/simulate HTTP/1.1\r\nHost: ${there.host}\r\n` +
          `Origin: http://${there.host}\r\nCookie: ${session}\r\n` +
          `Content-Type: application/json\r\nContent-Length: ${body.length}\r\n\r\n${body}`,
      );
      let isAnswered = false;
      socket.once("data", () => (isAnswered = true));
      await until(async () => isAnswered || (await ticks(own.pid)) > idle + 10, "the run to begin");
      socket.destroy();
    }
  const began = Date.now();
  const page = await Promise.race([
    ask({ cookie: session, headers: { Host: there.host }, at: there.port }),
    new Promise((resolve) => setTimeout(() => resolve({ status: "none" }), 15000).unref()),
  ]);
  const waited = Date.now() - began;
  const leaving = Date.now();
  const code = await Promise.race([
    own.stop(),
    new Promise((resolve) => setTimeout(() => resolve("none"), 15000).unref()),
  ]);
  if (code === "none") process.kill(own.pid, "SIGKILL");
  assert.equal(page.status, 200);
  assert.ok(waited < 8000, `${waited} ms`);
  assert.equal(code, 0);
  assert.ok(Date.now() - leaving < 8000);
});

test("the list of processes shows no secret while the browser is opened", async () => {
  const folder = await mkdtemp(join(tmpdir(), "stridor-attack-"));
  const seen = join(folder, "seen");
  await writeFile(
    join(folder, "xdg-open"),
    `#!/bin/sh\nls /proc/self/fd > "${seen}.fds"\necho "$@" > "${seen}.part"\nmv "${seen}.part" "${seen}"\n`,
  );
  await chmod(join(folder, "xdg-open"), 0o755);
  const env = { ...process.env, DISPLAY: ":99", PATH: `${folder}:${process.env.PATH}` };
  const own = spawn(program, ["explore"], { env, stdio: ["ignore", "pipe", "ignore"] });
  try {
    const link = String(await new Promise((resolve) => own.stdout.once("data", resolve))).trim();
    const opened = (await until(() => readFile(seen, "utf8").catch(() => null), "the browser")).trim();
    const token = new URL(link).searchParams.get("token");
    assert.ok(!opened.includes(token) && !opened.includes("http"), opened);
    assert.equal((await stat(opened)).mode & 0o777, 0o600);
    assert.equal((await stat(dirname(opened))).mode & 0o777, 0o700);
    assert.ok((await readFile(opened, "utf8")).includes(`url=${link}"`));
    const fds = (await readFile(`${seen}.fds`, "utf8")).trim().split("\n").map(Number);
    assert.ok(
      fds.every((fd) => fd <= 3),
      `the browser keeps ${fds}`,
    ); // 3: of ls itself
    const answer = await ask({
      path: `/open?token=${token}`,
      cookie: "",
      headers: { Host: new URL(link).host },
      at: Number(new URL(link).port),
    });
    assert.equal(answer.status, 303);
    await assert.rejects(stat(dirname(opened)), "the file is gone once it was used");
  } finally {
    own.kill("SIGTERM");
    await new Promise((resolve) => own.once("exit", resolve));
    await rm(folder, { recursive: true });
  }
});

test("malformed JSON of every kind is an error in words", async () => {
  let state = 12345;
  const random = (below) => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return Math.floor((state / 2147483648) * below);
  };
  const whole = JSON.stringify({
    preset: "squeal",
    set: ["contact.preload=20", "run.duration=0.3", "run.window=0.3"],
    chart: {
      x: { parameter: "contact.preload", from: 1, to: 80, points: 4 },
      y: { parameter: "contact.kinetic_friction", from: 0, to: 0.8, points: 4 },
    },
  });
  const paths = ["simulate", "motion", "chart", "stability", "toml", "sound", "analysis"];
  for (let run = 0; run < 400; ++run) {
    const bytes = Buffer.from(whole);
    for (let change = 0; change <= random(4); ++change) bytes[random(bytes.length)] = random(256);
    const cut = bytes.subarray(0, random(3) === 0 ? random(bytes.length) : bytes.length);
    const answer = await post(`/api/${paths[run % paths.length]}`, cut);
    assert.ok([200, 400, 422].includes(answer.status), `${answer.status} ${cut}`);
    if (answer.status !== 200) assert.ok(JSON.parse(answer.body).error.what.length > 0);
  }
  for (const body of [
    "",
    "[".repeat(900000),
    '{"a":'.repeat(100000),
    "\u0000",
    "1e999",
    '{"preset":"squeal","set":[1e400]}',
  ])
    assert.equal((await post("/api/simulate", body)).status, 400);
  await isStillAnswering();
});

test("an abandoned chart does not go on computing", async () => {
  const body = JSON.stringify({
    preset: "squeal",
    set: ["run.duration=50", "run.window=50"],
    chart: {
      x: { parameter: "contact.preload", from: 1, to: 80, points: 256 },
      y: { parameter: "contact.kinetic_friction", from: 0, to: 0.8, points: 256 },
    },
  });
  const idle = await ticks(explorer.pid);
  const socket = connect(port, "127.0.0.1");
  socket.write(
    `POST /api/chart HTTP/1.1\r\nHost: ${host}\r\nOrigin: http://${host}\r\nCookie: ${cookie}\r\n` +
      `Content-Type: application/json\r\nContent-Length: ${body.length}\r\n\r\n${body}`,
  );
  await until(async () => (await ticks(explorer.pid)) > idle + 20, "the chart to begin");
  socket.destroy();
  // 131072 cells take minutes
  let last = null;
  const rests = async () => {
    const before = last;
    last = await ticks(explorer.pid);
    return before !== null && last - before < 5;
  };
  await until(rests, "the chart to stop", { limit: 10_000, every: 250 });
});

test("other addresses are refused unless asked for twice", () => {
  const refused = spawnSync(program, ["explore", "--no-browser", "--address", "0.0.0.0"], { encoding: "utf8" });
  assert.equal(refused.status, 2);
  assert.match(refused.stderr, /--allow-remote/);
  assert.equal(spawnSync(program, ["explore", "--address", "nonsense", "--allow-remote"]).status, 2);
  assert.equal(spawnSync(program, ["explore", "--no-browser", "--port", String(port)]).status, 5);
  assert.equal(spawnSync(program, ["explore", "/nowhere/case.toml"]).status, 5);
  assert.equal(spawnSync(program, ["explore", "--unix-socket", `/tmp/${"x".repeat(150)}`]).status, 2);
  assert.notEqual(spawnSync(program, ["explore", "--library", "/nowhere/library.sqlite"], { timeout: 5000 }).status, 0);
});
