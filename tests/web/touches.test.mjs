// Tests of touches of holes: those of a file calibrate the base, entered ones can be corrected, and a plan follows the
// base.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {it} from "./limits.mjs";
import {begin, callApi, closable, drop, ended, finish, openTab, serve, stateOf} from "./workbench.mjs";

const LIMIT = {timeout: 60_000};

let setting, text;
before(async () => {
  setting = await begin();
  const server = await serve(setting.made.folder, "mockup.yaml");
  for (const hole of [500, 2500, 4000]) await callApi(server, "touch", {hole, simulate: true});
  text = (await (await fetch(`${server.address}api/export/touches.csv`)).text()).replace(/^#.*\n/, "");
  await server.stop();
});
after(() => finish(setting));

async function opened(view) {
  const server = await serve(setting.made.folder, "mockup.yaml");
  return closable(await openTab(setting.browser, `${server.address}#${view}`), server);
}

describe("touches of holes", () => {
  it("in a dropped file calibrate the base", async () => {
    const {tab, server, close} = await opened("arm");
    await tab.waitForSelector(".view-arm .slider");
    await drop(tab, "touches.csv", text);
    await tab.waitForFunction(() => document.querySelectorAll(".touch-row.done").length === 3, null, LIMIT);
    await tab.click(".touch-list > .button.first:not([disabled])");
    await tab.waitForSelector(".calibrate-view h3 >> text=Residual at each touch", LIMIT);
    assert.equal((await stateOf(server)).models.at(-1).base.touches, 3);
    await close();
  });

  it("are corrected in place, with their load", async () => {
    const {tab, server, close} = await opened("calibrate");
    for (const hole of [500, 2500]) await callApi(server, "touch", {hole, simulate: true, load: 20});
    const [first] = (await callApi(server, "touches")).body.touches;
    await tab.click("button.joint-list >> nth=0");
    const fields = tab.locator(".touch-row:not(.done) input");
    assert.ok(Math.abs(Number(await fields.nth(1).inputValue()) - first.joints[1]) < 1e-5);
    await fields.nth(0).fill("12,5");
    await tab.click(".touch-row:not(.done) >> text=Enter");
    await tab.waitForSelector(".touch-row.done >> text=12.50");
    const touches = (await callApi(server, "touches")).body.touches;
    assert.deepEqual(
      touches.map(({hole, load, simulated}) => [hole, Math.round(load), simulated]),
      [
        [2500, 20, true],
        [500, 20, false],
      ],
    );
    await close();
  });

  it("make a plan of before out of date, which can be made again", async () => {
    const {tab, server, close} = await opened("plan");
    assert.equal(await ended(server, (await callApi(server, "plan", {tubes: "spread:4"})).body.id), "done");
    await tab.waitForSelector(".tube-rows .tube-row >> text=not known", LIMIT);
    for (const hole of [500, 2500, 4000]) await callApi(server, "touch", {hole, simulate: true});
    assert.equal(await ended(server, (await callApi(server, "calibrate", {})).body.id), "done");
    await tab.click(".standing >> text=Plan again");
    await tab.waitForSelector(".standing >> text=Proved for the base calibrated from 3 touches", LIMIT);
    assert.equal(await tab.locator(".tube-rows .tube-row >> text=not known").count(), 0);
    await close();
  });
});
