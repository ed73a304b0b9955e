// Tests of actions on the results: any earlier model is restored, and effects and fitted parameters are switched off
// and on. The run sheet is ticked off and dropped back on the page, after which the posterior changes. Explanations are
// shown side by side.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {readFileSync, writeFileSync} from "node:fs";
import path from "node:path";
import {it} from "./limits.mjs";
import {
  begin,
  callApi,
  closable,
  drop,
  ended,
  errorsOf,
  finish,
  openTab,
  serve,
  simulate,
  stateOf,
} from "./workbench.mjs";

const LIMIT = {timeout: 120_000};
let made, browser;

before(async () => ({made, browser} = await begin()));
after(() => finish({made, browser}));

const idle = (tab) => tab.waitForFunction(() => !document.querySelector(".job"), null, LIMIT);

/** Starts `tubeplan serve CELL READINGS`, which compares automatically, and diagnoses by a click. */
async function diagnosed(name, options) {
  simulate(made.folder, name, options);
  const server = await serve(made.folder, "bench.yaml", [path.join(made.folder, `${name}.csv`)]);
  const tab = await openTab(browser, `${server.address}`);
  await tab.click(".next:has-text('Diagnose'):not([disabled])", LIMIT);
  await tab.waitForSelector(".explanation", LIMIT);
  await idle(tab);
  return closable(tab, server);
}

describe("the models as steps", () => {
  it("are gone back to by a click; effects and fitted numbers are switched off and on", async () => {
    const {tab, server, close} = await diagnosed("steps", {hide: "hysteresis@theta4:0.06deg"});
    await tab.click(".next:has-text('Add')");
    await tab.waitForSelector(".models >> text=+ hysteresis at theta4", LIMIT);
    await idle(tab);
    const steps = ".model-panel ol button";
    await tab.click(".model-steps summary");
    assert.deepEqual(await tab.locator(`${steps} span`).allInnerTexts(), ["as given", "+ hysteresis at theta4"]);
    await tab.click(`${steps} >> nth=0`);
    await tab.waitForSelector(`${steps}[aria-current] >> text=as given`);
    assert.equal((await stateOf(server)).model, 0);
    await tab.click(`${steps} >> nth=1`);
    await tab.waitForSelector(`${steps}[aria-current] >> text=+ hysteresis at theta4`);
    const fitted = (await stateOf(server)).models[0].free.length;
    assert.equal(await tab.locator(".model-panel input:checked").count(), fitted + 1);

    await tab.click(".model-panel label:has-text('hysteresis at theta4') input");
    await tab.waitForSelector(`${steps}[aria-current] >> text=− hysteresis at theta4`, LIMIT);
    await idle(tab);
    assert.deepEqual((await stateOf(server)).models.at(-1).effects, []);
    await tab.waitForFunction(() => document.querySelectorAll(".ladder-row").length === 4);
    await tab.click(".model-panel label:has-text('hysteresis at theta4') input");
    await tab.waitForFunction(() => document.querySelectorAll(".model-panel ol button").length === 4, null, LIMIT);
    await idle(tab);
    await tab.click(".model-panel label:has-text('forearm.joint_stiffness.z') input");
    await tab.waitForFunction(() => document.querySelectorAll(".model-panel ol button").length === 5, null, LIMIT);
    await idle(tab);
    assert.equal(await tab.locator(".model-panel input:checked").count(), fitted);
    // Esc must close the panel, with or without the focus in it, and so must a click elsewhere.
    await tab.focus(".model-panel input >> nth=0");
    await tab.keyboard.press("Escape");
    await tab.waitForSelector(".model-panel", {state: "hidden"});
    await tab.click(".model-steps summary");
    await tab.evaluate(() => document.activeElement.blur());
    await tab.keyboard.press("Escape");
    await tab.waitForSelector(".model-panel", {state: "hidden"});
    await tab.click(".model-steps summary");
    await tab.mouse.click(640, 700);
    await tab.waitForSelector(".model-panel", {state: "hidden"});
    await close();
  });
});

describe("several explanations", () => {
  it("stand side by side, and the run sheet that is to split them is filled in, dropped back, and moves the posterior", async () => {
    const {tab, server, close} = await diagnosed("open", {
      hide: "backlash@tool.z:0.15deg",
      readings: 90,
      seed: 12,
      spread: "0",
    });
    await tab.waitForSelector(".verdict h1 >> text=/A or B|of several|alternatives|ambiguous/i");
    await tab.waitForFunction(() => document.querySelectorAll(".plots.two .uplot").length === 2);
    const titles = await tab.locator(".plot-title").allInnerTexts();
    assert.match(titles[0], /^A /);
    assert.match(titles[1], /^B /);
    await tab.click(".explanation >> nth=1 >> text=Draw");
    await tab.waitForSelector(".plot-title >> nth=0 >> text=/^B/");
    await tab.selectOption("select[aria-label='Explanation beside']", "-1");
    await tab.waitForFunction(() => document.querySelectorAll(".plots .uplot").length === 1);

    await tab.click(".next:has-text('Readings that distinguish them')");
    const rows = tab.locator(".run-sheet tbody tr");
    await rows.first().waitFor();
    const count = await rows.count();
    assert.ok(count >= 3);
    const text = (await callApi(server, "results/diagnose")).body.run_sheet;
    const [header, ...lines] = text.trim().split("\n");
    assert.equal(lines.length, count);
    const columns = header.split(",");
    const at = (prefix) => columns.findIndex((name) => name.startsWith(prefix));
    /** Returns the tip position that the model predicts, to be entered as a measured position. */
    const place = async (line) => {
      const fields = line.split(",");
      const joints = [1, 2, 3, 4].map((k) => Number(fields[columns.indexOf(`theta${k}_deg`)]));
      return (await callApi(server, "pose", {joints, load: Number(fields[at("load")])})).body.tip.flexible;
    };
    // The coordinates of the first reading are typed by hand.
    const first = await place(lines[0]);
    const id = lines[0].split(",")[0];
    for (const [k, axis] of ["x_in", "y_in", "z_in"].entries())
      await tab.fill(`input[aria-label='${axis} of ${id}']`, first[k].toFixed(4));
    assert.ok(await tab.isChecked(`input[aria-label='Reading ${id} is taken']`));
    await tab.reload();
    await tab.click(".tabs >> text=A or B");
    assert.equal(await tab.inputValue(`input[aria-label='x_in of ${id}']`), first[0].toFixed(4));
    await tab.click(".run-sheet >> text=Add 1 reading");
    await tab.waitForSelector(".verdict-figures dd >> text=91", LIMIT);
    await tab.waitForSelector(".run-sheet tr.here", LIMIT);
    await idle(tab);
    assert.equal((await stateOf(server)).measurements.readings, 91);
    await tab.waitForSelector(".posterior svg", LIMIT);

    // In the file, the second reading is filled in, and all further readings are still empty.
    const second = lines[1].split(",");
    (await place(lines[1])).forEach((value, k) => (second[at(["x_", "y_", "z_"][k])] = value.toFixed(4)));
    await drop(tab, "run-sheet.csv", [header, lines[0], second.join(","), ...lines.slice(2), ""].join("\n"));
    await tab.waitForFunction(() => document.querySelectorAll(".run-sheet tr.here").length === 2, null, LIMIT);
    await idle(tab);
    assert.equal((await stateOf(server)).measurements.readings, 92);
    await tab.waitForFunction(() => /92/.test(document.querySelector(".posterior svg")?.textContent), null, LIMIT);
    await drop(tab, "run-sheet.csv", text);
    await tab.waitForSelector(".notice >> text=/No row of this run sheet is filled in/");
    await tab.keyboard.press("Escape");
    await close();
  });

  it("other readings that are dropped join those that are here, or take their place", async () => {
    const file = simulate(made.folder, "first", {hide: "hysteresis@theta4:0.06deg", readings: 40});
    const server = await serve(made.folder, "bench.yaml", [file]);
    const tab = await openTab(browser, `${server.address}`);
    await tab.waitForSelector(".verdict-figures dd >> text=40", LIMIT);
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    const [header, ...lines] = readFileSync(simulate(made.folder, "second", {readings: 30, seed: 9}), "utf8")
      .trim()
      .split("\n");
    const others = [header, ...lines.map((line) => `x${line}`), ""].join("\n");
    await drop(tab, "second.csv", others);
    await tab.click("dialog[open] >> text=Add them to these");
    await tab.waitForSelector(".verdict-figures dd >> text=70", LIMIT);
    await idle(tab);
    await tab.click(".reading-checks li:has-text('30 readings joined the 40 before') >> text=Take out again");
    await tab.waitForSelector(".verdict-figures dd >> text=40", LIMIT);
    await tab.waitForSelector(".ladder-row >> text=/× floor/", LIMIT);
    await tab.waitForFunction(() => !document.querySelector(".reading-checks"), null, LIMIT);
    await idle(tab);
    await drop(tab, "third.csv", others.replaceAll("\nx", "\ny"));
    await tab.click("dialog[open] >> text=Open them instead");
    await tab.waitForSelector(".chip-more >> text=third.csv", LIMIT);
    await tab.waitForSelector(".verdict-figures dd >> text=30", LIMIT);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });
});

describe("readings that look wrong", () => {
  it("are mended by one click, which is the first that is offered", async () => {
    const file = simulate(made.folder, "inches", {hide: "hysteresis@theta4:0.06deg"});
    const wrong = path.join(made.folder, "millimetres.csv");
    writeFileSync(wrong, readFileSync(file, "utf8").replace("x_in,y_in,z_in", "x_mm,y_mm,z_mm"));
    const server = await serve(made.folder, "bench.yaml", [wrong]);
    const tab = await openTab(browser, server.address);
    await tab.waitForSelector(".reading-checks .mistake");
    assert.doesNotMatch(await tab.innerText(".error-view"), /--assume/);
    await tab.click(".next:has-text('Assume coordinates=in'):not([disabled])", LIMIT);
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    assert.equal(await tab.locator(".reading-checks .mistake").count(), 0);
    await tab.waitForSelector(".ladder-row >> text=/× floor/");
    await tab.click(".reading-checks li:has-text('Used with coordinates=in') >> text=Take back");
    await tab.waitForSelector(".reading-checks .mistake");
    await idle(tab);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });

  it("are mended and replaced while they are being compared", async () => {
    const file = simulate(made.folder, "slow", {hide: "hysteresis@theta4:0.06deg"});
    const text = readFileSync(file, "utf8");
    const wrong = path.join(made.folder, "slow-millimetres.csv");
    writeFileSync(wrong, text.replace("x_in,y_in,z_in", "x_mm,y_mm,z_mm"));
    const server = await serve(made.folder, "bench.yaml", [wrong]);
    // The page's automatic requests are delayed until after the click.
    const tab = await openTab(browser, server.address, {
      prepare: (page) =>
        page.route("**/api/compare", async (route) => {
          await new Promise((resolve) => setTimeout(resolve, 1500));
          await route.continue();
        }),
    });
    await tab.click(".next:has-text('Assume coordinates=in'):not([disabled])", LIMIT);
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    await tab.click(".next:has-text('Diagnose')");
    await tab.waitForFunction(() => document.querySelector(".next")?.disabled, null, LIMIT);
    await drop(tab, "others.csv", text.replaceAll("\n", "\ny").replace(/\ny$/, "\n"));
    await tab.click("dialog[open] >> text=Open them instead");
    await tab.waitForSelector(".chip-more >> text=others.csv", LIMIT);
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    assert.deepEqual(await tab.locator(".notice").allInnerTexts(), []);

    // Two tables in the program's format, opened together, form one set of readings; a cell file is refused.
    const [header, ...lines] = text.trim().split("\n");
    const half = (part, mark) => [header, ...part.map((line) => `${mark}${line}`), ""].join("\n");
    await drop(tab, [
      ["one.csv", half(lines.slice(0, 50), "a")],
      ["two.csv", half(lines.slice(50, 90), "b")],
    ]);
    await tab.click("dialog[open] >> text=Open them instead");
    await tab.waitForSelector(".verdict-figures dd >> text=90", LIMIT);
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    assert.equal((await stateOf(server)).measurements.readings, 90);
    assert.deepEqual(await tab.locator(".notice").allInnerTexts(), []);
    await drop(tab, [["bench.yaml", "arm: cobra-arm.yaml"]]);
    await tab.waitForSelector(".notice >> text=opened from the folder");
    assert.deepEqual(errorsOf(tab), []);
    await tab.context().close();
    await server.stop();
  });

  it("are replaced where the answer comes after the word that the work on those before has ended", async () => {
    const text = readFileSync(simulate(made.folder, "late", {hide: "hysteresis@theta4:0.06deg"}), "utf8");
    const server = await serve(made.folder, "bench.yaml", [path.join(made.folder, "late.csv")]);
    const isIdle = async () => (await stateOf(server)).jobs.every((job) => job.status !== "running");
    const tab = await openTab(browser, server.address, {
      prepare: (page) =>
        page.route("**/api/measurements?name=*", async (route) => {
          const response = await route.fetch();
          while (!(await isIdle())) await new Promise((resolve) => setTimeout(resolve, 30));
          await new Promise((resolve) => setTimeout(resolve, 500)); // time for the page to receive the state
          await route.fulfill({response});
        }),
    });
    await tab.click(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    await drop(tab, "others.csv", text.replaceAll("\n", "\ny").replace(/\ny$/, "\n"));
    await tab.click("dialog[open] >> text=Open them instead");
    await tab.waitForSelector(".chip-more >> text=others.csv", LIMIT);
    await tab.waitForSelector(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    assert.deepEqual(await tab.locator(".notice").allInnerTexts(), []);
    assert.deepEqual(errorsOf(tab), []);
    await tab.context().close();
    await server.stop();
  });

  it("too few of them lead to more, and what was compared stays to be seen", async () => {
    const lines = readFileSync(simulate(made.folder, "many", {readings: 30}), "utf8").split("\n");
    const few = path.join(made.folder, "few.csv");
    writeFileSync(few, [...lines.slice(0, 4), ""].join("\n"));
    const server = await serve(made.folder, "bench.yaml", [few]);
    const tab = await openTab(browser, server.address);
    await tab.click(".next:has-text('Diagnose'):not([disabled])", LIMIT);
    await tab.click(".next:has-text('Open more readings')", LIMIT);
    await tab.waitForSelector("dialog[open] .file");
    await tab.keyboard.press("Escape");
    await tab.waitForSelector(".residual-plot .uplot");
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });
});

describe("the arm's picture", () => {
  it("is framed in any unit of length, and its read-out has the decimals of the unit", async () => {
    const server = await serve(made.folder, "puma.yaml"); // this cell's lengths are in metres
    const tab = await openTab(browser, `${server.address}#arm`, {colorScheme: "light"});
    await tab.waitForFunction(() => /\d\.\d{5}$/.test(document.querySelector(".readout .figure b")?.textContent));
    await tab.waitForFunction(() => /m$/.test(document.querySelector(".clearance-figure")?.textContent));
    const picture = await tab.locator(".arm-picture canvas").screenshot();
    const other = await tab.context().newPage();
    // The arm and the line of clearance cover only a part of the picture; scaled for inches, they would fill it.
    const share = await other.evaluate(async (base64) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [image.width, image.height];
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const {data} = context.getImageData(0, 0, canvas.width, canvas.height);
      let strong = 0;
      for (let i = 0; i < data.length; i += 4)
        if (Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 60) ++strong;
      return strong / (data.length / 4);
    }, picture.toString("base64"));
    assert.ok(share > 0.005 && share < 0.25, `coloured share ${share}`);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });
});

describe("the sheet", () => {
  it("goes from before to after the last change of the model, in bands of one scale", async () => {
    const server = await serve(made.folder, "mockup.yaml", ["--truth", path.join(made.folder, "mockup-true.yaml")]);
    for (const hole of [500, 2500, 4000]) await callApi(server, "touch", {hole});
    assert.equal(await ended(server, (await callApi(server, "calibrate", {})).body.id), "done");
    const tab = await openTab(browser, `${server.address}#sheet`);
    await tab.click(".sheet-view .segments >> text=Sag");
    await tab.click("text=Compute sag", LIMIT);
    await tab.waitForSelector(".before-after >> text=after", LIMIT);
    await tab.waitForFunction(() => !document.querySelector(".to-compute"), null, LIMIT);
    await tab.click(".before-after >> text=before"); // the missing field is computed automatically
    await tab.waitForSelector(".before-after .muted >> text=as given");
    await tab.waitForFunction(
      () => !document.querySelector(".to-compute") && !document.querySelector(".job"),
      null,
      LIMIT,
    );
    const bands = () => tab.locator(".legend span").allInnerTexts();
    const before = await bands();
    assert.ok(before.length > 2);
    await tab.click(".before-after .segments >> text=after");
    await tab.waitForFunction(
      (was) => !document.querySelector(".before-after .muted").innerText.includes(was),
      "as given",
    );
    assert.deepEqual(await bands(), before);
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  });
});
