// Tests that four clicks suffice to find every effect of the catalogue. Readings that hide an effect are opened with
// `tubeplan serve CELL READINGS`, and the page is clicked until the error has fallen. The output is a table: the effect
// found, the variable on which the plot opened, the promised error and the remaining error. Exits with 1 if a remaining
// error is not within 5 % of the promised error.
//   node tests/web/four_clicks.mjs [EFFECT ...]
import path from "node:path";
import {readFileSync} from "node:fs";
import {launch, makeFolder, openTab, serve, simulate, source, writeDesign, writeWeightless} from "./workbench.mjs";

const MOST_CLICKS = 4;
const NEAR = 0.05; // relative tolerance of the promised error
const LIMIT = {timeout: 180_000};
const rows = JSON.parse(readFileSync(path.join(source, "app/web/tests/hidden_effects.json"), "utf8"));
const names = process.argv.slice(2);

const idle = (tab) => tab.waitForFunction(() => !document.querySelector(".job"), null, LIMIT);
const variable = (tab) => tab.locator("select[aria-label='Variable']").inputValue();

/** Returns the index of the card of the hidden effect; 0 if the effect has none. */
async function cardOf(tab, name) {
  const titles = await tab.locator(".explanation-words > b").allInnerTexts();
  const words = name.replace("@", " at ");
  const exact = titles.indexOf(words);
  return exact >= 0
    ? exact
    : Math.max(
        0,
        titles.findIndex((title) => title.includes(words)),
      );
}

const heldOut = async (tab) =>
  parseFloat((await tab.locator(".ladder-row.now .bar-text").last().innerText()).replace(/,/g, ""));

async function run(browser, folder, row, index) {
  const {hide, beside} = row,
    name = hide.split(":")[0],
    cell = row.weightless ? writeWeightless(folder, row.cell ?? "bench") : (row.cell ?? "bench");
  const design = row.kind ? writeDesign(folder, row.kind) : "bench";
  const options = {hide, beside, design, cell: `${cell}.yaml`, spread: row.cell ? "0" : "0.1"};
  const file = simulate(folder, `hidden-${index}`, options);
  const server = await serve(folder, `${cell}.yaml`, [file]);
  const tab = await openTab(browser, server.address);
  let clicks = 0;
  const click = (selector) => (++clicks, tab.click(selector, LIMIT));
  try {
    await tab.waitForSelector(".rail-entry");
    await tab.waitForSelector(".error-view", {timeout: 5000}).catch(() => click(".rail-entry:has-text('Error')"));
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    await idle(tab);
    const before = await heldOut(tab);
    await click(".next:has-text('Diagnose')");
    await tab.waitForSelector(".explanation, .ranking", LIMIT);
    await idle(tab);
    const verdict = await tab.innerText(".verdict h1");
    const k = await cardOf(tab, name);
    const found = await tab.locator(".explanation-words > b").nth(k).innerText();
    const promised = parseFloat(
      /leaves ([\d.e−-]+)/.exec(await tab.locator(".explanation-words").nth(k).innerText())?.[1],
    );
    const opened = await variable(tab);
    const isOwn = new RegExp(row.opens_on).test(opened);
    const models = await tab.locator(".ladder-row").count();
    await click(`.explanation >> nth=${k} >> .button:has-text('Add')`);
    await tab.waitForFunction((n) => document.querySelectorAll(".ladder-row").length > n, models, LIMIT);
    await idle(tab);
    const left = await heldOut(tab);
    const share = left / promised - 1;
    return {
      hidden: name,
      verdict,
      found,
      clicks,
      opened,
      before,
      promised,
      left,
      share,
      fails: clicks > MOST_CLICKS || !(Math.abs(share) <= NEAR) || !isOwn || tab.errors.length > 0,
      errors: tab.errors.join("; "),
    };
  } finally {
    await tab.context().close();
    await server.stop();
  }
}

const {folder, remove} = makeFolder();
const browser = await launch();
let failed = 0;
try {
  console.log("| hidden | verdict | added | clicks | plot opens on | before | promised | left | off |");
  console.log("|---|---|---|---|---|---|---|---|---|");
  for (const [index, row] of rows.entries()) {
    if (names.length > 0 && !names.some((name) => row.hide.startsWith(name))) continue;
    try {
      const it = await run(browser, folder, row, index);
      failed += it.fails ? 1 : 0;
      console.log(
        `| ${it.hidden} | ${it.verdict} | ${it.found} | ${it.clicks} | ${it.opened} | ${it.before} | ${it.promised} | ` +
          `${it.left} | ${(100 * it.share).toFixed(1)} %${it.fails ? " (!)" : ""} | ${it.errors}`,
      );
    } catch (error) {
      ++failed;
      console.log(`| ${row.hide} | ${error.message.split("\n")[0]} |`);
    }
  }
} finally {
  await browser.close();
  remove();
}
process.exit(failed > 0 ? 1 : 0);
