// How far the tool goes into each tube, without compensation and with it. Words come with the report.
import {STEP_MARKS, stepMarksOf} from "../drawing/kinds.js";
import {isNumber} from "../drawing/numbers.js";
import {stepsAtError, stepText} from "../drawing/visits.js";
import {list, numbers, object, textOf} from "./values.js";

/// The marks of 0 to 3 steps with their words.
export function stepKinds(report) {
  return stepMarksOf(object(report.base)).map((mark, steps) => ({...mark, name: stepText(report.step_words, steps)}));
}

/// The modes of compensation, in the order of the thesis's comparison: [{key, name, brief}].
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
  return Math.min(STEP_MARKS.length - 1, stepsAtError(error, tolerances));
}

/// A tube's number of steps in one mode against the true arm; null when it was not scored.
export function scoredCase(tube, mode, steps) {
  const score = object(tube[mode]);
  if (!score) return null;
  const most = STEP_MARKS.length - 1;
  return Number.isInteger(score.steps) ? Math.max(0, Math.min(most, score.steps)) : knownSteps(score.error, steps);
}

/// The number that the plan expects: the likeliest by its probabilities, else by the predicted error; null where the
/// plan says that it has none, since nobody placed the base.
export function predictedCase(tube, steps) {
  if (tube.probability_by_steps === null) return null;
  const chances = numbers(tube.probability_by_steps, STEP_MARKS.length);
  return chances ? chances.indexOf(Math.max(...chances)) : knownSteps(tube.predicted_error, steps);
}

/// Tubes by number of steps in one mode: from `counts` when given, else counted; null when nothing was scored.
export function countsOf(report, mode) {
  const given = numbers(object(report.counts)?.[mode], STEP_MARKS.length);
  if (given) return given;
  const cases =
      list(report.tubes).map((tube) => scoredCase(tube, mode, report.steps)).filter((value) => value !== null);
  return cases.length === 0 ? null : STEP_MARKS.map((_, index) => cases.filter((value) => value === index).length);
}
