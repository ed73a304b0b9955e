// Number of tool steps that enter each tube, without compensation and with it. The wording comes from the report.
import {isNumber, probability, short} from "../../../../drawing/numbers.js";
import {stepCountOf, stepsAtError, stepText} from "../../../../drawing/steps.js";
import {visitText} from "../../../../drawing/visits.js";
import {angleUnit, lengthUnit, list, numbers, object, type Report, textOf} from "../values";

export interface Mode {
  key: string;
  name: string;
  brief: string;
  /** Returns the number of steps that enter a tube; null if unknown. */
  caseOf: (tube: Report) => number | null;
}

/** Returns the modes of compensation, in the order of the report. */
export function modesOf(report: Report): Mode[] {
  return list(report.modes).map(({name, words, brief}) => ({
    key: textOf(name),
    name: textOf(words, textOf(name)),
    brief: textOf(brief, textOf(name)),
    caseOf: (tube) => scoredCase(tube, textOf(name), report.steps),
  }));
}

/**
 * Returns the prediction of the plan as a mode: the stated number of steps, else the most probable number, else the
 * number at the predicted error.
 */
export function predictedMode(report: Report): Mode {
  const caseOf = (tube: Report) => {
    if (tube.probability_by_steps === null) return null;
    if (Number.isInteger(tube.steps)) return tube.steps as number;
    const chances = chancesOf(tube, report);
    return chances ? chances.indexOf(Math.max(...chances)) : knownSteps(tube.predicted_error, report.steps);
  };
  return {key: "predicted", name: "as predicted", brief: "predicted", caseOf};
}

/** Returns the modes in which at least one tube is scored. */
export function scoredModes(report: Report): Mode[] {
  return modesOf(report).filter((mode) => list(report.tubes).some((tube) => mode.caseOf(tube) !== null));
}

/**
 * Returns the number of steps that enter at a centring error, from the tolerances of the tool's steps; null if unknown.
 */
function knownSteps(error: unknown, steps: unknown): number | null {
  const tolerances = list(steps).map((step) => step.tolerance);
  if (!isNumber(error) || tolerances.length === 0 || !tolerances.every(isNumber)) return null;
  return stepsAtError(error, tolerances);
}

/** Returns the number of steps that enter a tube with the true arm in one mode; null if the tube was not scored. */
function scoredCase(tube: Report, mode: string, steps: unknown): number | null {
  const score = object(tube[mode]);
  if (!score) return null;
  return Number.isInteger(score.steps) ? Math.max(0, score.steps) : knownSteps(score.error, steps);
}

/** Returns the probabilities that 0, 1, ..., all steps enter a tube; null if the report has none. */
export function chancesOf(tube: Report, report: Report): number[] | null {
  return numbers(tube.probability_by_steps, stepCountOf(report) + 1);
}

/**
 * Returns the number of tubes that 0, 1, ..., all steps enter in one mode: from `counts` in the report, otherwise
 * counted; null if nothing was scored.
 */
export function countsOf(report: Report, mode: string): number[] | null {
  const all = stepCountOf(report),
    given = numbers(object(report.counts)?.[mode], all + 1);
  const cases = list(report.tubes).flatMap((tube) => scoredCase(tube, mode, report.steps) ?? []);
  if (given || cases.length === 0) return given;
  return Array.from({length: all + 1}, (_, steps) => cases.filter((value) => value === steps).length);
}

/**
 * Returns a phrase such as "against the true arm all three steps enter in 41 of 60 tubes with via-point compensation, 0
 * without"; null if unknown.
 */
export function wholeToolText(report: Report): string | null {
  const after = countsOf(report, "via_point"),
    before = countsOf(report, "none");
  if (!after) return null;
  const total = after.reduce((sum, count) => sum + count, 0);
  return (
    `against the true arm ${stepText(report.step_words, stepCountOf(report))} in ${after.at(-1)} of ${total} ` +
    `tubes with via-point compensation${before ? `, ${before.at(-1)} without` : ""}`
  );
}

export interface CentringError {
  tube: Report;
  dx: number;
  dy: number;
  error: number;
}

/** Returns the centring errors of the tubes scored in one mode. */
export function errorsOf(report: Report, mode: string): CentringError[] {
  return list(report.tubes).flatMap((tube) => {
    const {dx, dy, error} = object(tube[mode]) ?? {};
    if (![dx, dy, tube.x, tube.y].every(isNumber)) return [];
    return [{tube, dx, dy, error: isNumber(error) ? error : Math.hypot(dx, dy)}];
  });
}

export function largestError(errors: readonly CentringError[]): number {
  return errors.reduce((most, {dx, dy}) => Math.max(most, Math.hypot(dx, dy)), 0);
}

/** Returns a phrase such as "visit 7 of 60"; the tubes are listed in visiting order. */
export function visitOf(report: Report, tube: Report): string {
  const tubes = list(report.tubes);
  return visitText(tubes.indexOf(tube), tubes.length);
}

/** Returns a function that describes the hole at a row and column for the picture of a mode. */
export function holeDescriber(report: Report, mode: Mode): (row: number, column: number) => string[] {
  const byName = (tubes: Report[]) => new Map(tubes.map((tube) => [`${tube.row} ${tube.column}`, tube]));
  const tubes = byName(list(report.tubes)),
    unreachable = byName(list(report.unreachable));
  return (row, column) => {
    const name = `${row} ${column}`,
      tube = tubes.get(name);
    if (unreachable.has(name)) return [`cannot be visited: ${textOf(unreachable.get(name)!.reason)}`];
    return tube ? tubeLines(tube, mode, report) : ["not on the list"];
  };
}

function tubeLines(tube: Report, mode: Mode, report: Report): string[] {
  const unit = lengthUnit(report),
    score = object(tube[mode.key]),
    steps = mode.caseOf(tube),
    chances = chancesOf(tube, report);
  return [
    visitOf(report, tube),
    score ? `error, ${mode.name}: ${short(score.error)} ${unit} (dx ${short(score.dx)}, dy ${short(score.dy)})` : "",
    steps === null ? "" : `${score ? "tool" : "expected"}: ${stepText(report.step_words, steps)}`,
    isNumber(score?.approach_deviation)
      ? `off the hole's axis on approach: ${short(score.approach_deviation)} ${unit}`
      : "",
    `predicted error: ${short(tube.predicted_error)} ${unit}; tilt ${short(tube.tilt)} ${angleUnit(report)}`,
    chances ? `probability of ${[...chances.keys()].join("/")} steps: ${chances.map(probability).join(" / ")}` : "",
  ].filter((text) => text !== "");
}
