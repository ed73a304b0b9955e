// Tests of the views: their order and keys, and which of them a cell without a sheet offers.
import assert from "node:assert/strict";
import {statSync} from "node:fs";
import {after, before, describe} from "node:test";
import {it} from "./limits.mjs";
import {begin, callApi, closable, finish, openTab, serve} from "./workbench.mjs";

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

describe("the splitters", () => {
  it("are moved by drag and keys, and stay where they were after a reload", async () => {
    const {tab, close} = await open("mockup.yaml");
    await tab.goto(`${tab.url().split("#")[0]}#plan`);
    const widthOf = async () => (await tab.locator(".plan-view > .panel >> nth=0").boundingBox()).width;
    await tab.waitForSelector(".plan-view .splitter.plan-columns");
    const before = await widthOf();
    const bar = await tab.locator(".splitter.plan-columns").boundingBox();
    await tab.mouse.move(bar.x + bar.width / 2, bar.y + 40);
    await tab.mouse.down();
    await tab.mouse.move(bar.x + bar.width / 2 - 150, bar.y + 60, {steps: 5});
    await tab.mouse.up();
    const dragged = await widthOf();
    assert.ok(Math.abs(before - 150 - dragged) < 12, `${before} px become ${dragged} px`);
    await tab.focus(".splitter.plan-columns");
    await tab.keyboard.press("ArrowLeft");
    const moved = await widthOf();
    assert.ok(moved < dragged - 5);
    await tab.reload();
    await tab.waitForSelector(".plan-view .splitter.plan-columns");
    assert.ok(Math.abs((await widthOf()) - moved) < 2);
    await close();
  });
});

describe("the arm", () => {
  it("opens in its park posture, shows the names of its joints, and is saved as a picture", async () => {
    const {tab, server, close} = await open("mockup.yaml");
    const {park, joints} = (await callApi(server, "state")).body.cell;
    await tab.keyboard.press("2");
    await tab.waitForSelector(".arm-view .slider");
    for (const [k, value] of park.entries()) {
      const shown = Number(await tab.inputValue(`.slider input[type=range] >> nth=${k}`));
      assert.ok(Math.abs(shown - value) < 0.1, `joint ${k} at ${shown}`); // the slider has steps
    }
    await tab.check(".stage-bar label:has-text('axes') input");
    await tab.waitForFunction(
      (count) => document.querySelectorAll(".joint-names span").length === count,
      joints.length,
    );
    assert.deepEqual(
      await tab.locator(".joint-names span").allTextContents(),
      joints.map(({name}) => name),
    );
    const [download] = await Promise.all([
      tab.waitForEvent("download"),
      tab.click(".stage-bar button:has-text('Picture')"),
    ]);
    assert.match(download.suggestedFilename(), /-arm\.png$/);
    assert.ok(statSync(await download.path()).size > 10_000, "the picture is not empty");
    await close();
  });
});

/** Returns the fraction of the 3-D picture's pixels that are clearly blue, as the arm is. */
async function blueShare(tab) {
  await tab.waitForTimeout(900); // until a sharp picture is drawn
  const bytes = [...(await tab.locator(".arm-picture canvas").screenshot())];
  return tab.evaluate(async (png) => {
    const picture = await createImageBitmap(new Blob([new Uint8Array(png)], {type: "image/png"}));
    const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
    context.drawImage(picture, 0, 0);
    const {data} = context.getImageData(0, 0, picture.width, picture.height);
    let blue = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 2] - data[i] > 80) ++blue;
    return (4 * blue) / data.length;
  }, bytes);
}

describe("the way back", () => {
  it("leads to the park posture, where nothing collides, and each figure of the read-out has its unit", async () => {
    const {tab, server, close} = await open("mockup.yaml");
    const {park, joints, units} = (await callApi(server, "state")).body.cell;
    await tab.waitForSelector(".sheet-view");
    await tab.keyboard.press("2");
    await tab.waitForSelector(".arm-view .slider");
    const first = tab.getByLabel(`${joints[0].name}, as a number`);
    await first.fill(String(park[0] + 30));
    await first.press("Enter");
    await tab.waitForFunction((k) => Number(document.querySelector(".slider .number-box").value) === k, park[0] + 30);
    await tab.click(".arm-view button:has-text('park')");
    await tab.waitForFunction((k) => Number(document.querySelector(".slider .number-box").value) === k, park[0]);
    await tab.waitForTimeout(500);
    const {clearance} = (await callApi(server, "pose", {joints: park})).body;
    assert.ok(clearance.distance > 0, "the park posture is free");
    assert.equal(await tab.locator(".arm-view dd .bad").count(), 0);
    for (const name of ["sag", "from rigid", "clearance"])
      assert.match(
        await tab.locator(`.arm-view dt:text-is("${name}") + dd`).first().innerText(),
        new RegExp(`[0-9] ${units.length}$`),
      );
    await close();
  });
});

describe("the arm as a skeleton", () => {
  it("is drawn thinner than by its shapes, with the names of its joints, also in another view", async () => {
    const {tab, server, close} = await open("mockup.yaml");
    const {joints} = (await callApi(server, "state")).body.cell;
    await tab.waitForSelector(".sheet-view");
    await tab.keyboard.press("2");
    await tab.waitForSelector(".arm-view .slider");
    const shapes = await blueShare(tab);
    await tab.click(".stage-bar button:has-text('Skeleton')");
    await tab.waitForFunction(
      (count) => document.querySelectorAll(".joint-names span").length === count,
      joints.length,
    );
    const skeleton = await blueShare(tab);
    assert.ok(skeleton > 0 && skeleton < 0.8 * shapes, `${shapes} of the picture become ${skeleton}`);
    await tab.keyboard.press("6");
    await tab.waitForFunction(
      (count) => document.querySelectorAll(".plan-view .joint-names span").length === count,
      joints.length,
    );
    await tab.keyboard.press("2");
    await tab.click(".stage-bar button:has-text('Shapes')");
    await tab.waitForFunction(() => document.querySelectorAll(".joint-names span").length === 0);
    assert.ok(Math.abs((await blueShare(tab)) - shapes) < 0.1 * shapes, "the shapes are back");
    await close();
  });

  it("is not offered for an arm without shapes", async () => {
    const {tab, close} = await open("bench.yaml");
    await tab.waitForSelector(".view-error");
    await tab.keyboard.press("1");
    await tab.waitForSelector(".stage-bar");
    assert.equal(await tab.locator(".stage-bar button:has-text('Skeleton')").count(), 0);
    await close();
  });
});

describe("undo", () => {
  it("takes back a touch, and after it what was done before", async () => {
    const {tab, server, close} = await open("mockup.yaml");
    await tab.goto(`${server.address}#calibrate`);
    await tab.click(".calibrate-view >> text=Suggest");
    for (let k = 1; k <= 2; ++k) {
      await tab.click(".touch-row:not(.done) >> text=Simulate >> nth=0", {timeout: 60_000});
      await tab.waitForFunction((n) => document.querySelectorAll(".touch-row.done").length === n, k);
    }
    assert.equal(await tab.getAttribute("button[title^='Undo']", "title"), "Undo: touches (Ctrl+Z)");
    for (const left of [1, 0]) {
      await tab.click("button[title^='Undo']");
      await tab.waitForFunction((n) => document.querySelectorAll(".touch-row.done").length === n, left);
    }
    await tab.click("button[title^='Redo']");
    await tab.waitForFunction(() => document.querySelectorAll(".touch-row.done").length === 1);
    await close();
  });
});
