// Explanations side by side, and the readings at which they differ most.
import {errorUnit} from "../drawing/error_budget.js";
import {explanationTitle, isEnough, sizeText} from "../drawing/explanations.js";
import {pValue, short} from "../drawing/numbers.js";
import {letterOf} from "../drawing/reading_errors.js";
import {el, notRecorded, table} from "./elements.js";
import {noiseFloorOf} from "./error_ladder.js";
import {conditionsText, reportExplanations, rootMeanSquare} from "./error_series.js";
import {lengthUnit, list, numbers, textOf} from "./values.js";

const MOST_DIFFERING = 6;
const SAME_SHARE = 0.01;  // of the noise: explanations nearer than that are the same at these readings

export function alternativesSection(report) {
  const explanations = reportExplanations(report);
  if (explanations.length < 2) return null;
  const enough = isEnough(explanations[0]);
  return [
    el("p", {class: "lead"},
       enough ? "Each of these suffices alone; these readings cannot distinguish between them." :
                "The best of the known effects. None of them reduces the error to the noise floor."),
    el("div", {class: "card"}, alternativesTable(report, explanations)),
    el("div", {class: "pair"},
       explanations.slice(1).map((other, i) => differenceCard(report, explanations[0], other, i + 1)))
  ];
}

function alternativesTable(report, explanations) {
  const unit = errorUnit(report);
  const rows = explanations.map(
      (entry, i) =>
          [`${letterOf(i)}: ${explanationTitle(entry)}`,
           el("span", {}, entry.effects.map((effect) => el("div", {}, sizeText(effect)))), short(entry.rms),
           short(entry.heldout_rms), short(entry.chi2), pValue(entry.p_value)]);
  return table(
      ["explanation", "sizes", `error, ${unit}`, `held-out, ${unit}`, "chi-square", "p of what is left"], rows,
      {text: [0, 1]});
}

/// Where two explanations, each fitted with everything that is free, predict different readings.
function differencesOf(report, a, b) {
  return list(report.readings)
      .map((reading) => ({reading, between: differenceAt(reading, a, b)}))
      .filter((entry) => entry.between !== null)
      .sort((one, other) => other.between - one.between);
}

function differenceAt(reading, a, b) {
  const first = numbers(reading.explained?.[a], 3), second = numbers(reading.explained?.[b], 3);
  return first && second ? Math.hypot(...first.map((value, i) => value - second[i])) : null;
}

function differenceCard(report, leader, other, index) {
  const heading = el("h3", {}, `${explanationTitle(leader)}, or ${explanationTitle(other)}`);
  const differences = differencesOf(report, 0, index);
  if (differences.length === 0) return el("div", {class: "card"}, heading, notRecorded("Where they differ"));
  const unit = lengthUnit(report), floor = errorUnit(report) === unit ? noiseFloorOf(report) : null;
  const rms = rootMeanSquare(differences.map((entry) => entry.between));
  if (floor !== null && rms < SAME_SHARE * floor) {
    const text =
        "At these readings both predict the same to within a hundredth of the noise: no fit to them can distinguish them.";
    return el("div", {class: "card"}, heading, el("p", {class: "note"}, text));
  }
  const rows = differences.slice(0, MOST_DIFFERING)
                   .map(({reading, between}) => [textOf(reading.id), conditionsText(report, reading), short(between)]);
  return el(
      "div", {class: "card"}, heading,
      el("p", {class: "note"},
         `They put the tip ${short(rms)} ${unit} apart (root mean square over the readings)` +
             `${floor === null ? "" : `, where noise is ${short(floor)} ${unit}`}. They differ most at:`),
      table(["reading", "at", `apart, ${unit}`], rows, {text: [0, 1]}));
}
