// What the errors depend on, the worst readings, and a ladder's models as a table.
import {errorUnit} from "../drawing/error_budget.js";
import {errorOf} from "../drawing/ladder.js";
import {fixed, isNumber, pValue, short, whole} from "../drawing/numbers.js";
import {barred} from "../drawing/ranking.js";
import {barCell} from "./effect_ranking.js";
import {el, notRecorded, table} from "./elements.js";
import {conditionsText, sizeOf} from "./error_series.js";
import {lengthUnit, list, object, textOf} from "./values.js";

/// Patterns as texts or as {name | of | with, sentence | text, p_value, share | correlation}.
export function patternsSection(report) {
  const given = Array.isArray(report.patterns) ? report.patterns : null;
  if (!given) return [notRecorded("What the errors depend on")];
  if (given.length === 0) return [el("p", {}, "The errors depend on nothing recorded in the readings.")];
  const rows = given.map((pattern) => {
    const entry = object(pattern);
    if (!entry) return [textOf(pattern), null, null];
    const strength = [entry.share_of_misfit, entry.share, entry.explains, entry.correlation].find(isNumber);
    return [
      textOf(entry.sentence, textOf(entry.text, textOf(entry.name, textOf(entry.of, textOf(entry.with))))),
      isNumber(strength) ? barCell(barred(Math.abs(strength), 1, fixed(strength, 2))) : null,
      isNumber(entry.p_value) ? pValue(entry.p_value) : null
    ];
  });
  return [el("div", {class: "card"}, table(["the errors depend on", "share explained", "p-value"], rows))];
}

/// Worst readings as ids, or as {id, error | size, sigmas}.
export function worstSection(report) {
  const given = Array.isArray(report.worst) ? report.worst : null;
  if (!given) return [notRecorded("The worst readings")];
  const byId = new Map(list(report.readings).map((reading) => [String(reading.id), reading]));
  const rows = given.map((worst) => {
    const entry = object(worst) ?? {id: worst};
    const reading = byId.get(textOf(entry.id));
    const size = [entry.error, entry.size, entry.rms, sizeOf(reading?.after ?? reading?.before)].find(isNumber);
    return [
      textOf(entry.id), textOf(entry.point ?? reading?.point), reading ? conditionsText(report, reading) : null,
      `${short(size)} ${textOf(entry.unit, lengthUnit(report))}`, isNumber(entry.sigmas) ? fixed(entry.sigmas, 1) : null
    ];
  });
  return [el(
      "div", {class: "card"},
      table(["reading", "point", "at", "error", "in sigmas"], rows, {text: [0, 1, 2]}))];
}

export function modelsSection(report) {
  const unit = errorUnit(report);
  const models = list(report.models).length > 0 ? list(report.models) : list(report.ladder);
  if (models.length === 0) return [notRecorded("The models")];
  const rows = models.map(
      (model) =>
          [textOf(model.name, textOf(model.model, textOf(model.cell))), short(errorOf(model.rms)),
           short(errorOf(model.heldout_rms ?? model.heldout)),
           isNumber(model.chi2_per_dof) ? short(model.chi2_per_dof) : null,
           isNumber(model.p_value) ? pValue(model.p_value) : null,
           isNumber(model.numbers) ? whole(model.numbers) : null]);
  return [el(
      "div", {class: "card"},
      table(
          ["model", `error, ${unit}`, `held-out, ${unit}`, "chi-square per degree of freedom", "p", "fitted numbers"],
          rows))];
}
