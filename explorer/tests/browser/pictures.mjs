// The pictures of the page in docs/figures: `node tests/browser/pictures.mjs ../docs/figures`.
import { execFileSync } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { openPage, program, startExplorer } from "./session.mjs";

const folder = process.argv[2];
if (!folder) throw new Error("say which folder the pictures go to");
const own = await mkdtemp(join(tmpdir(), "stridor-pictures-"));
const string = join(own, "string.toml");
// Schelleng's diagram, of runs that are short enough to wait for
const chart = `
[chart]
x = { parameter = "contact.preload", from = "0.1 N", to = "10 N", points = 16, scale = "log" }
y = { parameter = "structure.position", from = 0.04, to = 0.3, points = 16, scale = "log" }
refine = 2
`;
const text = execFileSync(program, ["init", "string"], { encoding: "utf8" });
const short = text.replace(/^duration = .*$/m, 'duration = "0.5 s"').replace(/^window = .*$/m, 'window = "0.4 s"');
await writeFile(string, short + chart);

const stribeck =
  "#preset=squeal&contact.friction=stribeck&contact.stribeck_velocity=0.05&contact.viscous_friction=0.4" +
  "&run.duration=0.4&run.window=0.4";
const small = "x=contact.preload:1:80:6:linear&y=contact.stribeck_velocity:0.005:0.5:6:log";

for (const [name, colorScheme, tab, files, fragment] of [
  ["explorer", "light", "response", []],
  ["explorer-quiet", "dark", "quiet", []],
  ["explorer-friction", "light", "friction", [], `${stribeck}&${small}`],
  ["explorer-string", "light", "response", [string]],
]) {
  if (process.argv[3] && process.argv[3] !== name) continue;
  const explorer = await startExplorer(files);
  const browser = await openPage(explorer, { colorScheme });
  const { page } = browser;
  await browser.goto(fragment);
  await page.waitForSelector('#chart[data-done="true"]', { timeout: 600000 });
  await page.locator(`#tab-${tab}`).click();
  const drawn = { quiet: "#apply-change", friction: ".grip" };
  await page.waitForSelector(drawn[tab] ?? '.response[data-draws]:not([data-draws="0"])', { timeout: 60000 });
  await page.waitForTimeout(2000); // fine samples and the last paint
  await page.screenshot({ path: join(folder, `${name}.png`) });
  await browser.close();
  await explorer.stop();
}
await rm(own, { recursive: true, force: true });
