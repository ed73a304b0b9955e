// Tests of saving the work: it is saved, exported, restored after the program was killed, and never discarded without
// confirmation.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {spawnSync} from "node:child_process";
import {createHash} from "node:crypto";
import {existsSync, readFileSync} from "node:fs";
import path from "node:path";
import {it} from "./limits.mjs";
import {callApi, ended, launch, makeFolder, openTab, program, serve, simulate, stateOf} from "./workbench.mjs";

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

const post = (server, name, body = {}) => callApi(server, name, body);

/** Makes a model with an added effect. */
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
    await tab.waitForSelector("dialog[open] >> text=is not saved in a project");
    await tab.click("dialog[open] >> text=Cancel");
    assert.equal((await stateOf(server)).models.length, 2);

    await tab.keyboard.press("Control+s");
    await tab.fill("dialog[open] input", "mine");
    await tab.click("dialog[open] button[type=submit]");
    await tab.waitForSelector(".project-tools .unsaved", {state: "detached"});
    assert.ok(existsSync(path.join(made.folder, "mine.tubeplan")));
    await tab.keyboard.press("o");
    await tab.click(".file >> text=mockup.yaml");
    await tab.waitForSelector(".chip >> text=cobra-mockup");
    await tab.waitForSelector(".file", {state: "detached"});
    await tab.keyboard.press("o");
    await tab.click(".file >> text=mine.tubeplan");
    await tab.waitForSelector(".models >> text=hysteresis at theta4");
    // The expected refusal is a 409, which the browser logs.
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
    server = await serve(made.folder, "bench.yaml", [], state); // without readings, which the session restores
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.waitForSelector(".models >> text=hysteresis at theta4");
    await tab.waitForFunction(() => document.querySelectorAll(".ladder-row").length >= 3);
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
        const draw = random();
        try {
          const {status, body} =
            draw < 0.6
              ? await post(server, "measurements/set-aside", {ids: [id], aside: random() < 0.7})
              : await post(server, draw < 0.8 ? "undo" : "redo");
          if (status === 200) {
            answered = body;
            ++steps;
          }
        } catch {
          break; // killed during the request
        }
      }
      await dying;
      const next = await serve(made.folder, "bench.yaml", [], state);
      const now = await stateOf(next);
      // The program may have made one change whose answer did not arrive.
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

describe("the report of a project", () => {
  /** Runs the program; returns its standard output and error, and its exit code. */
  function run(words, environment = {}) {
    const {status, stdout, stderr} = spawnSync(program, words, {
      cwd: made.folder,
      env: {...process.env, ...environment},
      encoding: "utf8",
      timeout: 120000,
    });
    return {status, said: stdout + stderr, out: stdout};
  }

  it("says what it is of, and its command lines give its figures again", async () => {
    const server = await serve(made.folder, "bench.yaml", readings());
    assert.equal((await post(server, "measurements/set-aside", {ids: ["4"]})).status, 200);
    await makeWork(server);
    assert.equal(await ended(server, (await post(server, "compare", {ladder: true})).body.id), "done");
    assert.equal((await post(server, "project/save", {file: "reported"})).status, 200);
    await server.stop();
    const made_ = run(["report", "reported.tubeplan", "--files", "again", "--json", "-"]);
    assert.equal(made_.status, 0, made_.said);
    const report = JSON.parse(made_.out);

    // The hashes prove that the inputs are identical to the files.
    assert.deepEqual(report.set_aside, ["4"]);
    assert.equal(report.inputs.length, 3);
    for (const input of report.inputs) {
      const bytes = readFileSync(path.join(made.folder, "again", input.name));
      assert.equal(input.bytes, bytes.length);
      assert.equal(input.sha256, createHash("sha256").update(bytes).digest("hex"));
    }
    const facts = new Map(report.facts);
    assert.match(facts.get("Program"), /^tubeplan \d+\.\d+\.\d+ \(([0-9a-f]{12}\+?|unknown)\)$/);
    assert.match(facts.get("Report made"), /^\d{4}-\d\d-\d\d \d\d:\d\d UTC$/);
    assert.equal(facts.get("Readings in use"), "59");

    // Each command line is run, and must reproduce the results of the report.
    const commands = report.commands.map((line) => line.split(" "));
    assert.equal(commands[0][1], "report");
    const figures = commands.slice(1).map((words) => {
      const {status, said, out} = run([...words.slice(1), "--json", "-"]);
      assert.equal(status, words[1] === "compare" && /falls-short/.test(out) ? 1 : 0, said);
      return {words, document: JSON.parse(out)};
    });
    const near = (one, other, what) => assert.ok(Math.abs(one / other - 1) < 1e-6, `${what}: ${one}, ${other}`);
    for (const {name, file, rms, heldout_rms, chi2_per_dof} of report.history) {
      const {document} = figures.find(({words}) => words[1] === "compare" && words[2].endsWith(file));
      near(document.rms.after, rms, name);
      near(document.rms.heldout_after, heldout_rms, name);
      near(document.chi2_per_dof, chi2_per_dof, name);
    }
    const {document} = figures.find(({words}) => words[1] === "ladder");
    assert.equal(document.models.length, report.models.length);
    document.models.forEach((model, k) => near(model.rms.heldout, report.models[k].heldout_rms, model.name));
  });

  it("is a page that draws itself, and a PDF where there is a Chromium", async () => {
    const pdf = path.join(made.folder, "reported.pdf");
    const done = run(["report", "reported.tubeplan", "--pdf", pdf]);
    assert.equal(done.status, 0, done.said);
    assert.equal(readFileSync(pdf).subarray(0, 5).toString(), "%PDF-");
    const tab = await openTab(browser, `file://${path.join(made.folder, "reported.html")}`);
    assert.deepEqual(await tab.locator("h2").allInnerTexts(), [
      "1 The error of each model",
      "2 History of the models",
      "3 Numbers of the current model",
      "4 Contents",
      "5 Reproducing the figures",
    ]);
    assert.equal(await tab.locator(".missing").count(), 0);
    assert.match(await tab.innerText("footer"), /commit/);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
  });

  it("says what is missing where there is no Chromium, and what is no project", () => {
    const without = run(["report", "reported.tubeplan", "--pdf", "none.pdf"], {PATH: "", TUBEPLAN_CHROMIUM: ""});
    assert.equal(without.status, 2);
    assert.match(without.said, /Chromium is not installed.*install the package chromium/s);
    assert.equal(existsSync(path.join(made.folder, "none.pdf")), false);
    const other = run(["report", "bench.yaml"]);
    assert.equal(other.status, 2);
    assert.match(other.said, /bench\.yaml/);
  });
});
