// The readings of a report about errors, and the pairs of error series, before and after.
import {conditionsOf} from "../../../../drawing/conditions.js";
import {partsOf} from "../../../../drawing/error_parts.js";
import {explanationsOf, isEnough} from "../../../../drawing/explanations.js";
import {isNumber} from "../../../../drawing/numbers.js";
import type {View} from "../../../../drawing/own_variable.js";
import {
  errorsOfExplanation,
  errorsOfRefit,
  type ErrorPair,
  viewOfPair,
  viewOfPatterns,
  viewOfRemainder,
} from "../../../../drawing/reading_errors.js";
import {variablesOf} from "../../../../drawing/variables.js";
import type {Explanation} from "../../server/documents";
import {angleUnit, list, object, type Report, textOf, vector} from "../values";

const MOST_SIDE_BY_SIDE = 4;

/** Returns the report's explanations with their effects as objects, best first. */
export function reportExplanations(report: Report): (Pick<Explanation, "effects"> & Partial<Explanation>)[] {
  return explanationsOf({
    explanations: list(report.explanations).map((entry) => ({...entry, effects: list(entry.effects)})),
    alternatives: (Array.isArray(report.alternatives) ? report.alternatives : []).filter(Array.isArray).map(list),
  } as Parameters<typeof explanationsOf>[0]) as Explanation[];
}

interface ErrorsOfReport {
  /**
   * Errors before and after: for a diagnosis with each remaining explanation, best first; for a comparison with its
   * refit.
   */
  pairs: ErrorPair[];
  /** Variables against which the errors can be plotted, and parts of the errors. */
  axes: ReturnType<typeof errorAxesOf>;
}

const known = new WeakMap<Report, ErrorsOfReport>();

/** Returns the errors of a report, computed once for all sections. */
export function errorsOf(report: Report): ErrorsOfReport {
  const made = known.get(report);
  if (made) return made;
  const pairs = errorPairsOf(report),
    errors = {pairs, axes: errorAxesOf(report, pairs[0])};
  known.set(report, errors);
  return errors;
}

function errorPairsOf(report: Report): ErrorPair[] {
  const readings = list(report.readings).filter((reading) => vector(reading.before)) as any[];
  const joints = list(report.joints) as {name: string}[];
  if (report.page !== "diagnosis") {
    const names = joints.map(({name}) => name),
      places = readings.map((reading) => vector(reading.position));
    const after = readings.map((reading) => vector(reading.after));
    const before = readings.map((reading) => reading.before);
    return [errorsOfRefit(readings, places, names, before, after)];
  }
  const explanations = reportExplanations(report);
  const whole = readings.map((reading) => ({
    ...reading,
    explained: reading.explained ?? [],
    position: vector(reading.position),
  }));
  const count = report.verdict === "ambiguous" ? Math.min(MOST_SIDE_BY_SIDE, explanations.filter(isEnough).length) : 1;
  return Array.from({length: Math.max(1, count)}, (_, index) =>
    errorsOfExplanation({readings: whole, joints, explanations}, index),
  );
}

function errorAxesOf(report: Report, {readings, places}: ErrorPair) {
  const unit = (object(report.units) ?? {}) as any,
    joints = list(report.joints) as {name: string}[];
  return {
    variables: variablesOf({readings, joints, places}, unit, object(report.moments) as any),
    parts: partsOf({ids: readings.map(({id}) => id), places, unit, leverage: object(report.leverage) as any}),
  };
}

/**
 * Returns the view of the error plot for an explanation's law. For an unexplained error, returns the view of the
 * variable that the residual follows, else of the pattern found; null if there is none.
 */
export function lawViewOf(report: Report, pair: ErrorPair, axes: ReturnType<typeof errorAxesOf>): View | null {
  const {variables, parts} = axes;
  return (
    viewOfPair(pair, variables, parts) ??
    viewOfRemainder(report, pair, variables, parts) ??
    viewOfPatterns(foundPatterns(report) as any, variables, parts)
  );
}

/** Returns the findings of the pattern search, most significant first. */
function foundPatterns(report: Report): Report[] {
  const findings = list(report.tested).filter(({finding}) => finding === true);
  return list(report.patterns).length > 0 ? list(report.patterns) : findings.sort((a, b) => a.p_value - b.p_value);
}

export function sizeOf(error: unknown): number | null {
  const known = vector(error);
  return known ? Math.hypot(...known) : null;
}

export function rootMeanSquare(values: readonly unknown[]): number | null {
  const known = values.filter(isNumber);
  return known.length === 0 ? null : Math.sqrt(known.reduce((sum, value) => sum + value * value, 0) / known.length);
}

export function readingName(reading: Report | undefined): string {
  return `reading ${textOf(reading?.id)}`;
}

/** Returns a description such as "theta1 −53.1, theta2 75.7; load 20 lbf". */
export function conditionsText(report: Report, reading: Report): string {
  const joints = jointNames(report, reading),
    rows = conditionsOf(reading, joints, object(report.units) ?? {});
  const ofJoints = rows.slice(0, joints.length).map(({name, figure, sense}) => `${name} ${figure}${sense}`);
  const others = rows.slice(joints.length).map(({name, figure, unit}) => `${name}\u00a0${figure}\u00a0${unit}`);
  return [ofJoints.join(", "), ...others].filter((text) => text).join("; ");
}

/** Returns the names of the joints; numbers if the report does not contain names. */
function jointNames(report: Report, reading: Report) {
  const given = list(report.joints);
  return (Array.isArray(reading.joints) ? reading.joints : []).map((_: unknown, i: number) => ({
    name: textOf(given[i]?.name, `joint ${i + 1}`),
    unit: textOf(given[i]?.unit, angleUnit(report)),
  }));
}
