// Every visited tube's figures, made only when asked for.
import {fixed, plural, probability, short, whole} from "../drawing/numbers.js";
import {stepCountOf, stepMark, stepText} from "../drawing/steps.js";
import {chancesOf, modesOf, scoredCase} from "./cases.js";
import {el, notRecorded, table} from "./elements.js";
import {markIcon} from "./mark_drawing.js";
import {angleUnit, lengthUnit, list, object, tubeName} from "./values.js";

export function tubeTableSection(report) {
  const tubes = list(report.tubes);
  if (tubes.length === 0) return [notRecorded("Visited tubes")];
  const place = el("div");
  const fill = (event) => {
    if (event.target.open && place.childElementCount === 0) place.append(tubeTable(report, tubes));
  };
  return [el(
      "details", {class: "card", toggle: fill}, el("summary", {}, `Figures of ${plural(tubes.length, "visited tube")}`),
      place)];
}

function tubeTable(report, tubes) {
  const unit = lengthUnit(report);
  const rows = tubes.map(
      (tube, i) =>
          [whole(i + 1), tubeName(tube), fixed(tube.x, 3), fixed(tube.y, 3), short(tube.tilt),
           short(tube.predicted_error), probability(chancesOf(tube, report)?.at(-1)),
           ...modesOf(report).map((mode) => scoreCell(tube, mode.key, report))]);
  return table(
      [
        "visit", "tube", `x, ${unit}`, `y, ${unit}`, `tilt, ${angleUnit(report)}`, `predicted error, ${unit}`,
        `probability that ${stepText(report.step_words, stepCountOf(report))}`,
        ...modesOf(report).map((mode) => `error, ${unit}, and steps: ${mode.brief}`)
      ],
      rows, {text: [1]});
}

/// The centring error and the steps that enter, in one cell.
function scoreCell(tube, mode, report) {
  const index = scoredCase(tube, mode, report.steps);
  if (index === null) return null;
  return el(
      "span", {class: "case"}, `${short(object(tube[mode]).error)}\u00a0\u00a0`, markIcon(stepMark(index, stepCountOf(report), object(report.base))),
      ` ${index}`);
}
