// Tests of the page for people who use a screen reader or the keyboard: every view and dialog is checked by axe-core.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import path from "node:path";
import {after, before, describe} from "node:test";
import {it} from "./limits.mjs";
import {begin, callApi, ended, finish, openTab, serve, simulate, web} from "./workbench.mjs";

const axe = readFileSync(path.join(web, "node_modules/axe-core/axe.min.js"), "utf8");
const GRAVE = new Set(["moderate", "serious", "critical"]);

let setting, server, tab;
before(async () => {
  setting = await begin();
  simulate(setting.made.folder, "readings", {cell: "mockup.yaml", design: "bowl", readings: 40, spread: "0"});
  server = await serve(setting.made.folder, "mockup.yaml", [path.join(setting.made.folder, "readings.csv")]);
  tab = await openTab(setting.browser, server.address);
  await tab.evaluate(`${axe}; undefined`);
});
after(async () => {
  await server?.stop();
  await finish(setting);
});

/** Returns the findings of axe-core that are at least moderate on the present page, one line for each. */
async function findings() {
  const {violations} = await tab.evaluate(() => window.axe.run(document, {resultTypes: ["violations"]}));
  return violations
    .filter(({impact}) => GRAVE.has(impact))
    .flatMap(({id, nodes}) => nodes.map(({html}) => `${id}: ${html.slice(0, 160)}`));
}

describe("axe-core has no finding that is more than minor", () => {
  for (const scheme of ["light", "dark"])
    for (const view of ["sheet", "arm", "calibrate", "error", "effects", "plan"])
      it(`in the ${view} view, ${scheme}`, async () => {
        await tab.evaluate((name) => (location.hash = name), view);
        await tab.waitForSelector(`.view-${view} .panel, .view-${view} .nothing`);
        if ((await tab.evaluate(() => document.documentElement.dataset.scheme)) !== scheme)
          await tab.keyboard.press("d");
        await tab.waitForFunction(() => !document.querySelector(".busy"));
        await tab.waitForTimeout(300); // until transitions have ended
        assert.deepEqual(await findings(), []);
      });

  it("in the dialogs", async () => {
    for (const key of ["o", "?", "Control+s"]) {
      await tab.keyboard.press(key);
      await tab.waitForSelector("dialog[open]");
      assert.deepEqual(await findings(), []);
      await tab.keyboard.press("Escape");
      await tab.waitForSelector("dialog[open]", {state: "detached"});
    }
  });

  it("in the menus of the header, which the keyboard opens and closes", async () => {
    for (const menu of [".unit-menu", ".project-tools .menu", ".model-steps"]) {
      await tab.focus(`.header ${menu} summary`);
      await tab.keyboard.press("Enter");
      await tab.waitForSelector(`.header ${menu}[open]`);
      assert.deepEqual(await findings(), []);
      await tab.keyboard.press("Tab");
      assert.ok(await tab.evaluate((name) => document.activeElement.closest(name) !== null, menu), menu);
      await tab.keyboard.press("Escape");
      await tab.waitForSelector(`.header ${menu}:not([open])`);
    }
  });

  it("in the plan view with a plan, whose table has cells", async () => {
    assert.equal(await ended(server, (await callApi(server, "plan", {tubes: "spread:6"})).body.id), "done");
    await tab.evaluate(() => (location.hash = "plan"));
    await tab.waitForSelector(".tube-rows .tube-row");
    const columns = await tab.locator(".tube-table [role=columnheader]").count();
    assert.equal(await tab.locator(".tube-rows .tube-row >> nth=0").locator("[role=cell]").count(), columns);
    for (const name of ["Tubes by chance", "Clearance"]) {
      await tab.click(`.plan-view .segments >> text=${name}`);
      assert.deepEqual(await findings(), [], name);
    }
  });

  it("in the tabs of the error view after a diagnosis", async () => {
    await tab.evaluate(() => (location.hash = "error"));
    await tab.click(".next:has-text('Diagnose'):not([disabled])");
    await tab.waitForSelector(".ranking", {timeout: 120_000});
    for (const name of await tab.locator("[role=tab]").allInnerTexts()) {
      await tab.click(`[role=tab]:has-text("${name}")`);
      assert.deepEqual(await findings(), [], name);
    }
  });
});

describe("the header in the window of a telephone", () => {
  const MENUS = {".unit-menu": ".unit-panel", ".project-tools .menu": "ul", ".model-steps": ".model-panel"};

  /** Returns the controls of the header that are too small for a finger or not all within the window. */
  const poor = () =>
    tab.evaluate(() =>
      [...document.querySelectorAll(".header :is(button, summary, a)")]
        .filter((control) => control.checkVisibility())
        .map((control) => [control.textContent || control.title, control.getBoundingClientRect()])
        .filter(([, {left, right, width, height}]) => left < 0 || right > innerWidth || width < 40 || height < 40)
        .map(([words]) => words),
    );

  for (const width of [360, 400, 480, 600])
    it(`has targets of 40 px, of which none is cut off, at ${width} px`, async () => {
      await tab.setViewportSize({width, height: 760});
      await tab.waitForTimeout(300); // until the layout has settled
      assert.deepEqual(await poor(), []);
      for (const [menu, panel] of Object.entries(MENUS)) {
        await tab.click(`.header ${menu} summary`);
        const {x, width: wide} = await tab.locator(`.header ${menu} ${panel}`).first().boundingBox();
        assert.ok(x >= 0 && x + wide <= width, `${menu}: ${x} to ${x + wide}`);
        assert.deepEqual(await poor(), [], menu);
        await tab.keyboard.press("Escape");
      }
      assert.deepEqual(await findings(), []);
    });
});
