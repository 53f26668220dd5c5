// The pictures of the page in docs/figures: `node tests/browser/pictures.mjs ../docs/figures`.
import { join } from "node:path";
import { openPage, startExplorer } from "./session.mjs";

const folder = process.argv[2];
if (!folder) throw new Error("say which folder the pictures go to");

const explorer = await startExplorer();
for (const [name, colorScheme, tab] of [
  ["explorer", "light", "response"],
  ["explorer-quiet", "dark", "quiet"],
]) {
  const browser = await openPage(explorer, { colorScheme });
  const { page } = browser;
  await browser.goto();
  await page.waitForSelector('#chart[data-done="true"]');
  await page.locator(`#tab-${tab}`).click();
  await page.waitForSelector(tab === "quiet" ? "#apply-change" : '.response[data-draws]:not([data-draws="0"])', {
    timeout: 60000,
  });
  await page.waitForTimeout(2000); // fine samples and the last paint
  await page.screenshot({ path: join(folder, `${name}.png`) });
  await browser.close();
}
await explorer.stop();
