// The tour as a student takes it, and what a keyboard and a screen reader meet on the page.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { scratchFolder } from "../scratch.mjs";
import { openPage, program, startExplorer } from "./session.mjs";

const folder = scratchFolder();
let explorer;
let browser;
let page;

before(async () => {
  const [sound, library] = [join(folder, "sound.wav"), join(folder, "noises.sqlite")];
  execFileSync(program, ["listen", "-", "--out", sound], { input: execFileSync(program, ["init", "creak"]) });
  execFileSync(program, ["library", "add", sound, "--library", library, "--system", "seal"], { stdio: "ignore" });
  explorer = await startExplorer(["--library", library]);
  browser = await openPage(explorer);
  page = browser.page;
  await browser.goto("#preset=quiet&contact.preload=7");
  await page.waitForSelector('#verdict[aria-busy="false"]');
});

after(async () => {
  await browser?.close();
  assert.equal(await explorer?.stop(), 0);
});

const title = () => page.locator("#tour-title").innerText();
const result = () => page.locator("#tour-result").innerText();

/** What the command line says of a design: the category and frequency of each direction. */
function simulated(preset, ...set) {
  const text = execFileSync(program, ["init", preset]);
  const options = set.flatMap((item) => ["--set", item]);
  const { phases } = JSON.parse(execFileSync(program, ["simulate", "-", "--json", ...options], { input: text }));
  return Object.fromEntries(phases.map(({ phase, verdict }) => [phase, verdict]));
}

const verbs = { none: "is quiet", squeal: "squeals", squeak: "squeaks", creak: "creaks" };

async function predict(value) {
  await page.locator(`#tour [data-answer="${value}"]`).click();
}

/** Lets the tour do it, and gives whether the prediction was right, with the words. */
async function judged() {
  const hasJudged = () => /^[✓✗]/.test(document.querySelector("#tour-result").textContent);
  await page.waitForFunction(hasJudged, null);
  const said = await result();
  assert.equal(await page.locator("#tour-result").getAttribute("data-right"), String(said.startsWith("✓")));
  return said;
}

test("the tour begins by a key and waits for a prediction before anything else", async () => {
  assert.match(await page.locator("#tour-button").getAttribute("class"), /primary/);
  await page.keyboard.press("t");
  await page.waitForSelector("#tour:not([hidden]) [data-answer]");
  assert.match(await title(), /^1 of 5/);
  assert.ok(await page.locator("#tour-next").isHidden());
  assert.ok(await page.locator("#tour-do").isHidden());
});

test("a slider that is dragged is answered by the model: friction raised until it sounds", async () => {
  await predict("squeal");
  const row = page.locator('[data-row="contact.kinetic_friction"]');
  assert.match(await row.getAttribute("class"), /pointed/);
  const slider = page.locator('input[type="range"][data-key="contact.kinetic_friction"]');
  await slider.focus();
  for (let step = 0; step < 60 && !/^[✓✗]/.test(await result()); ++step) {
    for (let k = 0; k < 12; ++k) await page.keyboard.press("ArrowRight");
    await page.waitForSelector('#verdict[aria-busy="false"]');
  }
  const said = await judged();
  const friction = /μd = ([\d.]+) it (\w+)/.exec(said);
  const model = simulated("squeal", `contact.kinetic_friction=${friction[1]}`);
  assert.ok(said.includes(`it ${verbs[model.going.category]}`), said);
  assert.equal(said.startsWith("✓"), model.going.category === "squeal");
});

test("a wrong prediction is told so, with what the model does instead", async () => {
  await page.locator("#tour-next").click();
  await page.waitForSelector("#tour [data-answer]");
  assert.match(await title(), /^2 of 5/);
  await predict("10");
  const said = await judged();
  assert.ok(said.startsWith("✗"));
  const { frequency } = simulated("squeal").going;
  assert.ok(Math.abs(Number(/([\d.]+) times/.exec(said)[1]) - frequency) < 0.1, said);
  assert.equal(await page.locator("#tab-listen").getAttribute("aria-selected"), "true");
});

test("what the tour does by itself is judged by the same model", async () => {
  const isLoud = ({ category }) => category !== "none";
  const rounds = [
    ["coming", "squeal", "joint.incidence_angle=110", (model) => isLoud(model.coming) && !isLoud(model.going)],
    ["stays", "squeal", "contact.static_friction=0.6", (model) => isLoud(model.going) || isLoud(model.coming)],
    ["stays", "creak", "contact.static_friction=0.2", (model) => isLoud(model.going) || isLoud(model.coming)],
  ];
  for (const [value, preset, set, isRight] of rounds) {
    await page.locator("#tour-next").click();
    await page.waitForSelector("#tour [data-answer]");
    await predict(value);
    await page.locator("#tour-do").click();
    const said = await judged();
    const model = simulated(preset, set);
    assert.equal(said.startsWith("✓"), isRight(model), said);
    assert.ok(said.includes(`it ${verbs[model.going.category]} going`), said);
  }
  assert.match(await result(), /Steady sliding is stable/);
});

test("at its end it counts what was foretold, and leaving brings back what was there before", async () => {
  await page.locator("#tour-next").click();
  assert.match(await page.locator("#tour-text").innerText(), /You predicted \d of 5/);
  await page.keyboard.press("Escape");
  await page.waitForSelector("#tour", { state: "hidden" });
  assert.match(page.url(), /preset=quiet&contact\.preload=7/);
  assert.equal(await page.evaluate(() => document.activeElement.id), "tour-button");
});

test("the keyboard alone takes the tour and leaves it at any time", async () => {
  await page.keyboard.press("Enter");
  await page.waitForSelector("#tour:not([hidden]) [data-answer]");
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.dataset.answer), "none");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement.id === "tour-do");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement.id === "tour-next");
  await judged();
  await page.keyboard.press("Escape");
  await page.waitForSelector("#tour", { state: "hidden" });
  assert.match(page.url(), /preset=quiet&contact\.preload=7/);
});

test("that the tour was seen is remembered in this session alone", async () => {
  assert.doesNotMatch((await page.locator("#tour-button").getAttribute("class")) ?? "", /primary/);
  await page.reload();
  await page.waitForSelector("#tour-button");
  assert.doesNotMatch((await page.locator("#tour-button").getAttribute("class")) ?? "", /primary/);
  assert.equal(await page.evaluate(() => localStorage.length), 0);
  const other = await page.context().newPage();
  await other.goto(`${explorer.origin}/`);
  await other.waitForSelector("#tour-button");
  assert.match(await other.locator("#tour-button").getAttribute("class"), /primary/);
  await other.close();
});

// roles that a user operates, and pictures, which are nothing without words
const named = new Set([
  ...["button", "link", "textbox", "searchbox", "combobox", "listbox", "slider", "spinbutton", "checkbox", "radio"],
  ...["tab", "tabpanel", "switch", "menuitem", "DisclosureTriangle", "application", "image", "img", "Audio"],
  ...["dialog", "region", "group", "radiogroup"],
]);

test("every control and picture has a name that a screen reader can say", async () => {
  const cdp = await page.context().newCDPSession(page);
  const nameless = async (state, least = 20) => {
    const { nodes } = await cdp.send("Accessibility.getFullAXTree");
    const seen = nodes.filter(({ ignored, role }) => !ignored && named.has(role?.value));
    assert.ok(seen.length >= least, `${state}: only ${seen.length} found`);
    const without = seen.filter(({ role, name }) => !name?.value?.trim() && role.value !== "group");
    return Promise.all(
      without.map(async ({ role, backendDOMNodeId }) => {
        const { node } = await cdp.send("DOM.describeNode", { backendNodeId: backendDOMNodeId });
        return `${state}: ${role.value} <${node.nodeName.toLowerCase()} ${(node.attributes ?? []).join(" ")}>`;
      }),
    );
  };
  const found = [];
  const views = await page.locator("[data-view]").evaluateAll((tabs) => tabs.map((tab) => tab.dataset.view));
  assert.ok(views.length >= 7, views.join());
  for (const view of views) {
    await page.locator(`#tab-${view}`).click();
    await page.waitForSelector(`#view-${view} > *`);
    if (view === "quiet") {
      await page.waitForSelector("#margins [data-margin]");
      await page.locator("#add-tolerance").click();
    }
    await page.waitForTimeout(300);
    found.push(...(await nameless(view)));
  }
  await page.evaluate(() => document.querySelectorAll("details").forEach((each) => (each.open = true)));
  found.push(...(await nameless("all open")));
  await page.evaluate(() => document.querySelectorAll("details.drop").forEach((each) => (each.open = false)));
  await page.locator("#help-button").click();
  found.push(...(await nameless("keys", 2)));
  await page.keyboard.press("Escape");
  assert.deepEqual(found, []);
});

test("no two controls of one kind have the same name", async () => {
  const cdp = await page.context().newCDPSession(page);
  const { nodes } = await cdp.send("Accessibility.getFullAXTree");
  const names = nodes
    .filter(({ ignored, role }) => !ignored && ["slider", "textbox", "combobox"].includes(role?.value))
    .map(({ role, name }) => `${role.value}: ${name.value}`);
  assert.deepEqual(
    names.filter((name, k) => names.indexOf(name) !== k),
    [],
  );
});

test("nothing went wrong on the way", () => {
  assert.deepEqual(browser.sins, []);
});
