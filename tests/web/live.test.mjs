// Tests with a running arm: the read-out follows the arm's encoders, received by POST or from a watched file, and the
// arm's readings are added to the loaded readings.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {appendFileSync, readFileSync, writeFileSync} from "node:fs";
import path from "node:path";
import {it} from "./limits.mjs";
import {begin, callApi, errorsOf, finish, openTab, serve, simulate, stateOf} from "./workbench.mjs";

let made, browser;

before(async () => ({made, browser} = await begin()));
after(() => finish({made, browser}));

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const joints = (k) => [10 + 0.05 * k, 45, -35 - 0.03 * k, 12];

/** Records the times at which the read-out of the deflected tip changes. */
const watchReadOut = (tab) =>
  tab.evaluate(() => {
    window.changes = [];
    const figure = document.querySelector(".readout .figure b");
    new MutationObserver(() => window.changes.push(performance.now())).observe(figure, {
      characterData: true,
      childList: true,
      subtree: true,
    });
  });

const changes = (tab) => tab.evaluate(() => window.changes.length);

/** Waits until the read-out shows a posture; returns the deflected tip in this posture. */
async function shows(tab, server, joints, load) {
  const pose = (await callApi(server, "pose", {joints, load})).body;
  const x = pose.flexible.position[0].toFixed(3).replace("-", "−");
  await tab.waitForSelector(`.readout .figure:has-text("${x}")`);
  return pose.tip.flexible;
}

describe("encoders of a running arm", () => {
  it("by POST: the read-out follows twenty a second, and stops where a hand takes a slider", async () => {
    const server = await serve(made.folder, "bench.yaml");
    const tab = await openTab(browser, `${server.address}#arm`);
    await tab.waitForFunction(() => /\d/.test(document.querySelector(".readout .figure b")?.textContent));
    await watchReadOut(tab);
    let answer;
    for (let k = 0; k < 60; ++k) {
      answer = await callApi(server, "live/encoders", {joints: joints(k), load: 20});
      assert.equal(answer.status, 200, JSON.stringify(answer.body));
      await pause(50);
    }
    assert.deepEqual(answer.body.tip, await shows(tab, server, joints(59), 20));
    assert.ok((await changes(tab)) > 2, "the read-out stood until the last posture");
    // The switch is shown only while the arm sends data.
    await callApi(server, "live/encoders", {joints: joints(59), load: 20});
    await tab.waitForSelector("input[aria-label='Follow the running arm']:checked");
    await tab.focus(".slider input[type=range] >> nth=0");
    await tab.keyboard.press("ArrowRight");
    await callApi(server, "live/encoders", {joints: joints(59), load: 20});
    await tab.waitForSelector("input[aria-label='Follow the running arm']:not(:checked)");
    const first = Number(await tab.inputValue(".slider input[type=range] >> nth=0"));
    await shows(tab, server, [first, ...joints(59).slice(1)], 20);
    const before = await tab.innerText(".readout");
    await callApi(server, "live/encoders", {joints: joints(0), load: 0});
    await pause(300);
    assert.equal(await tab.innerText(".readout"), before);
    const refused = await callApi(server, "live/encoders", {joints: [1, 2]});
    assert.equal(refused.status, 422);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });

  it("by a file that is watched, half a row never taken, and what is wrong with it told", async () => {
    const file = path.join(made.folder, "encoders.csv");
    writeFileSync(file, "theta1_deg,theta2_deg,theta3_deg,theta4_deg,load_lbf\n");
    const server = await serve(made.folder, "bench.yaml", ["--watch", file]);
    const tab = await openTab(browser, `${server.address}#arm`);
    await tab.waitForFunction(() => /\d/.test(document.querySelector(".readout .figure b")?.textContent));
    await watchReadOut(tab);
    for (let k = 0; k < 30; ++k) {
      appendFileSync(file, `${joints(k).join(",")},20\n`);
      await pause(100);
    }
    appendFileSync(file, "33,4");
    await pause(400);
    await shows(tab, server, joints(29), 20);
    assert.ok((await changes(tab)) > 2, "the read-out stood until the last row");
    assert.deepEqual(await tab.locator(".notice").allInnerTexts(), []);
    appendFileSync(file, "5,nonsense,0,0\n");
    await tab.waitForSelector(".notice >> text=encoders.csv");
    assert.match(await tab.innerText(".notice"), /nonsense/);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });
});

describe("readings of a running arm", () => {
  it("join the others by POST and by a watched file, and the comparison is made anew", async () => {
    const lines = readFileSync(simulate(made.folder, "all", {hide: "hysteresis@theta4:0.06deg"}), "utf8")
      .trim()
      .split("\n");
    const [header, ...rows] = lines;
    const file = path.join(made.folder, "growing.csv");
    writeFileSync(file, [header, ...rows.slice(0, 60), ""].join("\n"));
    const watched = path.join(made.folder, "watched.csv");
    writeFileSync(watched, `${header}\n`);
    const server = await serve(made.folder, "bench.yaml", [file, "--watch", watched]);
    const tab = await openTab(browser, `${server.address}#error`);
    const count = (n) => tab.waitForSelector(`.verdict-figures dd:has-text("${n}")`, {timeout: 20000});
    await count(60);
    const send = (some) =>
      fetch(`${server.address}api/live/readings`, {
        method: "POST",
        headers: {"Content-Type": "text/csv"},
        body: [header, ...some, ""].join("\n"),
      });
    assert.equal((await send(rows.slice(60, 70))).status, 202);
    await count(70);
    await tab.waitForFunction(
      () => document.querySelectorAll(".ladder-row").length >= 2 && !document.querySelector(".job"),
    );
    assert.equal((await send(rows.slice(60, 61))).status, 422);
    for (const row of rows.slice(70, 80)) {
      appendFileSync(watched, `${row}\n`);
      await pause(120);
    }
    await count(80);
    await tab.waitForFunction(
      () => document.querySelectorAll(".ladder-row").length >= 2 && !document.querySelector(".job"),
    );
    assert.equal((await stateOf(server)).measurements.readings, 80);
    assert.equal((await stateOf(server)).results.compare?.model, 0);
    assert.deepEqual(errorsOf(tab), []);
    await tab.context().close();
    await server.stop();
  });
});

describe("a program that says nothing", () => {
  it("is said not to answer, until it is heard again", async () => {
    const server = await serve(made.folder, "bench.yaml", ["--fresh"]);
    const tab = await openTab(browser, server.address, {prepare: (page) => page.clock.install()});
    await tab.waitForSelector(".connection.live");
    await tab.clock.fastForward(30_000);
    await tab.waitForFunction(() => document.querySelector(".connection.lost") && document.querySelector(".silence"));
    await callApi(server, "simulate", {design: "bench", readings: 12});
    await tab.waitForSelector(".connection.live");
    await tab.waitForSelector(".silence", {state: "detached"});
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });
});
