// Tests of files that are dropped on the page: a robot description becomes a cell, other files are named, and a message
// about a file disappears when the next one is opened.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {existsSync, readFileSync, readdirSync} from "node:fs";
import path from "node:path";
import {it} from "./limits.mjs";
import {begin, drop, finish, openTab, serve, simulate, source, stateOf} from "./workbench.mjs";

const ROBOTS = path.join(source, "tests/app/urdf");
/** Files that are not tables, with a word that states their kind. */
const OTHERS = [
  ["robot.sdf", '<?xml version="1.0"?>\n<sdf version="1.6"><model name="arm"/></sdf>\n', "robot description"],
  ["page.csv", "<!DOCTYPE html>\n<html><body>Sign in</body></html>\n", "web page"],
  ["table.xml", '<?xml version="1.0"?>\n<rows><row x="1"/></rows>\n', "XML"],
  ["plan.json", '{"tubes": [{"row": 1}], "visits": 3}\n', "JSON"],
  ["list.json", '[{"x": 1, "y": 2}]\n', "JSON"],
  ["part.stl", "solid part\n facet normal 0 0 1\n", "mesh"],
  ["table.xlsx", "PK\u0003\u0004\u0014\u0000\u0006\u0000", "workbook"],
  ["report.pdf", "%PDF-1.7\n1 0 obj\n", "PDF"],
  ["arm.txt", "units: {length: in, angle: deg, force: lbf}\nlinks:\n  - name: base\n", "arm file"],
];

let setting, server, tab;
before(async () => {
  setting = await begin();
  simulate(setting.made.folder, "readings", {readings: 40});
  server = await serve(setting.made.folder, "bench.yaml");
  tab = await openTab(setting.browser, server.address);
  await tab.waitForSelector(".project-tools");
});
after(async () => {
  await server?.stop();
  await finish(setting);
});

/** Waits until a cell is open, and confirms that the work so far is closed. */
async function untilOpen(file) {
  while ((await stateOf(server)).cell.file !== file) {
    const closing = tab.locator(`dialog[open] button:has-text('Open ${file}')`);
    if (await closing.isVisible()) await closing.click();
    await tab.waitForTimeout(50);
  }
}

/** Returns a robot with a hand of two fingers, of which one follows the other. */
function withHand() {
  const link = (name, type, parent, more = "") =>
    `<link name="${name}"/><joint name="to_${name}" type="${type}"><parent link="${parent}"/><child link="${name}"/>
    <axis xyz="0 0 1"/><origin xyz="0.3 0 0"/><limit lower="0" upper="1" effort="1" velocity="1"/>${more}</joint>`;
  const parts = [
    link("upper", "revolute", "base"),
    link("lower", "revolute", "upper"),
    link("hand", "fixed", "lower"),
    link("left", "prismatic", "hand"),
    link("right", "prismatic", "hand", '<mimic joint="to_left"/>'),
  ];
  return `<robot name="r"><link name="base"/>${parts.join("")}</robot>`;
}

const noticeText = async () => (await tab.waitForSelector(".notice")).innerText();

describe("a dropped file", () => {
  it("that is no table is named, with what to do", async () => {
    for (const [name, text, word] of OTHERS) {
      await drop(tab, name, text);
      await tab.waitForSelector(`.notice:has-text('${name}')`);
      assert.ok((await noticeText()).includes(word), `${name}: ${await noticeText()}`);
      assert.equal(await tab.locator(".notice").count(), 1, "the message about the file before is gone");
      assert.equal(await tab.locator(".notice .advice").count(), 1, name);
    }
  });

  it("that can be read takes the message about the one before away", async () => {
    await drop(tab, "bad.pdf", "%PDF-1.7\n");
    await tab.waitForSelector(".notice");
    await drop(tab, "readings.csv", readFileSync(path.join(setting.made.folder, "readings.csv"), "utf8"));
    await tab.waitForSelector(".notice", {state: "detached"});
    while (!(await stateOf(server)).measurements) await tab.waitForTimeout(50);
    assert.equal((await stateOf(server)).measurements.readings, 40);
  });

  it("with a robot becomes an arm and a cell, which are opened and exported again", async () => {
    while ((await stateOf(server)).jobs.some(({status}) => status === "running")) await tab.waitForTimeout(100);
    for (const name of readdirSync(ROBOTS)) {
      const stem = path.basename(name, ".urdf");
      await drop(tab, name, readFileSync(path.join(ROBOTS, name), "utf8"));
      await untilOpen(`${stem}.yaml`);
      assert.ok(existsSync(path.join(setting.made.folder, `${stem}-arm.yaml`)), name);
      const failures = tab.locator(".notice:not(.note-of-success)");
      assert.deepEqual(await failures.allInnerTexts(), [], `${name} is not reported as a failure`);
      const exported = await fetch(`${server.address}api/export/arm.urdf`);
      const text = readFileSync(path.join(ROBOTS, name), "utf8");
      assert.ok((await exported.text()).startsWith(text), `${name} is exported into its own file`);
      await tab.waitForSelector(".view-arm .slider > span");
      const isCut = (spans) => spans.filter(({scrollWidth, clientWidth}) => scrollWidth > clientWidth).length;
      assert.equal(await tab.locator(".slider > span").evaluateAll(isCut), 0, `${name}: names beside the sliders`);
    }
    await tab.click(".project-tools summary");
    await tab.waitForSelector(".project-tools a[download='arm.urdf']");
    await tab.keyboard.press("Escape");
  });

  it("with a robot that has several ends asks for the tip, and nothing is written before", async () => {
    const isWritten = () => existsSync(path.join(setting.made.folder, "hand.yaml"));
    await drop(tab, "hand.urdf", withHand());
    const choice = tab.locator("dialog[open] .choice-form select");
    await choice.waitFor();
    const values = await choice.locator("option").evaluateAll((options) => options.map(({value}) => value));
    assert.deepEqual(values, ["left", "hand", "lower", "upper"]);
    if (process.env.PICTURES) await tab.screenshot({path: `${process.env.PICTURES}/tips.png`});
    await tab.keyboard.press("Escape");
    await tab.waitForSelector("dialog[open]", {state: "detached"});
    assert.ok(!isWritten());
    await drop(tab, "hand.urdf", withHand());
    await choice.selectOption("hand");
    await tab.click("dialog[open] .choice-form [type=submit]");
    await untilOpen("hand.yaml");
    const {cell} = await stateOf(server);
    assert.deepEqual(
      cell.joints.map(({name}) => name),
      ["to_upper", "to_lower"],
    );
  });
});
