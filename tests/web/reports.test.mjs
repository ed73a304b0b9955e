// Tests of reports, written by the program and opened in a real browser: every section is drawn, nothing is requested
// from the network, and pictures have text alternatives.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {execFileSync} from "node:child_process";
import {readFileSync, writeFileSync} from "node:fs";
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

/** Runs the program with these arguments in the test folder; exit codes 0 and 1 are both accepted. */
function run(...words) {
  try {
    execFileSync(program, words, {cwd: made.folder, stdio: "pipe", timeout: 240000});
  } catch (error) {
    if (error.status !== 1) throw error;
  }
}

/** Opens a report; only the sections named in `unrecorded` may be reported as not recorded. */
async function opened(name, unrecorded = []) {
  const requestedUrls = [];
  const tab = await openTab(browser, "about:blank");
  tab.on("request", (request) => request.url().startsWith("http") && requestedUrls.push(request.url()));
  await tab.goto(pathToFileURL(path.join(made.folder, name)).href);
  await tab.waitForFunction(() => document.getElementById("foot").textContent !== "");
  assert.deepEqual(tab.errors, []);
  assert.deepEqual(requestedUrls, []);
  assert.deepEqual(await tab.locator(".missing").allInnerTexts(), unrecorded);
  // Canvases must have about two pixels per page pixel or more, so that they are sharp on paper.
  const ratios = await tab.evaluate(() =>
    [...document.querySelectorAll("canvas")].map(({width, clientWidth}) => width / (clientWidth || width)),
  );
  assert.ok(
    ratios.every((ratio) => ratio > 1.9),
    ratios.join(" "),
  );
  const {sections, links} = await tab.evaluate(() => ({
    sections: document.querySelectorAll("main section").length,
    links: document.querySelectorAll("nav a").length,
  }));
  assert.ok(sections > 1 && sections === links, `${sections} sections, ${links} links`);
  return tab;
}

/** Returns the number of pixels of a canvas with a colour of the style sheet, or a similar one. */
function inkOf(tab, canvas, colour) {
  return tab
    .locator(canvas)
    .first()
    .evaluate((element, name) => {
      const paint = document.createElement("canvas").getContext("2d");
      paint.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`);
      paint.fillRect(0, 0, 1, 1);
      const [r, g, b] = paint.getImageData(0, 0, 1, 1).data;
      const {data} = element.getContext("2d").getImageData(0, 0, element.width, element.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 3] > 200 && Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 12)
          count += 1;
      return count;
    }, colour);
}

describe("reports", () => {
  it("of a diagnosis say the verdict, what the effect is, and how large", async () => {
    run("diagnose", "bench.yaml", readings, "--effects", "1", "--report", "diagnosis.html");
    const tab = await opened("diagnosis.html");
    assert.equal(await tab.innerText(".report-verdict b"), "Explained");
    assert.match(
      await tab.innerText(".answer"),
      /^Missing: hysteresis at theta4 \(half width 0\.0\d+ ± 0\.0\d+\sdeg\)\./,
    );
    assert.match(
      await tab.innerText("#ranking tbody tr"),
      /a joint's position depends on the direction of its last motion/,
    );
    const plot = await tab.getAttribute("#why .plot", "aria-label");
    assert.match(plot, /^error as that of theta4, deg against direction of theta4, of 60 readings: before.*; after/);
    assert.equal(await tab.locator("#why .law-sign").count(), 1);
    assert.ok((await inkOf(tab, "#why canvas", "violet")) > 100); // the law, one line for each direction
    assert.equal(await tab.locator("#joints .joint-panel.loud").count(), 1);
    assert.match(await tab.getAttribute("#joints .loud", "aria-label"), /theta4 against direction of theta4, p = .*e−/);
    for (const [k, colour] of ["case0", "accent", "case0", "accent"].entries())
      assert.ok((await inkOf(tab, `#maps canvas >> nth=${k}`, colour)) > 50, `arrows ${k}`);
    assert.ok((await tab.locator("#charts .plot").count()) > 4);
    const size = await tab.getAttribute("#charts .plot >> nth=0", "aria-label");
    await tab.click('#charts .segments >> text="z"');
    const z = await tab.getAttribute("#charts .plot >> nth=0", "aria-label");
    assert.ok(/^error, in against/.test(size) && /^error along z, in against/.test(z), `${size} ${z}`);
    await tab.context().close();
  });

  it("of a comparison and of a ladder draw the errors of their models", async () => {
    run("compare", "bench.yaml", readings, "--report", "comparison.html");
    const compared = await opened("comparison.html");
    assert.equal(await compared.innerText(".report-verdict b"), "The model falls short");
    assert.equal(await compared.locator("#ladder .bar.fitted").count(), 2);
    assert.match(await compared.getAttribute("#why .plot", "aria-label"), /direction of theta4/);
    await compared.context().close();
    run("ladder", readings, "bench.yaml", "--rigid", "--report", "ladder.html");
    const ladder = await opened("ladder.html");
    assert.match(await ladder.textContent("#ladder .ladder-rows"), /bench, rigid/);
    await ladder.context().close();
  });

  it("of an improvement say of each step what was added, why, and with which law", async () => {
    run("improve", "bench.yaml", readings, "--out", "better.yaml", "--report", "improvement.html");
    const tab = await opened("improvement.html");
    const steps = await tab.locator(".improvement-step").allInnerTexts();
    assert.match(steps[0], /Step 1: Explained[^]*Added: hysteresis@theta4: certain/);
    assert.match(steps.at(-1), /Nothing was added: nothing is missing\./);
    const plot = await tab.getAttribute(".improvement-step >> nth=0 >> .plot", "aria-label");
    assert.match(plot, /error as that of theta4, deg/);
    assert.equal(await tab.locator("#ladder .bar.fitted").count(), 2);
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
    assert.deepEqual(await tab.locator("#sheet .segments button").allInnerTexts(), [
      "via-point",
      "goal-point",
      "predicted",
    ]);
    // The ground, the holes, and the tour over them are drawn.
    for (const [k, colour] of ["rim", "faint", "ink"].entries())
      assert.ok((await inkOf(tab, `#tour canvas >> nth=${k}`, colour)) > 20, colour);
    assert.ok((await inkOf(tab, "#clearance canvas", "accent")) > 100);
    await tab.fill("#tour input[type=range]", "1");
    assert.match(await tab.innerText("#tour .note"), /^Last reached: R\d+\sC\d+ \(visit 8 of 8\)$/);
    await tab.context().close();
  });

  it("of campaigns name their ways and what became of the runs", async () => {
    run("campaign", "mockup.yaml", "--runs", "4", "--touches", "3", "--out", "centring");
    const centring = await opened("centring/report.html", ["Holes visited ten times or more: not recorded."]);
    assert.ok((await inkOf(centring, "#curves canvas", "accent")) > 100);
    assert.deepEqual(await centring.locator("#curves .segments button").allInnerTexts(), [
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
    const found = await opened("found/report.html", ["Nothing hidden: not recorded."]); // both runs hide something
    assert.match(await found.innerText("#effects thead"), /the truth named/);
    await found.context().close();
    run("campaign", "mockup.yaml", "--kind", "outage", "--runs", "2", "--visits", "40", "--out", "watched");
    const watched = await opened("watched/report.html", [
      "true cause with its course among the answers, of the alarms after the change: not recorded.", // no alarm
    ]);
    assert.match(await watched.innerText("#changes thead"), /all of these/);
    await watched.context().close();
  });

  it("of an outage say first what must be known, draw every leg, and the arms over the time", async () => {
    const name = 'Tom <img src=x onerror=window.isHit=1> "O\'Neil"';
    writeFileSync(
      path.join(made.folder, "outage.yaml"),
      "job: '<b>spring</b>'\nunits: {length: in, angle: deg, force: lbf}\narms: 2\nmount_s: 60\napart: [[A/hot, A/cold]]\n" +
        "steam_generators: [{name: A, hot: mockup.yaml, cold: mirrored}]\n" +
        "tools: [{name: bobbin, speed: 40, change_s: 90}]\n" +
        "packages: [{name: rows, tubes: R9-11C18-22, tool: bobbin, length: 720, dwell_s: 2, confirm: read-back}]\n",
    );
    run("job", "create", "outage.yaml", "--out", "outage.job");
    run("job", "report", "outage.job", "--out", "handover.html");
    const empty = await opened("handover.html", ["No plan is recorded yet: tubeplan job plan makes one."]);
    assert.match(await empty.innerText("header .sentence"), /Nothing has been recorded yet/);
    assert.match(await empty.innerText("#first"), /No warning, nothing held/);
    await empty.context().close();

    run("job", "plan", "outage.job", "--out", "plans");
    const confirm = (tube, read) =>
      run("job", "confirm", "outage.job", tube, "--read-back", read, "--by", name, "--at", "2025-04-02T06:00:00Z");
    const mark = (tube, as, ...more) =>
      run("job", "mark", "outage.job", tube, "--as", as, "--by", "Maria", "--at", "2025-04-02T06:01:00Z", ...more);
    confirm("A/hot/R9C18", "A/hot/R9C18");
    mark("A/hot/R9C18", "done");
    confirm("A/hot/R9C19", "A/hot/R9C19");
    mark("A/hot/R9C19", "obstructed", "--reason", "dent <03H>");
    confirm("A/hot/R9C20", "A/hot/R9C20");
    mark("A/hot/R9C20", "plugged");
    confirm("A/hot/R9C21", "A/cold/R9C21");
    mark("A/cold/R9C22", "skipped");
    run("job", "report", "outage.job", "--out", "handover.html");
    const tab = await opened("handover.html");
    assert.equal(await tab.innerText("h1"), "<b>spring</b>: hand-over");
    assert.deepEqual(await tab.locator("#first .desk-warning").allInnerTexts(), [
      "✕ At A/hot/R9C21 " +
        name +
        " found A/cold/R9C21 (2025-04-02 06:00): confirm the tube again before any tool enters.",
      "▲ A/hot/R9C20 is plugged at this end only: plug the other end too, or check which tube it is.",
    ]);
    assert.match(await tab.innerText("#first .reasons"), /1 tube, obstructed: dent <03H>: A\/hot\/R9C19 rows/);
    assert.match(await tab.innerText("#first tbody"), /A\/cold\/R9C22\s+rows\s+skipped/);
    for (const row of await tab.locator("#totals tbody tr").all()) {
      const cells = await row.locator("td.number").allInnerTexts();
      const [planned, done, excluded, unresolved] = cells.slice(-5, -1).map(Number);
      assert.equal(planned, done + excluded + unresolved);
    }
    assert.equal(await tab.locator("#maps .leg-map").count(), 2);
    assert.ok((await inkOf(tab, "#maps .leg-map canvas:nth-child(3)", "case3")) > 20); // tubes that are done
    assert.ok((await inkOf(tab, "#maps .leg-map canvas:nth-child(3)", "case0")) > 5); // one that is held
    assert.match(await tab.innerText("#maps .leg-map p"), /% left: \d+ to visit, about \d+ min/);
    assert.equal(await tab.locator("#log li").count(), 5); // confirmations are joined to their marks
    assert.equal(await tab.evaluate(() => window.isHit), undefined);
    await tab.context().close();

    const plan = await opened("plans/schedule.html");
    assert.equal(await plan.locator("#schedule svg[role=img]").count(), 2);
    assert.match(await plan.innerText("#schedule .reasons"), /begins at .* when A\/(hot|cold) ends: /);
    assert.match(await plan.innerText("#schedule .reasons"), /no schedule ends earlier/);
    const shares = (await plan.locator("#schedule .card:nth-of-type(2) .legend b").allInnerTexts()).map(parseFloat);
    assert.equal(shares.length, 6);
    assert.ok(Math.abs(shares.reduce((sum, share) => sum + share, 0) - 100) < 0.5);
    await plan.context().close();
  });

  it("print in light colours whatever the screen has, and stay text of what is hostile", async () => {
    const hostile = "</script><script>window.isHit=1</script><img src=x onerror=window.isHit=1>";
    const text = readFileSync(path.join(made.folder, "diagnosis.html"), "utf8");
    const escaped = JSON.stringify(hostile).replaceAll("<", "\\u003c");
    writeFileSync(
      path.join(made.folder, "hostile.html"),
      text.replace(/"title":"Diagnosis of [^"]*"/, () => `"title":${escaped}`),
    );
    const tab = await opened("hostile.html");
    assert.equal(await tab.innerText("h1"), hostile);
    assert.equal(await tab.evaluate(() => window.isHit), undefined);
    await tab.emulateMedia({colorScheme: "dark"});
    const scheme = () => tab.evaluate(() => document.documentElement.dataset.scheme);
    await tab.waitForFunction(() => document.documentElement.dataset.scheme === "dark");
    await tab.evaluate(() => dispatchEvent(new Event("beforeprint")));
    assert.equal(await scheme(), "light");
    assert.ok((await inkOf(tab, "#why canvas", "case0")) > 50); // redrawn with the colours of paper
    await tab.evaluate(() => dispatchEvent(new Event("afterprint")));
    assert.equal(await scheme(), "dark");
    await tab.context().close();
  });
});
