// Beside a ladder's errors, how many steps of the tool go in were each model to steer the arm.
import {isNumber, percent, plural, whole} from "../drawing/numbers.js";
import {el, figure, table} from "./elements.js";
import {drawStepBars} from "./step_table.js";
import {lengthText, list, numbers, object, textOf} from "./values.js";

/// [{name, counts}] of the models that were scored; all under the same tool.
function modelStepRows(report) {
  const models = list(report.models), count = models.find((model) => Array.isArray(model.steps))?.steps.length;
  return models.map((model) => ({name: textOf(model.name), counts: numbers(model.steps, count)}))
      .filter((row) => row.counts);
}

export function hasStepCounts(report) { return modelStepRows(report).length > 0; }

export function ladderStepsSection(report) {
  const rows = modelStepRows(report), about = object(report.step_table) ?? {};
  const bars = figure("Holes by number of inserted steps, for each model", (width) => drawStepBars(rows, width));
  const cells = rows.map(({name, counts}) => {
    const total = counts.reduce((sum, count) => sum + count, 0);
    return [name, ...counts.map((count) => `${whole(count)} (${percent(total > 0 ? count / total : null)})`)];
  });
  const beyond = isNumber(about.unmodelled_sigma) && about.unmodelled_sigma > 0 ?
      ` Standard deviation of a coordinate that no model explains: ${lengthText(about.unmodelled_sigma, report)}.` :
      "";
  return [
    el("p", {class: "lead"},
       "Each model computes the postures under the same random holes; the true arm then positions the tip. " +
           `True arm: ${textOf(about.real_arm, "a model")}.${beyond}`),
    el("div", {class: "card"}, bars.element),
    el("div", {class: "card"}, table(["model", ...rows[0].counts.map((_, i) => plural(i, "step"))], cells))
  ];
}
