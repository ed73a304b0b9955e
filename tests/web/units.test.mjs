// Tests of the units that the page shows: chosen once for all views, stored, and applied to typed numbers.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import path from "node:path";
import {it} from "./limits.mjs";
import {begin, callApi, ended, finish, openTab, serve, simulate, stateOf} from "./workbench.mjs";

const VIEWS = ["sheet", "arm", "calibrate", "error", "effects", "plan"];
/** A figure with a unit of the cell's file; "in" may also be the word. */
const OF_FILE = /[\d.] (in(?! (\d|the|all|each|every|which|a)\b)|deg)(?![\w/*])/;

let setting, server, tab;
before(async () => {
  setting = await begin();
  simulate(setting.made.folder, "readings", {
    cell: "mockup.yaml",
    design: "bowl",
    readings: 60,
    spread: "0",
    hide: "hysteresis@theta4:0.06deg",
  });
  server = await serve(setting.made.folder, "mockup.yaml", [path.join(setting.made.folder, "readings.csv")]);
  for (const name of ["compare", "diagnose"])
    assert.equal(await ended(server, (await callApi(server, name, {effects: 1, next: 3})).body.id), "done");
  tab = await openTab(setting.browser, server.address);
});
after(async () => {
  await server?.stop();
  await finish(setting);
});

const buttonText = async () => (await tab.waitForSelector(".unit-menu summary")).innerText();

async function choose(group, unit) {
  await tab.click(".unit-menu summary");
  await Promise.all([
    tab.waitForEvent("load"),
    tab.click(`.unit-menu [aria-label='${group}'] button:text-is('${unit}')`),
  ]);
}

/** Returns the texts of the page in which a figure has a unit of the file. */
function textsInFileUnits() {
  return tab.evaluate((pattern) => {
    const texts = document.querySelector("main").innerText.split("\n");
    const titles = [...document.querySelectorAll("main [title], main [aria-label]")].flatMap((one) => [
      one.title,
      one.ariaLabel ?? "",
    ]);
    return [...texts, ...titles].filter((text) => new RegExp(pattern).test(text));
  }, OF_FILE.source);
}

describe("the units of the page", () => {
  it("are those of the file until others are chosen, which are kept", async () => {
    assert.match(await buttonText(), /in · deg/);
    await choose("Lengths", "mm");
    assert.match(await buttonText(), /mm · deg/);
    await choose("Angles", "rad");
    assert.match(await buttonText(), /mm · rad/);
    await tab.reload();
    assert.match(await buttonText(), /mm · rad/);
  });

  it("can be each of the program's", async () => {
    const {unit_table} = await stateOf(server);
    assert.equal(unit_table.length.find(({name}) => name === "in").factor, 0.0254);
    for (const [group, kind] of [
      ["Lengths", "length"],
      ["Angles", "angle"],
    ]) {
      const [, ...words] = await tab.locator(`.unit-menu [aria-label='${group}'] button`).allTextContents();
      const names = unit_table[kind].map(({name}) => name);
      assert.deepEqual(words, names, "after that of the file");
    }
  });

  it("are those of the file again where the program does not know the kept ones", async () => {
    const kept = await tab.evaluate(() => localStorage.getItem("tubeplan.units"));
    await tab.evaluate(() => localStorage.setItem("tubeplan.units", '{"length": "parsec", "angle": "rad"}'));
    await tab.reload();
    await tab.waitForSelector(".unit-menu summary:has-text('in · deg')");
    await tab.evaluate((text) => localStorage.setItem("tubeplan.units", text), kept);
    await tab.reload();
    assert.match(await buttonText(), /mm · rad/);
  });

  it("are shown in every view", async () => {
    for (const view of VIEWS) {
      await tab.evaluate((name) => (location.hash = name), view);
      await tab.waitForSelector(`.view-${view} .panel, .view-${view} .nothing`);
      await tab.waitForFunction(() => !document.querySelector(".busy"));
      await tab.waitForTimeout(500);
      if (process.env.PICTURES) await tab.screenshot({path: `${process.env.PICTURES}/units-${view}.png`});
      assert.deepEqual(await textsInFileUnits(), [], view);
    }
  });

  it("are those of a number that is typed", async () => {
    await tab.evaluate(() => (location.hash = "arm"));
    const theta1 = tab.locator(".view-arm input[aria-label^='theta1']:not([type=range])").first();
    const [request] = await Promise.all([
      tab.waitForRequest((one) => one.url().includes("/api/pose") && one.postDataJSON().joints[0] === 0.5),
      theta1.fill("0.5").then(() => theta1.press("Enter")),
    ]);
    const shown = await (await request.response()).json();
    const own = await callApi(server, "pose", {
      ...request.postDataJSON(),
      joints: request.postDataJSON().joints.map((angle) => (angle * 180) / Math.PI),
    });
    assert.equal(shown.units.length, "mm");
    shown.tip.flexible.forEach((x, k) => assert.ok(Math.abs(x - 25.4 * own.body.tip.flexible[k]) < 1e-6));
  });
});
