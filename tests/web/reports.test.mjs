// The reports in a real browser, from the file as the program writes it: every part is drawn, nothing is asked of the
// network, and words come with the figures.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {execFileSync} from "node:child_process";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {it} from "./limits.mjs";
import {launch, makeFolder, openTab, program, simulate} from "./workbench.mjs";

let made, browser, readings;

before(async () => {
  made = makeFolder();
  readings = simulate(made.folder, "readings", {hide: "hysteresis@theta4:0.06deg", readings: 60});
  browser = await launch();
});
after(async () => {
  await browser?.close();
  made?.remove();
});

/** The program with these words, in the folder; an answer of no (1) is as good as a yes. */
function run(...words) {
  try {
    execFileSync(program, words, {cwd: made.folder, stdio: "pipe", timeout: 240000});
  } catch (error) {
    if (error.status !== 1) throw error;
  }
}

/** A report with all of its parts, of which only those named say that they are not recorded. */
async function opened(name, unrecorded = []) {
  const asked = [];
  const tab = await openTab(browser, "about:blank");
  tab.on("request", (request) => request.url().startsWith("http") && asked.push(request.url()));
  await tab.goto(pathToFileURL(path.join(made.folder, name)).href);
  await tab.waitForFunction(() => document.getElementById("foot").textContent !== "");
  assert.deepEqual(tab.errors, []);
  assert.deepEqual(asked, []);
  assert.deepEqual(await tab.locator(".missing").allInnerTexts(), unrecorded);
  const {sections, links} = await tab.evaluate(() => ({
    sections: document.querySelectorAll("main section").length,
    links: document.querySelectorAll("nav a").length,
  }));
  assert.ok(sections > 1 && sections === links, `${sections} sections, ${links} links`);
  return tab;
}

describe("reports", () => {
  it("of a diagnosis say the verdict, what the effect is, and how large", async () => {
    run("diagnose", "bench.yaml", readings, "--effects", "1", "--report", "diagnosis.html");
    const tab = await opened("diagnosis.html");
    assert.equal(await tab.innerText(".verdict b"), "Explained");
    assert.match(
      await tab.innerText(".answer"),
      /^Missing: hysteresis at theta4 \(half width 0\.0\d+ ± 0\.0\d+\sdeg\)\./,
    );
    assert.match(
      await tab.innerText("#ranking tbody tr"),
      /a joint's position depends on the direction of its last motion/,
    );
    assert.match(await tab.textContent("#why .chart >> nth=0"), /error as that of theta4, deg/);
    assert.match(await tab.textContent("#why .chart >> nth=0"), /direction of theta4/);
    assert.equal(await tab.locator("#why .law-line").count(), 2); // one for each direction
    assert.equal(await tab.locator("#why .mean").count(), 2);
    assert.equal(await tab.locator("#joints .joint-panel.loud").count(), 1);
    assert.match(
      await tab.getAttribute("#joints .loud .stage", "aria-label"),
      /theta4 against direction of theta4, p = .*e−/,
    );
    assert.ok((await tab.locator("#maps path.arrow-before").count()) > 0);
    assert.ok((await tab.locator("#charts svg").count()) > 4);
    await tab.context().close();
  });

  it("of a comparison and of a ladder draw the errors of their models", async () => {
    run("compare", "bench.yaml", readings, "--report", "comparison.html");
    const compared = await opened("comparison.html");
    assert.equal(await compared.innerText(".verdict b"), "The model falls short");
    assert.equal(await compared.locator("#ladder .error-fitted").count(), 3); // two bars and the legend's
    assert.match(await compared.textContent("#why .chart"), /direction of theta4/);
    await compared.context().close();
    run("ladder", readings, "bench.yaml", "--rigid", "--report", "ladder.html");
    const ladder = await opened("ladder.html");
    assert.match(await ladder.textContent("#ladder svg.chart"), /bench, rigid/);
    await ladder.context().close();
  });

  it("of an improvement say of each step what was added, why, and with which law", async () => {
    run("improve", "bench.yaml", readings, "--out", "better.yaml", "--report", "improvement.html");
    const tab = await opened("improvement.html");
    const steps = await tab.locator(".improvement-step").allInnerTexts();
    assert.match(steps[0], /Step 1: Explained[^]*Added: hysteresis@theta4: certain/);
    assert.match(steps.at(-1), /Nothing was added: nothing is missing\./);
    assert.match(await tab.textContent(".improvement-step >> nth=0 >> .chart"), /error as that of theta4, deg/);
    assert.equal(await tab.locator("#ladder .error-fitted").count(), 3); // two models and the legend's
    await tab.context().close();
  });

  it("of a plan draw the sheet, its marks and their legend", async () => {
    const truth = path.join(made.folder, "mockup-true.yaml");
    run(
      "plan",
      "mockup.yaml",
      "--tubes",
      "spread:8",
      "--touches",
      "auto",
      "--truth",
      truth,
      "--seed",
      "1",
      "--out",
      "plan",
    );
    const tab = await opened("plan/report.html");
    assert.match(await tab.innerText("#sheet .lead"), /hot leg, seen from below \(\+x to the left\)/);
    const legend = await tab.innerText("#sheet .legend >> nth=1");
    for (const words of ["no step enters", "all three steps enter", "cannot be visited"])
      assert.ok(legend.includes(words), words);
    assert.deepEqual(await tab.locator("#sheet .choice button").allInnerTexts(), [
      "via-point",
      "goal-point",
      "predicted",
    ]);
    const isDrawn = await tab.evaluate(() => {
      const canvas = document.querySelector("#tour canvas");
      return canvas
        .getContext("2d")
        .getImageData(0, 0, canvas.width, canvas.height)
        .data.some((value) => value !== 0);
    });
    assert.ok(isDrawn);
    await tab.context().close();
  });

  it("of campaigns name their ways and what became of the runs", async () => {
    run("campaign", "mockup.yaml", "--runs", "4", "--touches", "3", "--out", "centring");
    const centring = await opened("centring/report.html", ["Holes visited ten times or more: not recorded."]);
    assert.deepEqual(await centring.locator("#curves .choice button").allInnerTexts(), [
      "with compensation",
      "without compensation",
    ]);
    await centring.context().close();
    run(
      "campaign",
      "bench.yaml",
      "--kind",
      "diagnose",
      "--runs",
      "2",
      "--effects",
      "1",
      "--readings",
      "60",
      "--out",
      "found",
    );
    const found = await opened("found/report.html", ["Nothing hidden: not recorded."]); // of two runs both hide something
    assert.match(await found.innerText("#effects thead"), /the truth named/);
    await found.context().close();
  });
});
