// The page in Firefox, where there is one: it opens, computes, hears, draws, is dragged and typed into.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { firefox, openFirefox } from "./firefox.mjs";
import { lacking } from "./needs.mjs";
import { program, startExplorer } from "./session.mjs";

const skip = lacking(firefox, "Firefox", "firefox-esr");

test("the page works in Firefox", { skip, timeout: 400_000 }, async () => {
  const explorer = await startExplorer();
  const browser = await openFirefox(firefox);
  const settled = () =>
    browser.wait(`return document.querySelector('#verdict')?.getAttribute("aria-busy") === "false"
      && document.querySelector('#chart')?.dataset.done === "true";`);
  try {
    await browser.goto(explorer.link());
    await settled();
    assert.equal(await browser.run("return document.querySelector('#verdict').dataset.going;"), "squeal");
    assert.match(await browser.run("return document.querySelector('#verdict .chip').textContent;"), /joint 169\.5 dB/);

    // cells, motion and portrait are painted
    for (const canvas of ["#chart canvas", "#mechanism", "#response", "#portrait"]) {
      const colours = await browser.wait(
        `const canvas = document.querySelector(arguments[0]);
         const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
         const colours = new Set();
         for (let k = 0; k < data.length; k += 4 * 101) colours.add(data.slice(k, k + 4).join());
         return colours.size > 3 ? colours.size : null;`,
        canvas,
      );
      assert.ok(colours > 3, canvas);
    }

    // text with a unit goes to the program
    await browser.run(`document.querySelector('[data-field="contact.preload"]').value = "";`);
    await browser.type('[data-field="contact.preload"]', "0.035 kN\uE007");
    await browser.wait("return location.hash.includes('contact.preload=35');");
    await settled();
    const options = ["simulate", "-", "--json", "--set", "contact.preload=35"];
    const { phases } = JSON.parse(execFileSync(program, options, { input: execFileSync(program, ["init", "squeal"]) }));
    const { verdict } = phases.find(({ phase }) => phase === "going");
    assert.equal(await browser.run("return document.querySelector('#verdict').dataset.going;"), verdict.category);

    // a slider is moved by the keyboard
    await browser.type('input[type="range"][data-key="contact.kinetic_friction"]', "\uE012\uE012\uE012");
    await browser.wait("return location.hash.includes('kinetic_friction');");
    await settled();

    // each view, fetched when it is looked at
    const views = await browser.run(
      "return [...document.querySelectorAll('[data-view]')].map((tab) => tab.dataset.view);",
    );
    assert.ok(views.length >= 6, views.join());
    for (const view of views) {
      await browser.click(`#tab-${view}`);
      await browser.wait("return document.querySelector('#view-' + arguments[0])?.childElementCount > 0;", view);
    }
    await browser.wait("return document.querySelectorAll('#margins [data-margin]').length > 3;");
    await browser.click("#tab-listen");
    await browser.wait("return document.querySelector('#audio-A').readyState >= 2;");
    // decoded; there may be no device to hear it by
    const seconds = await browser.run("return document.querySelector('#audio-A').duration;");
    assert.ok(seconds > 0.5, String(seconds));

    // the tour: predicted, done, judged by the model
    await browser.click("#tour-button");
    await browser.wait("return document.querySelector('#tour [data-answer]');");
    await browser.click('#tour [data-answer="squeal"]');
    await browser.click("#tour-do");
    await browser.wait("return /^✓/.test(document.querySelector('#tour-result').textContent);");
    await browser.click("#tour-leave");

    // narrow, dark
    await browser.resize({ width: 450, height: 900 });
    await browser.click("#theme");
    await browser.click("#theme");
    assert.equal(await browser.run("return document.documentElement.dataset.theme;"), "dark");
    const inner = await browser.run("return innerWidth;");
    const scroll = await browser.run("return document.documentElement.scrollWidth;");
    assert.ok(scroll <= inner, `${scroll} px wide in ${inner}`);
    if (process.env.STRIDOR_PICTURE) await browser.picture(process.env.STRIDOR_PICTURE);

    assert.deepEqual(await browser.sins(explorer.origin), []);
  } finally {
    await browser.close();
    await explorer.stop();
  }
});
