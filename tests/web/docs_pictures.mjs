// Makes the pictures of the documents: `node tests/web/docs_pictures.mjs` (make pictures). They show the workbench with
// a diagnosis, the sheet of the demo's report before and after, and the reachable holes of the sheet in the four
// scenes.
import {execFileSync} from "node:child_process";
import {readFileSync} from "node:fs";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {launch, makeFolder, openTab, program, serve, simulate, source} from "./workbench.mjs";

const SCENES = ["blocked-manway", "moved-nozzle-dam", "stay-cylinder", "upside-down"];
const LIMIT = {timeout: 120_000};

const docs = (name) => path.join(source, "docs", name);

function plan(folder, cell, words) {
  const out = path.join(folder, `plan-of-${path.basename(cell, ".yaml")}`);
  execFileSync(program, ["plan", path.join(folder, cell), ...words, "--out", out], {stdio: "pipe"});
  return pathToFileURL(path.join(out, "report.html")).href;
}

async function workbench(browser, folder) {
  const readings = simulate(folder, "readings", {hide: "encoder-eccentricity@theta3:0.16deg"});
  const {address, stop} = await serve(folder, "bench.yaml", [readings]);
  const tab = await openTab(browser, `${address}#error`);
  await tab.click(".next:has-text('Diagnose'):not([disabled])", LIMIT);
  await tab.waitForSelector(".next:has-text('Add'):not([disabled])", LIMIT);
  await tab.waitForSelector(".ladder-row >> text=as given, rigid", LIMIT);
  await tab.click(".tabs >> text=Joints");
  await tab.mouse.move(1270, 50);
  await tab.waitForTimeout(2000); // until animations have ended
  await tab.screenshot({path: docs("workbench.png")});
  await tab.context().close();
  await stop();
}

async function reportOfDemo(browser, folder) {
  // The picture shows the output of the Makefile's target `demo`.
  execFileSync("make", ["-C", source, "-o", "program", "demo", `OUT=${folder}/demo`, `BUILD=${path.dirname(program)}`]);
  const address = pathToFileURL(path.join(folder, "demo/report.html")).href;
  const tab = await openTab(browser, address, {viewport: {width: 1280, height: 900}});
  await tab.waitForTimeout(1000);
  await tab
    .locator("#sheet .pair")
    .first()
    .screenshot({path: docs("report.png")});
  await tab.context().close();
}

/** Takes pictures of each scene's sheet, and of all four on one page. */
async function scenes(browser, folder) {
  const sheets = [];
  for (const scene of SCENES) {
    const address = plan(folder, `scenes/${scene}.yaml`, ["--tubes", "every:20", "--seed", "1"]);
    const tab = await openTab(browser, address, {viewport: {width: 560, height: 900}});
    await tab.waitForTimeout(1000);
    const card = tab.locator("#sheet .card:has(canvas), #sheet .card:has(svg)").first();
    sheets.push({scene, picture: (await card.screenshot()).toString("base64")});
    await tab.context().close();
  }
  const cells = sheets.map(
    ({scene, picture}) =>
      `<figure><figcaption>${scene}</figcaption><img src="data:image/png;base64,${picture}"></figure>`,
  );
  const tab = await browser.newPage({viewport: {width: 1100, height: 900}});
  await tab.setContent(
    `<style>body { margin: 0 } main { display: grid; grid-template-columns: 1fr 1fr; gap: 8px; width: 1060px;
     font: 14px sans-serif } figure { margin: 0 } figcaption { text-align: center; padding: 4px } img { width: 526px }
     </style><main>${cells.join("")}</main>`,
  );
  await tab.locator("main").screenshot({path: docs("scenes.png")});
  await tab.close();
}

const {folder, remove} = makeFolder();
const browser = await launch();
try {
  for (const take of [workbench, reportOfDemo, scenes]) await take(browser, folder);
} finally {
  await browser.close();
  remove();
}
