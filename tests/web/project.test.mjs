// Keeping the work: saved, exported, taken up after the program was killed, and never dropped unasked.
import assert from "node:assert/strict";
import {after, before, describe, it} from "node:test";
import {existsSync} from "node:fs";
import path from "node:path";
import {launch, makeFolder, openTab, serve, simulate} from "./workbench.mjs";

let made, browser;

before(async () => {
  made = makeFolder();
  simulate(made.folder, "readings", {hide: "hysteresis@theta4:0.06deg", seed: 7, readings: 60});
  browser = await launch();
});
after(async () => {
  await browser?.close();
  made?.remove();
});

const stateOf = async (server) => (await fetch(`${server.address}api/state`)).json();

async function post(server, name, body = {}) {
  const answer = await fetch(`${server.address}api/${name}`, {
    method: "POST",
    headers: {"Content-Type": "application/json"},
    body: JSON.stringify(body),
  });
  return {status: answer.status, body: await answer.json()};
}

async function ended(server, id) {
  for (;;) {
    const job = (await stateOf(server)).jobs.find((entry) => entry.id === id);
    if (job.status !== "running") return job.status;
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
}

/** A model with an effect added. */
async function makeWork(server) {
  for (const [name, body] of [
    ["compare", {}],
    ["add", {causes: ["hysteresis@theta4"]}],
    ["compare", {}],
  ])
    assert.equal(await ended(server, (await post(server, name, body)).body.id), "done");
}

const readings = () => [path.join(made.folder, "readings.csv")];

describe("the work", () => {
  it("is saved and exported from the error view, and asked for before another cell is opened", async () => {
    const server = await serve(made.folder, "bench.yaml", readings());
    await makeWork(server);
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.waitForSelector(".project-tools .unsaved");
    await tab.click(".project-tools summary");
    for (const name of ["cell.yaml", "cell-arm.yaml", "measurements.csv", "project.tubeplan", "compare.html"])
      await tab.waitForSelector(`.project-tools a[download='${name}']`);
    const [download] = await Promise.all([
      tab.waitForEvent("download"),
      tab.click(".project-tools a[download='cell.yaml']"),
    ]);
    assert.equal(download.suggestedFilename(), "cell.yaml");
    await tab.keyboard.press("Escape");

    await tab.keyboard.press("o");
    await tab.click(".file >> text=mockup.yaml");
    await tab.waitForSelector("dialog[open] >> text=stands in no project");
    await tab.click("dialog[open] >> text=Stay");
    assert.equal((await stateOf(server)).models.length, 2);

    await tab.keyboard.press("Control+s");
    await tab.fill("dialog[open] input", "mine");
    await tab.click("dialog[open] button[type=submit]");
    await tab.waitForSelector(".project-tools .unsaved", {state: "detached"});
    assert.ok(existsSync(path.join(made.folder, "mine.tubeplan")));
    await tab.keyboard.press("o");
    await tab.click(".file >> text=mockup.yaml");
    await tab.waitForSelector(".chip >> text=cobra-mockup");
    await tab.keyboard.press("o");
    await tab.click(".file >> text=mine.tubeplan");
    await tab.waitForSelector(".models >> text=hysteresis@theta4");
    // The refusal that is asked about is a 409, which the browser notes.
    assert.deepEqual(
      tab.errors.filter((text) => !/status of 409/.test(text)),
      [],
    );
    await tab.context().close();
    await server.stop();
  });

  it("comes back after the program was killed and started again", async () => {
    const state = path.join(made.folder, "state-killed");
    let server = await serve(made.folder, "bench.yaml", readings(), state);
    await makeWork(server);
    await server.kill();
    server = await serve(made.folder, "bench.yaml", [], state); // the readings were kept too
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.waitForSelector(".models >> text=hysteresis@theta4");
    await tab.waitForFunction(() => document.querySelectorAll(".rung").length >= 3);
    await tab.waitForSelector(".residual-plot .series-legend >> text=/before: as given, refitted/");
    await tab.click("button[title^='Undo']");
    await tab.waitForSelector(".models >> text=as given");
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });

  it("is whole after any instant of a kill: all that was answered is there", async () => {
    const kills = Number(process.env.TUBEPLAN_KILLS ?? 8);
    const state = path.join(made.folder, "state-random");
    let server = await serve(made.folder, "bench.yaml", readings(), state);
    await makeWork(server);
    await server.kill();
    let seed = 1,
      steps = 0;
    const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
    for (let k = 0; k < kills; ++k) {
      server = await serve(made.folder, "bench.yaml", [], state);
      let isKilled = false;
      let answered = await stateOf(server);
      const dying = new Promise((resolve) => setTimeout(resolve, 20 + 400 * random())).then(() => {
        isKilled = true;
        return server.kill();
      });
      while (!isKilled) {
        const id = String(1 + Math.floor(60 * random()));
        const asked = random();
        try {
          const {status, body} =
            asked < 0.6
              ? await post(server, "measurements/set-aside", {ids: [id], aside: random() < 0.7})
              : await post(server, asked < 0.8 ? "undo" : "redo");
          if (status === 200) {
            answered = body;
            ++steps;
          }
        } catch {
          break; // killed while it was asked
        }
      }
      await dying;
      const next = await serve(made.folder, "bench.yaml", [], state);
      const now = await stateOf(next);
      // One change may have been made whose answer was never heard.
      const more = now.revision - answered.revision;
      assert.ok(more === 0 || more === 1, `revision ${now.revision} after ${answered.revision} was answered`);
      assert.equal(now.models.length, answered.models.length);
      if (more === 0) {
        assert.equal(now.model, answered.model);
        assert.equal(now.measurements.set_aside, answered.measurements.set_aside);
      }
      await next.kill();
    }
    console.log(`killed ${kills} times, ${steps} changes answered: none lost`);
  });
});
