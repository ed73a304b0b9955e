// Tests of the plots of errors: the plot opens on the variable of the found cause and shows the errors before and after
// the change together. Every reading can be queried, shown and set aside.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import path from "node:path";
import {it} from "./limits.mjs";
import {begin, callApi, closable, ended, finish, openTab, serve, simulate, stateOf} from "./workbench.mjs";

let made, browser;

before(async () => ({made, browser} = await begin()));
after(() => finish({made, browser}));

/** Starts a workbench with readings that hide an effect, and compares them. */
async function compared(name, hide, more = {}) {
  simulate(made.folder, name, {hide, seed: 7, ...more});
  const server = await serve(made.folder, "bench.yaml", [path.join(made.folder, `${name}.csv`)]);
  const tab = await openTab(browser, `${server.address}#error`);
  await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", {timeout: 60000}); // the comparison starts automatically
  await tab.waitForSelector(".ladder-row >> text=as given, rigid"); // the ladder, not the earlier bars of the comparison
  await tab.waitForFunction(() => !document.querySelector(".job"));
  // Moments and leverages arrive later and redraw the plot, which would cancel a lasso.
  await tab.waitForFunction(() =>
    ["moment_tool_z", "as theta4"].every((value) => document.querySelector(`.residual-plot option[value='${value}']`)),
  );
  return closable(tab, server);
}

async function diagnosed(tab) {
  await tab.click(".next:has-text('Diagnose')");
  await tab.waitForFunction(
    () => !document.querySelector(".job") && !/Diagnose/.test(document.querySelector(".next")?.innerText),
    null,
    {timeout: 120000},
  );
}

const variable = (tab) => tab.locator("select[aria-label='Variable']").inputValue();
const part = (tab) => tab.locator("select[aria-label='Part of the error']").inputValue();
/** Waits until the plot shows the variable `wanted`. */
const opensOn = (tab, wanted) =>
  tab.waitForFunction((key) => document.querySelector("select[aria-label='Variable']")?.value === key, wanted, {
    timeout: 10000,
  });

// Only two effects are tried here; app/web/tests/opening.test.ts tries every effect of the catalogue.
const FOUND = [
  ["hysteresis@theta4:0.06deg", "theta4_dir", "as theta4"],
  ["base-slip@base:x=0.08,y=0.05,time=90", "time", ""],
];

describe("the plot of the errors", () => {
  for (const [hide, wanted, wantedPart] of FOUND) {
    it(`opens on ${wanted} for ${hide}, before and after on one scale`, async () => {
      const {tab, close} = await compared(hide.replace(/\W/g, "_"), hide);
      await opensOn(tab, wanted); // before any diagnosis, from the pattern search alone
      await diagnosed(tab);
      await opensOn(tab, wanted);
      if (wantedPart) assert.equal(await part(tab), wantedPart);
      const legend = await tab.innerText(".residual-plot .series-legend");
      assert.match(legend, /before: refitted without it/);
      assert.match(legend, new RegExp(`after: with ${hide.split("@")[0]}`));
      await tab.click(".next:has-text('Add')");
      await tab.waitForFunction(
        () => document.querySelectorAll(".ladder-row").length >= 3 && !document.querySelector(".job"),
      );
      await tab.waitForSelector(".residual-plot .series-legend >> text=/before: as given, refitted/");
      await opensOn(tab, wanted);
      assert.match(await tab.innerText(".residual-plot .series-legend"), /after: \+ /);
      await close();
    });
  }
});

describe("joint by joint", () => {
  it("frames the loudest with its p-value, and a click shows it large", async () => {
    const {tab, close} = await compared("joints", "hysteresis@theta4:0.06deg");
    await tab.click(".evidence [role=tab]:has-text('Joints')");
    await tab.waitForSelector(".joint-panel.loud");
    assert.equal(await tab.locator(".joint-panel.loud").count(), 1);
    assert.equal(await tab.getAttribute(".joint-panel.loud", "data-panel"), "theta4 direction");
    assert.match(await tab.innerText(".joint-panel.loud"), /p = \d+e−\d+/);
    assert.match(await tab.innerText(".joint-panel[data-panel='theta1 angle']"), /p = [01]\.\d+/);
    await tab.click(".joint-panel[data-panel='theta2 load']");
    await opensOn(tab, "load");
    assert.equal(await part(tab), "as theta2");
    await tab.click(".joint-panel.loud");
    await opensOn(tab, "theta4_dir");
    assert.equal(await part(tab), "as theta4");
    // After the effect is added, no panel must be framed any more.
    await diagnosed(tab);
    await tab.click(".next:has-text('Add')");
    await tab.waitForSelector(".joint-panel.loud", {state: "detached", timeout: 60000});
    await close();
  });
});

describe("figures", () => {
  it("mark what is far beyond the noise, and carry no digits that it does not", async () => {
    const {tab, close} = await compared("figures", "hysteresis@theta4:0.06deg");
    assert.match(await tab.innerText(".verdict-figures .bad"), /▲ 10\.5/);
    await diagnosed(tab);
    const words = await tab.innerText(".verdict ul");
    assert.match(words, /half width 0\.05\d\d ± 0\.00\d\d\sdeg/);
    assert.match(words, /from 0\.0\d{2,3} in to 0\.00\d{1,3} in/);
    const shown = await tab.evaluate(() => {
      const box = document.querySelector(".verdict ul");
      return box.scrollHeight <= box.clientHeight + 1;
    });
    assert.ok(shown, "nothing of the verdict is cut");
    for (const size of await tab.locator(".ranking .size").allInnerTexts())
      assert.doesNotMatch(size, /\d{7}|,\d{3},\d{3}/);
    await tab.click(".next:has-text('Add')");
    await tab.waitForFunction(
      () => document.querySelectorAll(".ladder-row").length >= 3 && !document.querySelector(".job"),
    );
    assert.equal(await tab.locator(".verdict-figures .bad").count(), 0);
    await close();
  });
});

describe("no known effect", () => {
  it("leads to a formula, begun with what the error follows, and urges nothing that does not help", async () => {
    const {tab, close} = await compared("unknown", "theta3 += c*sin(2*theta1)*cos(3*theta2); c=0.15");
    await diagnosed(tab);
    assert.match(await tab.innerText(".verdict h1"), /Unexplained/);
    assert.equal(await tab.locator(".explanation .button.first").count(), 0);
    await tab.click(".next:has-text('Try a formula')");
    assert.match(await tab.inputValue(".formula input"), /^theta\d \+= c\*/);
    await close();
  });
});

describe("a reading", () => {
  it("names itself under the pointer, brings the arm there, and is set aside and taken back", async () => {
    const {tab, server, close} = await compared("asked", "hysteresis@theta4:0.06deg");
    const before = await tab.innerText(".ladder-row.now .bar-text >> nth=0");
    await tab.click(".evidence [role=tab]:has-text('Readings')");
    await tab.waitForSelector(".reading-space .reading-row");
    const worst = await tab.innerText(".reading-space .reading-row >> nth=0 >> .link");
    await tab.hover(".reading-space .reading-row >> nth=0");
    const words = await tab.innerText(".reading-tip");
    assert.match(words, new RegExp(`reading ${worst}\\b`));
    for (const named of ["theta4", "load", "before", "σ"]) assert.ok(words.includes(named), named);
    await tab.click(".reading-space .reading-row >> nth=0 >> .link");
    await tab.waitForSelector(`.shown-errors >> text=reading ${worst}`);
    await tab.waitForFunction(() => /\d/.test(document.querySelector(".readout .figure b")?.textContent));
    await tab.click("text=Back to the errors");
    await tab.waitForSelector(".error-view");

    await tab.click(".evidence [role=tab]:has-text('Readings')");
    await tab.click(`input[aria-label='Use reading ${worst}']`);
    await tab.waitForFunction((was) => {
      const now = document.querySelector(".ladder-row.now .bar-text")?.innerText;
      return now && now !== was && !document.querySelector(".job");
    }, before);
    let state = await stateOf(server);
    assert.equal(state.measurements.set_aside, 1);
    await tab.fill("input[aria-label='Filter the readings']", "aside");
    await tab.waitForFunction(() => document.querySelectorAll(".reading-space .reading-row").length === 1);
    await tab.click("text=/Take all 1 back/");
    await tab.waitForFunction(
      (was) =>
        document.querySelector(".ladder-row.now .bar-text")?.innerText === was && !document.querySelector(".job"),
      before,
    );
    state = await stateOf(server);
    assert.equal(state.measurements.set_aside, 0);
    await close();
  });

  /** Draws a lasso on a picture; corners are fractions of the picture's width and height. */
  async function lasso(tab, selector, corners) {
    const box = await tab.locator(selector).boundingBox();
    const [first, ...others] = corners.map(([x, y]) => [box.x + x * box.width, box.y + y * box.height]);
    await tab.mouse.move(...first);
    await tab.mouse.down();
    for (const corner of [...others, first]) await tab.mouse.move(...corner, {steps: 4});
    await tab.mouse.up();
    return Number(/(\d+) readings? selected/.exec(await tab.innerText(".selection-bar"))[1]);
  }
  const RIGHT = [
    [0.5, 0.01],
    [0.99, 0.01],
    [0.99, 0.99],
    [0.5, 0.99],
  ];
  const marked = async (server) => {
    const {set_aside, held_out} = (await stateOf(server)).measurements;
    return {set_aside, held_out};
  };
  const rest = (tab) =>
    tab.waitForFunction(() => !document.querySelector(".job") && document.querySelectorAll(".ladder-row").length >= 2);

  it("is selected with others by a loop in the plot, set aside, and taken back by undo", async () => {
    const {tab, server, close} = await compared("loop", "hysteresis@theta4:0.06deg");
    const before = await tab.innerText(".ladder");
    const picked = await lasso(tab, ".residual-plot .u-over", RIGHT);
    assert.ok(picked > 20 && picked < 100, `${picked} of 120`);
    await tab.click(".selection-bar >> text=Set aside");
    await tab.waitForSelector(`.selection-bar >> text=${picked} readings set aside`);
    await rest(tab);
    assert.deepEqual(await marked(server), {set_aside: picked, held_out: 0});
    await tab.waitForFunction(
      (was) => ![undefined, was].includes(document.querySelector(".ladder")?.innerText),
      before,
    );
    await tab.click("body", {position: {x: 640, y: 5}});
    await tab.keyboard.press("Control+z");
    await tab.waitForFunction(() => !document.querySelector(".selection-bar"));
    await rest(tab);
    assert.deepEqual(await marked(server), {set_aside: 0, held_out: 0});
    await tab.waitForFunction((was) => document.querySelector(".ladder")?.innerText === was, before);
    await close();
  });

  it("stays selected while other things change and the errors are compared again", async () => {
    const {tab, server, close} = await compared("kept", "hysteresis@theta4:0.06deg");
    const box = await tab.locator(".residual-plot .u-over").boundingBox();
    const [first, second, third, last] = RIGHT.map(([x, y]) => [box.x + x * box.width, box.y + y * box.height]);
    await tab.mouse.move(...first);
    await tab.mouse.down();
    await tab.mouse.move(...second, {steps: 4});
    assert.equal(await ended(server, (await callApi(server, "ladder", {})).body.id), "done"); // during a lasso
    await tab.waitForFunction(() => !document.querySelector(".job"));
    for (const corner of [third, last, first]) await tab.mouse.move(...corner, {steps: 4});
    await tab.mouse.up();
    const picked = await tab.innerText(".selection-bar b");
    assert.match(picked, /^\d\d readings selected$/);
    assert.equal(await ended(server, (await callApi(server, "compare", {})).body.id), "done");
    const {revision} = (await stateOf(server)).results.compare;
    await tab.waitForFunction(
      (wanted) =>
        performance.getEntriesByType("resource").filter(({name}) => name.endsWith("/compare")).length >= wanted,
      3, // requests: the automatic comparison, its result, and the new result
    );
    assert.ok(revision > 1);
    assert.equal(await tab.innerText(".selection-bar b"), picked);
    await close();
  });

  it("is held out by a loop in the places, more with Shift, and the ladder judges by it", async () => {
    const {tab, server, close} = await compared("places", "hysteresis@theta4:0.06deg");
    const before = await tab.innerText(".ladder");
    const some = await lasso(tab, ".evidence canvas", [
      [0.02, 0.02],
      [0.5, 0.02],
      [0.5, 0.5],
      [0.02, 0.5],
    ]);
    await tab.keyboard.down("Shift");
    const more = await lasso(tab, ".evidence canvas", [
      [0.02, 0.5],
      [0.5, 0.5],
      [0.5, 0.98],
      [0.02, 0.98],
    ]);
    await tab.keyboard.up("Shift");
    assert.ok(some > 0 && more > some && more < 120, `${some}, then ${more}`);
    await tab.click(".selection-bar >> text=Hold out");
    await tab.waitForSelector(`.selection-bar >> text=${more} readings held out`);
    await rest(tab);
    assert.deepEqual(await marked(server), {set_aside: 0, held_out: more});
    await tab.waitForFunction(
      (was) => ![undefined, was].includes(document.querySelector(".ladder")?.innerText),
      before,
    );
    await tab.click(".selection-bar >> text=Undo");
    await tab.waitForFunction(() => !document.querySelector(".selection-bar"));
    await rest(tab);
    assert.deepEqual(await marked(server), {set_aside: 0, held_out: 0});
    await close();
  });

  it("is counted by size and in sigmas", async () => {
    const {tab, close} = await compared("histogram", "hysteresis@theta4:0.06deg");
    await tab.click(".evidence [role=tab] >> text=Histogram");
    await tab.waitForSelector(".evidence [aria-label='Histogram of 120 readings: size of the error, in'] canvas");
    await tab.click(".evidence .segments >> text=Sigmas");
    await tab.waitForSelector(".evidence [aria-label='Histogram of 120 readings: error, in its sigmas'] canvas");
    await close();
  });

  it("is selected with all that the filter leaves by keys alone; Esc clears the selection", async () => {
    const {tab, server, close} = await compared("keys", "hysteresis@theta4:0.06deg");
    await tab.focus(".evidence [role=tab] >> nth=0");
    await tab.keyboard.press("ArrowLeft");
    await tab.waitForSelector(".reading-space .reading-row");
    await tab.focus("input[aria-label='Filter the readings']");
    await tab.keyboard.type("load=0");
    const left = Number(/^(\d+) of 120/.exec(await tab.innerText(".reading-tools .muted"))[1]);
    await tab.focus(".reading-rows");
    await tab.keyboard.press("Control+a");
    await tab.waitForSelector(`.selection-bar >> text=${left} readings selected`);
    await tab.keyboard.press("?"); // Esc must close only this help
    await tab.waitForSelector("dialog[open] kbd");
    await tab.keyboard.press("Escape");
    await tab.waitForSelector("dialog[open]", {state: "detached"});
    await tab.waitForSelector(`.selection-bar >> text=${left} readings selected`);
    await tab.focus(".reading-rows");
    await tab.keyboard.press("Escape");
    await tab.waitForFunction(() => !document.querySelector(".selection-bar"));
    await tab.keyboard.press("Control+a");
    await tab.focus(".selection-bar >> text=Set aside");
    await tab.keyboard.press("Enter");
    await tab.waitForSelector(`.selection-bar >> text=${left} readings set aside`);
    await rest(tab);
    assert.deepEqual(await marked(server), {set_aside: left, held_out: 0});
    await close();
  });

  it("stands with all others in 3-D, faded from before to after", async () => {
    const {tab, close} = await compared("field", "hysteresis@theta4:0.06deg");
    await tab.evaluate(() => (location.hash = "arm"));
    await tab.check(".shown-errors >> text=all errors");
    await tab.waitForSelector(".shown-errors >> text=/drawn ×\\d/");
    const picture = async (after) => {
      await tab.fill("input[aria-label='From before to after']", String(after));
      await tab.waitForTimeout(700);
      return (await tab.locator(".arm-picture canvas").screenshot()).toString("base64");
    };
    const before = await picture(0),
      after = await picture(1);
    assert.notEqual(before, after);
    assert.equal(await picture(0), before);
    await close();
  });
});
