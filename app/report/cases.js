// How far the tool goes into each tube, without compensation and with it. Words come with the report.
import {isNumber} from "../drawing/numbers.js";
import {stepCountOf, stepsAtError, stepText} from "../drawing/steps.js";
import {list, numbers, object, textOf} from "./values.js";

/// The modes of compensation, in the order of the report: [{key, name, brief}].
export function modesOf(report) {
  return list(report.modes).map((mode) => ({
                                  key: textOf(mode.name),
                                  name: textOf(mode.words, textOf(mode.name)),
                                  brief: textOf(mode.brief, textOf(mode.name))
                                }));
}

export function modeName(report, key) { return modesOf(report).find((mode) => mode.key === key)?.name ?? key; }

/// The number of steps that enter at a centring error, by the tool's tolerances; null when it is not known.
function knownSteps(error, steps) {
  const tolerances = list(steps).map((step) => step.tolerance);
  if (!isNumber(error) || tolerances.length === 0 || !tolerances.every(isNumber)) return null;
  return stepsAtError(error, tolerances);
}

/// A tube's number of steps in one mode against the true arm; null when it was not scored.
export function scoredCase(tube, mode, steps) {
  const score = object(tube[mode]);
  if (!score) return null;
  return Number.isInteger(score.steps) ? Math.max(0, score.steps) : knownSteps(score.error, steps);
}

/// The probabilities of 0, 1, ..., all steps at a tube; null where the report has none.
export function chancesOf(tube, report) { return numbers(tube.probability_by_steps, stepCountOf(report) + 1); }

/// The number that the plan expects: its own, else the likeliest by its probabilities, else by the predicted error; null
/// where the plan says that it has none, since nobody placed the base.
export function predictedCase(tube, report) {
  if (tube.probability_by_steps === null) return null;
  if (Number.isInteger(tube.steps)) return tube.steps;
  const chances = chancesOf(tube, report);
  return chances ? chances.indexOf(Math.max(...chances)) : knownSteps(tube.predicted_error, report.steps);
}

/// Tubes by number of steps in one mode: from `counts` when given, else counted; null when nothing was scored.
export function countsOf(report, mode) {
  const all = stepCountOf(report), given = numbers(object(report.counts)?.[mode], all + 1);
  if (given) return given;
  const cases =
      list(report.tubes).map((tube) => scoredCase(tube, mode, report.steps)).filter((value) => value !== null);
  if (cases.length === 0) return null;
  return Array.from({length: all + 1}, (_, index) => cases.filter((value) => value === index).length);
}

/// "against the true arm all three steps enter in 41 of 60 tubes with via-point compensation, 0 without"; null when
/// nothing was scored.
export function wholeToolText(report) {
  const after = countsOf(report, "via_point"), before = countsOf(report, "none");
  if (!after) return null;
  const total = after.reduce((sum, count) => sum + count, 0);
  return `against the true arm ${stepText(report.step_words, stepCountOf(report))} in ${after.at(-1)} of ${total} ` +
      `tubes with via-point compensation${before ? `, ${before.at(-1)} without` : ""}`;
}
