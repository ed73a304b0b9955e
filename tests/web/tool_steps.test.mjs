// Tests of plan reports for tools with one to eight steps: a report shows the counts, names and probabilities in the
// plan's plan.json.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {execFileSync} from "node:child_process";
import {readFileSync, writeFileSync} from "node:fs";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {it} from "./limits.mjs";
import {launch, makeFolder, openTab, program} from "./workbench.mjs";

const TOOLS = [1, 2, 3, 4, 5, 6, 7, 8];
const MODES = ["none", "goal_point", "via_point"];

let made, browser;

before(async () => {
  made = makeFolder();
  browser = await launch();
});
after(async () => {
  await browser?.close();
  made?.remove();
});

/** Writes both mock-up cells with a tool of n steps, each thicker and with less tolerance than the step before. */
function writeTool(n) {
  const steps = Array.from({length: n}, (_, k) => {
    const diameter = 0.58 + (0.16 * k) / Math.max(1, n - 1);
    return `{diameter: ${diameter.toFixed(4)}, tolerance: ${((0.75 - diameter) / 1.9).toFixed(5)}}`;
  });
  const tool = `calibration_tool:\n  steps: [${steps.join(", ")}]\n  lengths: [${steps.map(() => 0.2).join(", ")}]\n`;
  for (const name of ["mockup", "mockup-true"]) {
    const text = readFileSync(path.join(made.folder, `${name}.yaml`), "utf8");
    const withTool = text.replace(/calibration_tool:[\s\S]*?(?=scene:)/, tool);
    writeFileSync(path.join(made.folder, `${name}-${n}.yaml`), withTool);
  }
}

function planWith(n) {
  writeTool(n);
  const words = `plan mockup-${n}.yaml --tubes spread:6 --touches auto --truth mockup-true-${n}.yaml --seed 1 --out out${n}`;
  execFileSync(program, words.split(" "), {cwd: made.folder, stdio: "pipe", timeout: 120000});
  return JSON.parse(readFileSync(path.join(made.folder, `out${n}/plan.json`), "utf8"));
}

const numbersIn = (text) => (text.match(/\d+/g) ?? []).map(Number);

describe("a report", () => {
  for (const n of TOOLS)
    it(`of a tool of ${n} step${n > 1 ? "s" : ""} counts as its plan does`, async () => {
      const plan = planWith(n);
      assert.equal(plan.step_words.length, n + 1);
      const tab = await openTab(browser, "about:blank");
      await tab.goto(pathToFileURL(path.join(made.folder, `out${n}/report.html`)).href);
      await tab.waitForFunction(() => document.getElementById("foot").textContent !== "");
      assert.deepEqual(tab.errors, []);

      const whole = plan.counts.via_point.at(-1);
      const said = `${plan.step_words.at(-1)} in ${whole} of ${plan.tubes.length} tubes with via-point compensation`;
      assert.ok((await tab.innerText("body")).includes(`${said}, ${plan.counts.none.at(-1)} without`), said);

      const rows = await tab.locator("#steps tbody tr").allInnerTexts();
      assert.equal(rows.length, MODES.length);
      rows.forEach((row, m) => {
        const counts = numbersIn(
          row
            .replaceAll(/\([^)]*\)/g, "")
            .split("\t")
            .slice(1)
            .join(" "),
        );
        const given = plan.counts[MODES[m]];
        assert.deepEqual(counts, [...given, given.reduce((sum, count) => sum + count, 0)], row);
      });

      const legend = await tab.locator("#sheet .legend >> nth=1").locator("li").allInnerTexts();
      plan.step_words.forEach((words, k) => {
        const entry = legend.find((text) => text.startsWith(words));
        assert.deepEqual(numbersIn(entry.slice(words.length)), [plan.counts.via_point[k]], entry);
      });

      await tab.locator("#tubes summary").click();
      await tab.locator("#tubes tbody tr").first().waitFor();
      const heads = await tab.locator("#tubes thead th").allInnerTexts();
      const column = heads.indexOf(`probability that ${plan.step_words.at(-1)}`);
      const cells = await tab.locator(`#tubes tbody tr td:nth-child(${column + 1})`).allInnerTexts();
      plan.tubes.forEach(({probability_by_steps: chances}, i) => {
        assert.equal(chances.length, n + 1);
        const shown = Number(cells[i].match(/[\d.]+/)[0]) / 100;
        assert.ok(Math.abs(shown - chances.at(-1)) < 0.002, `${cells[i]} ${chances.at(-1)}`);
      });
      assert.ok(!/[Tt]hesis/.test(await tab.innerText("body")));
      await tab.context().close();
    });
});
