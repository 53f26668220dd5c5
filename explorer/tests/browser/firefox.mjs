// Firefox for the tests, driven through Marionette, its own WebDriver over a plain socket: playwright-core needs a
// Firefox that was patched for it. Messages are `LENGTH:JSON`: [0, id, command, parameters] there, [1, id, error,
// value] back.
import { execFileSync, spawn } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { until } from "../until.mjs";

/** The name of the Firefox of this machine; undefined: there is none. */
export const firefox = (process.env.STRIDOR_FIREFOX ? [process.env.STRIDOR_FIREFOX] : ["firefox-esr", "firefox"]).find(
  (name) => {
    try {
      return execFileSync(name, ["--version"], { stdio: ["ignore", "pipe", "ignore"] }).length > 0;
    } catch {
      return false;
    }
  },
);

const patience = 600_000; // [ms] for a Firefox that starts on a busy machine

/** The lines of user.js: any free port, and no talk with anybody but the page. */
const preferences = {
  "marionette.port": 0,
  "app.update.enabled": false,
  "browser.shell.checkDefaultBrowser": false,
  "browser.aboutwelcome.enabled": false,
  "datareporting.policy.dataSubmissionEnabled": false,
  "toolkit.telemetry.enabled": false,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
  "media.autoplay.default": 0,
};

/** The commands of one Firefox. */
class Marionette {
  constructor(socket) {
    this.socket = socket;
    this.next = 0;
    this.waiting = new Map();
    this.bytes = Buffer.alloc(0);
    socket.on("data", (part) => this.take(part));
  }

  take(part) {
    this.bytes = Buffer.concat([this.bytes, part]);
    for (;;) {
      const colon = this.bytes.indexOf(":");
      if (colon < 0) return;
      const end = colon + 1 + Number(this.bytes.subarray(0, colon));
      if (this.bytes.length < end) return;
      const message = JSON.parse(this.bytes.subarray(colon + 1, end));
      this.bytes = this.bytes.subarray(end);
      if (!Array.isArray(message)) continue; // the greeting
      const [, id, error, value] = message;
      const { resolve, reject } = this.waiting.get(id);
      this.waiting.delete(id);
      if (error) reject(new Error(`${error.error}: ${error.message}`));
      else resolve(value);
    }
  }

  ask(command, parameters = {}) {
    const id = ++this.next;
    const text = Buffer.from(JSON.stringify([0, id, command, parameters]));
    this.socket.write(Buffer.concat([Buffer.from(`${text.length}:`), text]));
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }
}

/** A Firefox with a window of this size; `preferred` and `env` stand beside the usual preferences and environment. */
export async function openFirefox(program, { width = 1440, height = 900, preferred = {}, env = {} } = {}) {
  const profile = await mkdtemp(join(tmpdir(), "stridor-firefox-"));
  const lines = Object.entries({ ...preferences, ...preferred }).map(
    (each) => `user_pref(${each.map((part) => JSON.stringify(part))});\n`,
  );
  await writeFile(join(profile, "user.js"), lines.join(""));
  const options = ["--headless", "--marionette", "--remote-allow-system-access", "--no-remote", "--profile", profile];
  const child = spawn(program, [...options, `--width=${width}`, `--height=${height}`], {
    stdio: "ignore",
    env: { ...process.env, HOME: profile, MOZ_CRASHREPORTER_DISABLE: "1", ...env },
  });
  const ended = new Promise((resolve) => child.once("exit", resolve));
  const portFile = join(profile, "MarionetteActivePort");
  const port = await until(() => readFile(portFile, "utf8").catch(() => null), "Firefox to listen");
  const socket = await until(
    () =>
      new Promise((resolve) => {
        const tried = connect(Number(port), "127.0.0.1", () => resolve(tried));
        tried.once("error", () => resolve(null));
      }),
    "Firefox to answer",
  );
  const wire = new Marionette(socket);
  await wire.ask("WebDriver:NewSession", {});
  await wire.ask("WebDriver:SetTimeouts", { script: patience, pageLoad: patience });

  const run = async (script, ...args) => (await wire.ask("WebDriver:ExecuteScript", { script, args })).value;
  const find = async (value) =>
    Object.values((await wire.ask("WebDriver:FindElement", { using: "css selector", value })).value)[0];
  const click = async (selector) => wire.ask("WebDriver:ElementClick", { id: await find(selector) });
  const isShown = async (id) => (await wire.ask("WebDriver:IsElementDisplayed", { id })).value;
  return {
    goto: (url) => wire.ask("WebDriver:Navigate", { url }),
    /** The body of a function that runs in the page. */
    run,
    /** Waits until the body of a function gives what is true there; gives that. */
    wait: (script, ...args) => until(() => run(script, ...args), script),
    click,
    /** One element, as Playwright's pages have it: for what is asked of every browser. */
    locator: (selector) => ({
      click: () => click(selector),
      textContent: () => run("return document.querySelector(arguments[0]).textContent;", selector),
      isVisible: async () => isShown(await find(selector)),
    }),
    type: async (selector, text) => wire.ask("WebDriver:ElementSendKeys", { id: await find(selector), text }),
    /** What follows is asked of the page in this frame. */
    enter: async (selector) => wire.ask("WebDriver:SwitchToFrame", { element: await find(selector) }),
    async picture(path) {
      const { value } = await wire.ask("WebDriver:TakeScreenshot", { full: false });
      await writeFile(path, Buffer.from(value, "base64"));
    },
    resize: (to) => wire.ask("WebDriver:SetWindowRect", to),
    /** Errors of scripts, styles and policies that Firefox noted about an origin. */
    async sins(origin) {
      await wire.ask("Marionette:SetContext", { value: "chrome" });
      const found = await run("return Services.console.getMessageArray().map(String);");
      await wire.ask("Marionette:SetContext", { value: "content" });
      return found.filter((text) => text.includes(origin));
    },
    async close() {
      await wire.ask("Marionette:Quit", { flags: ["eForceQuit"] }).catch(() => {});
      socket.destroy();
      if (child.exitCode === null) setTimeout(() => child.kill("SIGKILL"), 10_000).unref();
      await ended;
      await rm(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}
