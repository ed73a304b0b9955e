// Tests of the views: their order and keys, and which of them a cell without a sheet offers.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {it} from "./limits.mjs";
import {begin, closable, finish, openTab, serve} from "./workbench.mjs";

let setting;
before(async () => (setting = await begin()));
after(() => finish(setting));

async function open(cell, more = []) {
  const server = await serve(setting.made.folder, cell, more);
  return closable(await openTab(setting.browser, server.address), server);
}

const namesOf = (tab) => tab.locator(".rail-entry span").allInnerTexts();

describe("the views", () => {
  it("stand in the order of the work, each with its key", async () => {
    const {tab, close} = await open("mockup.yaml");
    await tab.waitForSelector(".sheet-view");
    assert.deepEqual(await namesOf(tab), ["Sheet", "Arm", "Calibrate", "Error", "Effects", "Plan"]);
    await tab.keyboard.press("6");
    await tab.waitForSelector(".plan-view");
    await tab.keyboard.press("3");
    await tab.waitForSelector(".calibrate-view");
    await close();
  });

  it("are those that a cell without a sheet can use", async () => {
    const {tab, close} = await open("bench.yaml");
    await tab.waitForSelector(".view-error");
    assert.deepEqual(await namesOf(tab), ["Arm", "Error", "Effects"]);
    assert.equal(await tab.locator(".rail-entry[tabindex='0']").count(), 1);
    await tab.keyboard.press("1");
    await tab.waitForSelector(".arm-view");
    await close();
  });
});
