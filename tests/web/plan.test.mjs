// Tests of a session with the mock-up: holes are touched, the base is calibrated, sixty tubes are planned, the plan is
// played and exported, and a job is stopped.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {readFileSync} from "node:fs";
import path from "node:path";
import {it} from "./limits.mjs";
import {callApi, controlsCutOff, launch, makeFolder, openTab, serve} from "./workbench.mjs";

let made, server, browser, tab;

before(async () => {
  made = makeFolder();
  server = await serve(made.folder, "mockup.yaml", ["--truth", path.join(made.folder, "mockup-true.yaml")]);
  browser = await launch();
  tab = await openTab(browser, server.address);
});
after(async () => {
  await browser?.close();
  await server?.stop();
  made?.remove();
});

describe("the mock-up", () => {
  it("shows its sheet, and what a hole is", async () => {
    await tab.waitForSelector(".sheet-words >> text=4,674 holes");
    const {manway} = (await callApi(server, "sheet")).body;
    assert.ok(manway.u > 0 && manway.v > 0, "the manway is to the right, seen from below");
    await tab.focus(".stage");
    await tab.keyboard.press("ArrowUp");
    await tab.keyboard.press("Enter");
    await tab.waitForSelector(".side h2 >> text=/^R\\d+\\sC\\d+$/");
    await tab.waitForSelector(".side .figures dt >> text=theta4");
  });

  it("selects by ranges, and says why it cannot", async () => {
    await tab.fill(".select-box input", "R1-10C5-9");
    await tab.keyboard.press("Enter");
    await tab.waitForFunction(() =>
      /\d+ holes/.test(document.querySelector(".side .panel:nth-child(2) header b").textContent),
    );
    await tab.fill(".select-box input", "R1-C");
    await tab.keyboard.press("Enter");
    await tab.waitForSelector(".notice");
    await tab.keyboard.press("Tab");
    await tab.click(".notice .tool");
    tab.errors.length = 0;
  });

  it("selects with the lasso", async () => {
    await tab.click("button[title^='Lasso']");
    const box = await tab.locator(".stage").boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height * 0.6];
    await tab.mouse.move(x - 60, y - 40);
    await tab.mouse.down();
    for (const [dx, dy] of [
      [60, -40],
      [60, 40],
      [-60, 40],
      [-60, -35],
    ])
      await tab.mouse.move(x + dx, y + dy, {steps: 4});
    await tab.mouse.up();
    const count = Number((await tab.innerText(".side .panel:nth-child(2) header b")).replace(/\D/g, ""));
    assert.ok(count > 20 && count < 1500, `${count} holes lie in the lasso`);
  });

  it("is calibrated by three simulated touches", async () => {
    await tab.click(".rail-entry >> text=Calibrate");
    // The hole picked before has a separate row.
    const own = await tab.innerText(".touch-row:not(.done) > span >> nth=0");
    await tab.click(".calibrate-view >> text=Suggest");
    await tab.waitForFunction(
      (name) =>
        [...document.querySelectorAll(".touch-row:not(.done)")].filter(
          (row) => row.querySelector("span").textContent !== name,
        ).length === 3,
      own,
      {timeout: 60000},
    );
    for (let k = 1; k <= 3; ++k) {
      await tab.click(".touch-row:not(.done) >> text=Simulate >> nth=0");
      await tab.waitForFunction((n) => document.querySelectorAll(".touch-row.done").length === n, k);
    }
    await tab.click(".touch-list > .button.first");
    await tab.waitForSelector(".calibrate-view h3 >> text=Residual at each touch", {
      timeout: 60000,
    });
    assert.ok((await tab.locator(".covariance rect.cell").count()) === 21);
  });

  it("is planned, played and exported", async () => {
    await tab.click(".rail-entry >> text=Plan");
    await tab.fill(".select-box input", "spread:60");
    await tab.keyboard.press("Enter");
    await tab.waitForSelector(".plan-head .button.first >> text=Plan 60 tubes");
    await tab.click(".plan-head .button.first");
    await tab.waitForSelector(".tube-rows .tube-row", {timeout: 120000});
    await tab.waitForFunction(() => !document.querySelector("button.play").disabled, null, {timeout: 20000});
    const played = async () => Number(await tab.inputValue("[aria-label='Time along the tour']")); // [s]
    await tab.click(".segments >> text=×16");
    const started = Date.now();
    await tab.click("button.play");
    const begun = Date.now();
    await tab.waitForTimeout(3000);
    const stopped = Date.now();
    await tab.click("button.play");
    const most = (16 * (Date.now() - started)) / 1000 + 1,
      least = (0.6 * 16 * (stopped - begun)) / 1000; // the last picture may be drawn a second late
    const seconds = await played();
    assert.ok(seconds > least && seconds < most, `×16 plays ${seconds} s, which is not ${least} to ${most} s`);
    await tab.waitForFunction(() => /s: \d/.test(document.querySelector(".tour-figure").textContent));
    const read = () => tab.innerText(".tour-figure");
    const box = await tab.locator(".plot .u-over").boundingBox();
    const figures = new Set();
    for (let k = 1; k <= 8; ++k) {
      await tab.mouse.move(box.x + (k / 9) * box.width, box.y + box.height / 2);
      figures.add(/s: (\S+)/.exec(await read())[1]);
    }
    assert.ok(figures.size > 4, `the cursor reads ${[...figures].join(", ")}`);
    await tab.click(".plan-view .segments >> text=Tubes by chance");
    const planned = (await callApi(server, "results/plan")).body.tubes.length;
    await tab.waitForSelector(`[aria-label='Histogram of ${planned} tubes by the chance of all steps'] canvas`);
    await tab.click(".plan-view .menu summary");
    const [download] = await Promise.all([
      tab.waitForEvent("download"),
      tab.click(".plan-view .menu a[download='worklist.csv']"),
    ]);
    assert.equal(download.suggestedFilename(), "worklist.csv");
    assert.deepEqual(tab.errors, []);
  });

  it("is filmed, 1280 pixels wide and with its duration", async () => {
    const filming = tab.waitForEvent("download"),
      begin = Date.now();
    await tab.click(".transport >> text=Film");
    await tab.waitForTimeout(2500);
    assert.match(await tab.innerText(".recording"), /00:\d\d\.\d\s+\d+ pictures?/);
    const end = Number(await tab.getAttribute("[aria-label='Time along the tour']", "max"));
    const speed = Number((await tab.innerText(".transport .segments [aria-pressed=true]")).slice(1));
    assert.ok(end / speed <= 60, `a path of ${end} s is filmed at ${speed} times its speed`);
    await tab.click(".transport >> text=Film");
    const saved = await tab.locator(".note-of-success", {hasText: "Film saved"}).innerText();
    assert.match(saved, /path\.(webm|mp4): [\d.]+ s, [\d.]+ MB/);
    assert.equal(await tab.locator(".recording").count(), 0);
    const film = readFileSync(await (await filming).path()),
      elapsed = (Date.now() - begin) / 1000;
    const head = film.subarray(0, 400);
    assert.ok(head.includes(Buffer.from([0xb0, 0x82, 0x05, 0x00])), "the width of the video");
    const seconds = head.readDoubleBE(head.indexOf(Buffer.from([0x44, 0x89, 0x88])) + 3) / 1000;
    assert.ok(seconds > 2 && seconds < elapsed, `${seconds} s of ${elapsed} s`);
    assert.deepEqual(tab.errors, []);
  });

  it("lets a job be stopped", async () => {
    await tab.fill(".select-box input", "outer:4");
    await tab.keyboard.press("Enter");
    await tab.waitForFunction(
      () => !/Plan (0|60) tubes/.test(document.querySelector(".plan-head .button.first").textContent),
    );
    await tab.click(".plan-head .button.first");
    await tab.click(".job button[title='Stop']", {timeout: 20000});
    await tab.waitForSelector(".job", {state: "detached", timeout: 30000});
    await tab.waitForSelector(".plan-head .button.first:not([disabled])");
    assert.deepEqual(tab.errors, []);
  });

  it("goes straight from tube to tube where that is asked for", async () => {
    await tab.fill(".select-box input", "R20C30-39");
    await tab.keyboard.press("Enter");
    await tab.waitForSelector(".plan-head .button.first >> text=Plan 10 tubes");
    await tab.check(".plan-head label:has-text('straight') input");
    await tab.click(".plan-head .button.first");
    await tab.waitForSelector(".outcome >> text=/straight \\d/", {timeout: 60000});
    const {travel} = (await callApi(server, "results/plan")).body;
    assert.equal(travel.kind, "line");
    assert.ok(travel.on_line >= 5 && travel.line_deviation <= 0.002, JSON.stringify(travel));
    await tab.uncheck(".plan-head label:has-text('straight') input");
    assert.deepEqual(tab.errors, []);
  });

  it("keeps plan and selection over a reload", async () => {
    await tab.reload();
    await tab.waitForSelector(".tube-rows .tube-row", {timeout: 20000});
    assert.equal(await tab.evaluate(() => location.hash), "#plan");
    assert.deepEqual(tab.errors, []);
  });

  it("has every control in reach on a telephone", async () => {
    for (const view of ["sheet", "arm", "plan", "calibrate", "effects"]) {
      await tab.goto(`${server.address}#${view}`);
      await tab.waitForSelector(`.view-${view} .panel`);
      assert.deepEqual(await controlsCutOff(tab), [], view);
    }
    await tab.goto(`${server.address}#plan`);
  });

  it("says that plan and base are of another model once their model is taken back", async () => {
    assert.equal(await tab.locator(".other-model").count(), 0);
    await callApi(server, "undo", {});
    await tab.waitForSelector(".plan-view .other-model >> text=base calibrated");
    await tab.click(".rail-entry >> text=Calibrate");
    await tab.waitForSelector(".calibrate-view .other-model >> text=base calibrated");
    await callApi(server, "redo", {});
    await tab.waitForSelector(".other-model", {state: "detached"});
    assert.deepEqual(tab.errors, []);
  });
});
