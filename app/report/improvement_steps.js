// How a model was improved: of each step the verdict, what was added and why, and the errors with the law of it.
import {verdictMark} from "../drawing/kinds.js";

import {el, notRecorded} from "./elements.js";
import {errorLawSection} from "./error_law.js";
import {markIcon} from "./mark_drawing.js";
import {list, object, textList, textOf} from "./values.js";

export function improvementStepsSection(report) {
  const steps = list(report.steps);
  if (steps.length === 0) return [notRecorded("The steps")];
  return steps.map((step, index) => stepCard(report, step, index));
}

function stepCard(report, step, index) {
  const added = textList(step.added), also = textList(step.also), figures = object(step.figures);
  const verdict = textOf(figures?.verdict_words, textOf(step.verdict));
  const reason = textOf(step.reason, "");
  const done = added.length > 0 ? `Added: ${added.join(", ")}` : "Nothing was added";
  return el(
      "div", {class: "improvement-step"},
      el("h3", {}, markIcon(verdictMark(step.verdict), 16), ` Step ${index + 1}: ${verdict}`),
      el("p", {}, textOf(step.sentence, "")), el("p", {}, el("b", {}, done), reason === "" ? "." : `: ${reason}.`),
      also.length === 0 ? null : el("p", {class: "note"}, `The same all over the arm's range: ${also.join(", ")}.`),
      figures && list(figures.readings).length > 0 ?
          errorLawSection({...figures, units: report.units, page: "diagnosis"}) :
          null);
}
