// The program and a real browser, for the tests: starts `stridor explore`, opens its link in headless Chromium, and
// notes what must never happen: console errors, page errors, requests to anywhere else.
import { spawn } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { chromium } from "playwright-core";

const program = process.env.STRIDOR_PROGRAM;
const executablePath = process.env.STRIDOR_CHROMIUM ?? "/usr/bin/chromium";
if (!program) throw new Error("STRIDOR_PROGRAM must name the stridor to test");

export { program };

/** Starts the explorer; `link()` gives the newest link that it printed. */
export async function startExplorer(options = []) {
  const child = spawn(program, ["explore", "--no-browser", ...options], { stdio: ["ignore", "pipe", "pipe"] });
  let link = null;
  let wake = () => {};
  createInterface({ input: child.stdout }).on("line", (line) => {
    link = line;
    wake();
  });
  while (link === null) {
    await new Promise((resolve, reject) => {
      wake = resolve;
      child.once("exit", (code) => reject(new Error(`stridor explore ended with ${code}`)));
    });
  }
  const ended = new Promise((resolve) => child.once("exit", (code) => resolve(code)));
  return {
    pid: child.pid,
    link: () => link,
    origin: new URL(link).origin,
    async stop() {
      child.kill("SIGTERM");
      return ended;
    },
  };
}

/** A page on the explorer, with the list of its sins; `switches` are further ones of the browser. */
export async function openPage(explorer, { switches = [], ...options } = {}) {
  const folder = await mkdtemp(join(tmpdir(), "stridor-browser-"));
  const context = await chromium.launchPersistentContext(folder, {
    executablePath,
    headless: true,
    acceptDownloads: true,
    viewport: { width: 1440, height: 900 },
    args: [
      "--no-sandbox",
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      "--autoplay-policy=no-user-gesture-required",
      ...switches,
    ],
    ...options,
  });
  const sins = [];
  const page = context.pages()[0] ?? (await context.newPage());
  // nothing here is timed: a machine that does something else beside is waited for
  context.setDefaultTimeout(600_000);
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") sins.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => sins.push(`page: ${error.message}`));
  page.on("request", (request) => {
    const url = request.url();
    const isPage = url.startsWith(`${explorer.origin}/`) || url.replace(/#.*/, "") === explorer.origin;
    const isOwn = isPage || url.startsWith("data:") || url.startsWith("blob:");
    if (!isOwn) sins.push(`request: ${url}`);
  });
  return {
    page,
    sins,
    async goto(fragment = "") {
      await page.goto(`${explorer.link()}${fragment}`);
    },
    async close() {
      await context.close();
      await rm(folder, { recursive: true, force: true });
    },
  };
}

/** Waits until the verdict and the whole chart of a page or a frame are there. */
export async function settled(page) {
  await page.locator('#verdict[aria-busy="false"]').waitFor();
  await page.locator('#chart[data-done="true"]').waitFor();
}

/** Waits until the motion is drawn: it may come after verdict and chart, for it is asked for after the verdict. */
export async function moving(page) {
  await page.locator("#mechanism-readout:not(:empty)").waitFor({ state: "attached" });
}
