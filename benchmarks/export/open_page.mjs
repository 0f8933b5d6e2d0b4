// Opens pages of `mansion view` in a real browser, without a network, and uses them as a person would.
//
//     npm install playwright-core            (anywhere; then NODE_PATH=that folder's node_modules)
//     node benchmarks/export/open_page.mjs [--browser /usr/bin/chromium] [--pictures DIR] out/office/view.html ...
//
// Prints a line for each page, and exits with 1 when a page reports an error, asks the network for anything, or does not answer.

import { mkdtempSync, mkdirSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const { chromium } = createRequire(import.meta.url)("playwright-core");

const pages = [];
const options = { browser: "/usr/bin/chromium", pictures: "" };
const words = process.argv.slice(2);
while (words.length) {
  const word = words.shift();
  if (word.startsWith("--")) options[word.slice(2)] = words.shift();
  else pages.push(word);
}
if (options.pictures) mkdirSync(options.pictures, { recursive: true });

const WINDOWS = [
  { name: "desk", viewport: { width: 1280, height: 800 } },
  { name: "phone", viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 },
];
const FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync"];

const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

async function use(page, path, shape, faults) {
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || faults.push(`asked for ${request.url()}`));
  const start = Date.now();
  await page.goto(pathToFileURL(resolve(path)).href);
  await page.waitForFunction("window.mansion", null, { timeout: 60_000 });
  await drawn(page);
  const seconds = (Date.now() - start) / 1000;
  const picture = async (name) => {
    await drawn(page);
    if (options.pictures) await page.screenshot({ path: join(options.pictures, `${basename(path, ".html")}_${shape.name}_${name}.png`) });
  };
  await picture("start");
  const middle = [shape.name === "desk" ? 760 : 195, 420];
  if (shape.hasTouch) {
    await page.touchscreen.tap(...middle);
    await page.touchscreen.tap(30, 30);
    if (!(await page.isVisible("#panel"))) faults.push("the panel does not unfold");
  } else {
    await page.mouse.click(...middle);
    await page.mouse.move(middle[0] + 40, middle[1] + 20);
    await page.waitForSelector("#tip:not([hidden])", { timeout: 10_000 }).catch(() => faults.push("no name on pointing"));
  }
  const picked = (await page.textContent("#picked_id")) || "nothing";
  const floors = await page.$$("#floors .floor button");
  if (floors.length > 1) {
    await floors[0].click();
    const shown = await page.evaluate(() => document.querySelectorAll("#floors input:checked").length);
    if (shown !== 1) faults.push(`${shown} floors are shown, not one`);
  }
  await page.click("#above");
  await picture("above");
  await page.click("#reset");
  await picture("reset");
  const objects = await page.evaluate(() => window.mansion.building.items.filter((item) => item.group === "objects").length);
  console.log(`${path} (${shape.name}): ${floors.length || 1} floors, ${objects} objects, shown after ${seconds.toFixed(1)} s, clicked ${picked}`);
}

let failed = false;
for (const shape of WINDOWS) {
  const { name, ...context } = shape;
  const profile = mkdtempSync(join(tmpdir(), "page-"));
  const browser = await chromium.launchPersistentContext(profile, { executablePath: options.browser, headless: true, args: FLAGS, ...context });
  for (const path of pages) {
    const faults = [];
    const page = await browser.newPage();
    await use(page, path, shape, faults);
    await page.close();
    for (const fault of faults) console.log(`  fault: ${fault}`);
    failed ||= faults.length > 0;
  }
  await browser.close();
  rmSync(profile, { recursive: true, force: true });
}
process.exit(failed ? 1 : 0);
