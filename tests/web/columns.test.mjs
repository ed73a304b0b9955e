// Tests of foreign tables opened in the page: a tracker's points and a log of the joints, column by column.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {readFileSync, writeFileSync} from "node:fs";
import path from "node:path";
import {it} from "./limits.mjs";
import {callApi, drop, launch, makeFolder, openTab, serve, simulate, stateOf} from "./workbench.mjs";

let made, browser, points, log;

/** Writes the simulated readings in the file formats of a tracker and of a robot controller. */
function writeForeign() {
  const [head, ...rows] = readFileSync(path.join(made.folder, "readings.csv"), "utf8").trim().split("\n");
  const at = (name) => head.split(",").indexOf(name);
  const fields = rows.map((row) => row.split(","));
  points = path.join(made.folder, "points.txt");
  log = path.join(made.folder, "log.csv");
  const place = (row) => ["x_in", "y_in", "z_in"].map((name) => row[at(name)]).join("  ");
  writeFileSync(points, `Exported points\n${fields.map((row, k) => `Job::Arm::P${k} ${place(row)}`).join("\n")}\n`);
  const joints = (row) => [1, 2, 3, 4].map((k) => row[at(`theta${k}_deg`)].replace(".", ","));
  const lines = fields.map((row, k) => [`P${k}`, ...joints(row), row[at("load_lbf")].replace(".", ",")].join(";"));
  writeFileSync(log, `Point;J1;J2;J3;J4;Payload [lb]\n${lines.join("\n")}\n`);
}

before(async () => {
  made = makeFolder();
  simulate(made.folder, "readings", {hide: "", seed: 7, readings: 40});
  writeForeign();
  browser = await launch();
});
after(async () => {
  await browser?.close();
  made?.remove();
});

async function openFiles(tab, files) {
  await tab.waitForSelector(".project-tools");
  await tab.keyboard.press("o");
  await tab.setInputFiles("dialog[open] input[type=file]", files);
  await tab.waitForSelector("dialog[open] >> text=Meaning of the columns");
}

describe("tables of other programs", () => {
  it("become readings once their units are said, which is not asked again", async () => {
    const server = await serve(made.folder, "bench.yaml");
    const tab = await openTab(browser, server.address);
    await openFiles(tab, [log, points]);
    const take = tab.locator("dialog[open] button[type=submit]");
    assert.equal(await take.isDisabled(), true);
    await tab.selectOption("select[aria-label='unit of J2']", "deg"); // serves all joints
    await tab.selectOption("select[aria-label='unit of column 3']", "in");
    assert.equal(await tab.inputValue("select[aria-label='unit of Payload [lb]']"), "lbf");
    await take.click();
    await tab.waitForSelector("dialog[open] >> text=the reading has no sigma");
    await tab.fill("dialog[open] label:has-text('standard deviation') input", "0.005");
    if (process.env.PICTURES) await tab.screenshot({path: `${process.env.PICTURES}/columns.png`});
    await take.click();
    await tab.waitForFunction(() => !document.querySelector("dialog[open]"));
    assert.equal((await stateOf(server)).measurements.readings, 40);
    await callApi(server, "compare");

    await openFiles(tab, [log, points]);
    assert.equal(await take.isDisabled(), false);
  });

  it("ask for the columns without a message of failure, and take earlier ones away", async () => {
    const server = await serve(made.folder, "bench.yaml");
    const tab = await openTab(browser, server.address);
    const text = readFileSync(path.join(made.folder, "readings.csv"), "utf8").replace(/^id,/, "name,");
    await tab.waitForSelector(".project-tools");
    await drop(tab, "scan.pdf", "%PDF-1.7\n");
    await tab.waitForSelector(".notice");
    await drop(tab, "tracker.csv", text);
    await tab.waitForSelector("dialog[open] >> text=Meaning of the columns");
    await tab.click("dialog[open] button[type=submit]");
    await tab.waitForFunction(() => !document.querySelector("dialog[open]"));
    assert.equal((await stateOf(server)).measurements.readings, 40);
    assert.deepEqual(await tab.locator(".notice").allInnerTexts(), []);
    await tab.context().close();
    await server.stop();
  });

  it("without the joints are refused in words", async () => {
    const server = await serve(made.folder, "bench.yaml");
    const tab = await openTab(browser, server.address);
    await openFiles(tab, [points]);
    await tab.waitForSelector("dialog[open] >> text=a column for theta1");
    assert.equal(await tab.locator("dialog[open] button[type=submit]").isDisabled(), true);
    assert.equal((await stateOf(server)).measurements, null);
  });
});
