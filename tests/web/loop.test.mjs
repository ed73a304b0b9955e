// Tests of the improvement loop, from data to an error at the noise floor in four clicks, and of undo, reload, two
// browsers, and invalid and malicious files.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {readFileSync} from "node:fs";
import path from "node:path";
import {it} from "./limits.mjs";
import {callApi, controlsCutOff, drop, launch, makeFolder, openTab, serve, simulate, stateOf} from "./workbench.mjs";

let made, server, browser;

before(async () => {
  made = makeFolder();
  simulate(made.folder, "readings", {
    hide: "hysteresis@theta4:0.06deg",
    seed: 7,
  });
  server = await serve(made.folder, "bench.yaml");
  browser = await launch();
});
after(async () => {
  await browser?.close();
  await server?.stop();
  made?.remove();
});

/** Returns the ratio of the last model's held-out error to the noise floor, as the page shows it. */
async function timesFloor(tab) {
  const text = await tab.locator(".ladder-row.now .bar-text").last().innerText();
  return Number(/([\d.]+) × floor/.exec(text)[1]);
}

describe("the loop", () => {
  it("goes from data to the floor in four clicks", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.click("text=Open readings"); // 1
    await tab.click(".file >> text=readings.csv"); // 2
    await tab.waitForSelector(".verdict h1 >> text=The model falls short", {
      timeout: 60000,
    });
    await tab.waitForFunction(() => document.querySelectorAll(".ladder-row").length >= 2);
    assert.ok((await timesFloor(tab)) > 2, "before, the error must stand well above the floor");
    await tab.click(".next:has-text('Diagnose')"); // 3
    await tab.waitForSelector(".next:has-text('Add hysteresis at theta4')", {timeout: 60000});
    assert.deepEqual(await controlsCutOff(tab), []);
    await tab.click(".next:has-text('Add hysteresis at theta4')"); // 4
    await tab.waitForSelector(".verdict h1 >> text=At the noise floor", {
      timeout: 60000,
    });
    await tab.waitForFunction(() => document.querySelectorAll(".ladder-row").length >= 3);
    const times = await timesFloor(tab);
    assert.ok(times < 1.15, `after, the held-out error is ${times} times the floor`);
    assert.match(await tab.innerText(".verdict ul"), /the held-out error fell from 0\.0\d+ in to 0\.00\d+ in/);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
  });

  it("is the same in another browser and after a reload", async () => {
    const [one, other] = await Promise.all([
      openTab(browser, `${server.address}#error`),
      openTab(browser, `${server.address}#error`),
    ]);
    for (const tab of [one, other]) await tab.waitForSelector(".models >> text=hysteresis at theta4");
    await one.click("button[title^='Undo']");
    await other.waitForSelector(".models >> text=as given");
    await other.click("button[title^='Redo']");
    await one.waitForSelector(".models >> text=hysteresis at theta4");
    await one.reload();
    await one.waitForSelector(".models >> text=hysteresis at theta4");
    await one.waitForFunction(() => document.querySelectorAll(".ladder-row").length >= 3);
    assert.equal(await one.evaluate(() => location.hash), "#error");
    assert.deepEqual([...one.errors, ...other.errors], []);
    await one.context().close();
    await other.context().close();
  });

  it("plots the error against moments, as formulas name them", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.waitForFunction(() =>
      [...document.querySelectorAll("select[aria-label='Variable'] option")].some((o) => o.value === "moment_tool_z"),
    );
    await tab.selectOption("select[aria-label='Variable']", "moment_tool_z");
    const drawn = await tab.evaluate(() => {
      const canvas = document.querySelector(".with-legend canvas");
      const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return data.some((value) => value !== 0);
    });
    assert.ok(drawn);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
  });

  it("stops a diagnosis at once, and says nothing of it", async () => {
    simulate(made.folder, "many", {hide: "hysteresis@theta4:0.06deg", readings: 1500, seed: 8});
    const own = await serve(made.folder, "bench.yaml", [path.join(made.folder, "many.csv")]);
    const tab = await openTab(browser, `${own.address}#error`);
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", {timeout: 120000});
    await tab.dispatchEvent(".next", "click");
    await tab.evaluate(() => document.querySelector(".next").click()); // the second click of a double click
    await tab.waitForSelector(".job >> text=/catalogue|effects/", {timeout: 60000});
    assert.equal(await tab.locator(".notice").count(), 0);
    const start = Date.now();
    await tab.click(".job button[title='Stop']");
    await tab.waitForSelector(".job", {state: "detached", timeout: 30000});
    console.log(`a diagnosis of 1,500 readings is stopped ${Date.now() - start} ms after the click`);
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])");
    const state = await stateOf(own);
    assert.equal(state.results.diagnose, null);
    assert.equal(state.jobs.at(-1).status, "cancelled");
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await own.stop();
  });

  it("tries a formula, tells what is wrong with another, and takes it back", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.click(".tabs >> text=Formula");
    await tab.fill(".formula input", "theta3 += c*sin(nothing_of_the_kind(theta1))");
    await tab.click(".formula >> text=Try");
    await tab.waitForSelector(".notice", {timeout: 60000});
    assert.ok((await tab.innerText(".notice")).length > 30, "the program's own words are shown");
    await tab.keyboard.press("Escape");
    await tab.fill(".formula input", "theta3 += c*sin(theta1)");
    await tab.click(".formula >> text=Try");
    await tab.waitForFunction(() => document.querySelectorAll(".ladder-row").length >= 4, null, {timeout: 60000});
    await tab.waitForFunction(() => !document.querySelector(".job"));
    await tab.waitForSelector(".verdict li >> text=Not significant: formula theta3 += c*sin(theta1)");
    await tab.waitForSelector(".next >> text=Remove formula theta3 += c*sin(theta1)");
    await tab.click("button[title^='Undo']");
    await tab.waitForSelector(".models >> text=hysteresis at theta4");
    // The refused formula gives a 4xx, which the browser logs in its console.
    assert.deepEqual(
      tab.errors.filter((text) => !/status of 4/.test(text)),
      [],
    );
    await tab.context().close();
  });

  it("shows the program's own words for a bad file, and keeps what was there", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.waitForSelector(".error-view");
    const lines = readFileSync(path.join(made.folder, "readings.csv"), "utf8").split("\n");
    lines[3] = lines[3].replace(/,(\d)/, ",not-a-number$1");
    await drop(tab, "bad.csv", lines.join("\n"));
    // Another notice may be present, about work that the undo has made obsolete.
    const notice = tab.locator(".notice", {hasText: "bad.csv"});
    await notice.waitFor();
    const words = await notice.innerText();
    assert.match(words, /bad\.csv/);
    assert.match(words, /not-a-number/);
    assert.match(words, /4|line|expected/);
    assert.equal(await tab.locator("dialog[open]").count(), 0, "its columns are known: nothing is asked about them");
    assert.match(await tab.innerText(".chip-more"), /readings\.csv/);
    await tab.context().close();
  });

  it("never runs what a file says", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    const evil = '<img src=x onerror="window.ran=1"><script>window.ran=1</script>';
    const lines = readFileSync(path.join(made.folder, "readings.csv"), "utf8").trim().split("\n");
    const point = lines[0].split(",").indexOf("point");
    const shownLines = lines.map((line, i) =>
      i === 0
        ? line
        : line
            .split(",")
            .map((field, k) => (k === point ? `"${evil.replaceAll('"', "'")}${i}"` : field))
            .join(","),
    );
    await drop(tab, `${evil.replaceAll("/", "").replaceAll('"', "")}.csv`, shownLines.join("\n"));
    await tab.waitForTimeout(2500);
    assert.equal(await tab.evaluate(() => window.ran), undefined);
    assert.equal(await tab.locator("#view img, .header img, .notices img, #view script").count(), 0);
    await tab.context().close();
  });

  it("loads nothing from elsewhere and has no inline script", async () => {
    const context = await browser.newContext();
    const tab = await context.newPage();
    const requestedOrigins = [];
    tab.on("request", (request) => requestedOrigins.push(new URL(request.url()).origin));
    await tab.goto(`${server.address}#arm`);
    await tab.waitForSelector(".slider");
    await tab.waitForTimeout(800);
    assert.deepEqual([...new Set(requestedOrigins)], [new URL(server.address).origin]);
    assert.equal(await tab.locator("script:not([src])").count(), 0);
    await context.close();
  });
});

describe("practice readings", () => {
  it("are made in the dialog, which says why it cannot", async () => {
    const own = await serve(made.folder, "bench.yaml");
    const tab = await openTab(browser, `${own.address}#error`);
    await tab.click("button >> text=Open readings");
    await tab.selectOption(".practice .field:has-text('hidden effect') select", {label: "backlash"});
    await tab.selectOption(".practice select >> nth=1", {label: "tool.z"});
    await tab.fill(".practice .field:has-text('gap') input", "much");
    await tab.click("button >> text=Make readings");
    await tab.click("dialog .notice .tool");
    await tab.fill(".practice .field:has-text('gap') input", "0,15");
    await tab.fill(".practice .field:has-text('readings') input", "60");
    await tab.click("button >> text=Make readings");
    await tab.waitForSelector(".chip-more >> text=60 readings", {
      timeout: 60000,
    });
    await tab.waitForSelector(".verdict h1 >> text=The model falls short", {
      timeout: 60000,
    });
    await tab.waitForSelector(".next:not([disabled])", {timeout: 60000});
    tab.errors.length = 0; // the refusal above is a 4xx, which the browser logs
    await own.stop();
    await tab.waitForSelector(".silence >> text=does not respond");
    await tab.context().close();
  });
});

describe("the catalogue", () => {
  it("has every effect of this arm with its law, sizes and places, and what hides behind what by these readings", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.waitForSelector(".error-view");
    await tab.keyboard.press("3");
    const {effects} = (await callApi(server, "catalogue")).body;
    const kinds = [...new Set(effects.map(({effect}) => effect))];
    await tab.waitForSelector(".effect-list [role=option]");
    assert.deepEqual(await tab.locator(".effect-list b").allInnerTexts(), kinds);
    await tab.fill("input[aria-label='Filter the effects']", "weight");
    await tab.click(".effect-list >> text=link-weight");
    await tab.waitForSelector(".place-table tbody tr >> text=hose-pull at forearm");
    const places = await tab.locator(".place-table tbody td:first-child").allInnerTexts();
    assert.deepEqual(
      places,
      effects.filter(({effect}) => effect === "link-weight").map(({at}) => at),
    );
    assert.match(await tab.innerText(".effect-kind .figures"), /weight\s+usually up to 22\.5 lbf/);
    await tab.focus(".effect-list [aria-selected=true]");
    await tab.keyboard.press("ArrowDown");
    await tab.waitForSelector(".effects-view h2 >> text=tool-weight");
    // If two effects have one parameter each and the first is confounded with the second, the second must be with the
    // first.
    const {causes} = (await callApi(server, "confounding")).body;
    const confoundingOf = (effect, at) => causes.find((cause) => cause.effect === effect && cause.at === at).confounded;
    const has = (list, effect, at) => list.some((other) => other.effect === effect && other.at === at);
    assert.ok(has(confoundingOf("link-length", "mezzanine-beam"), "link-length", "mezzanine-platform"));
    assert.ok(has(confoundingOf("link-length", "mezzanine-platform"), "link-length", "mezzanine-beam"));
    assert.ok(
      has(confoundingOf("joint-offset", "theta4"), "tool-offset", "tool"),
      "a turn of the tool is a shift of its tip",
    );
    assert.ok(!has(confoundingOf("tool-offset", "tool"), "joint-offset", "theta4"), "but not the other way");
    assert.deepEqual(confoundingOf("joint-offset", "theta2"), []);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
  });
});

describe("by keys alone", () => {
  it("goes from tab to tab with the arrows, each row of tabs one stop", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    for (const [label, names] of [
      ["What is missing", ["What is missing", "A or B", "Formula", "Numbers"]],
      ["Errors", ["Places", "Joints", "Histogram", "Readings"]],
    ]) {
      const tabs = tab.locator(`[role=tablist][aria-label='${label}'] [role=tab]`);
      await tabs.first().click();
      assert.deepEqual(
        (await tabs.allInnerTexts()).map((words) => words.replace(/ ·.*/, "")),
        names,
      );
      for (let k = 1; k <= names.length; ++k) {
        await tab.keyboard.press("ArrowRight");
        const now = k % names.length;
        assert.equal(await tabs.nth(now).getAttribute("aria-selected"), "true", `${label}: ${names[now]}`);
        assert.ok(await tabs.nth(now).evaluate((button) => button === document.activeElement));
        assert.equal(await tab.locator(`[role=tablist][aria-label='${label}'] [tabindex='0']`).count(), 1);
      }
    }
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
  });

  it("keeps a dialog open that is opened again before the browser tells of its closing", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.waitForSelector(".error-view");
    await tab.keyboard.press("o");
    await tab.waitForSelector("dialog[open] .file");
    const isOpen = await tab.evaluate(async () => {
      document.querySelector("dialog[open] button[title^='Close']").click();
      for (let k = 0; k < 20; ++k) await Promise.resolve(); // the page has drawn, but the browser has not yet sent its event
      document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "o", bubbles: true}));
      await new Promise((resolve) => setTimeout(resolve, 300));
      return document.querySelector("dialog[open]") !== null;
    });
    assert.ok(isOpen);
    await tab.waitForSelector("dialog[open] .file");
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
  });

  it("changes the view, opens and closes dialogs, and lists the keys", async () => {
    const tab = await openTab(browser, `${server.address}#error`);
    await tab.waitForSelector(".error-view");
    await tab.keyboard.press("1");
    await tab.waitForSelector(".arm-view");
    await tab.keyboard.press("?");
    await tab.waitForSelector("dialog[open] kbd");
    await tab.keyboard.press("Escape");
    await tab.waitForSelector("dialog[open]", {state: "detached"});
    await tab.keyboard.press("o");
    await tab.waitForSelector("dialog[open] .file");
    await tab.keyboard.press("Escape");
    await tab.keyboard.press("2");
    await tab.waitForSelector(".error-view");
    const before = await tab.evaluate(() => document.documentElement.dataset.scheme);
    await tab.keyboard.press("d");
    assert.notEqual(await tab.evaluate(() => document.documentElement.dataset.scheme), before);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
  });
});
