// Errors of the readings in two series, before and after a change, for the plots of the page and the reports.
import {AS_IT_STANDS, isEnough, REFITTED, withIt, WITHOUT_IT} from "./explanations.js";
import {AFTER, BEFORE} from "./kinds.js";
import {binnedMeans, lawAlong} from "./binned.js";
import {findPart, jointKey} from "./error_parts.js";
import {followedShare} from "./groups.js";
import {lawCurve} from "./law.js";
import {viewOfCauses} from "./own_variable.js";
import {symmetric} from "./scales.js";
import {findVariable, levelOffset} from "./variables.js";

/** @typedef {import("./error_parts.js").Part} Part */
/** @typedef {import("./error_parts.js").Vector3} Vector3 */
/** @typedef {import("./kinds.js").Mark} Mark */
/** @typedef {import("./own_variable.js").Cause} Cause */
/** @typedef {import("./own_variable.js").View} View */
/** @typedef {import("./variables.js").Variable} Variable */
/** @typedef {import("./variables.js").VariedReading} VariedReading */
/** @typedef {{name: string, mark: Mark, errors: (Vector3 | null)[]}} ErrorSeries */
/**
 * `series`: errors before, then after the change; only one entry if there is no change. `judged`: index of the series
 * from which means and explained fractions are computed: before for a diagnosis, after for a refit. `tested`: index of
 * the series that the pattern search tested. `causes`: causes added by the change; empty for a refit.
 * @template {VariedReading} [R=VariedReading]
 * @typedef {{readings: R[], places: (Vector3 | null)[], series: ErrorSeries[], joints: string[], judged: number,
 *    tested: number, causes: Cause[]}} ErrorPair
 */

/**
 * Returns the errors of the model refitted without and with the explanation `index` of a diagnosis.
 * @template {VariedReading & {before: Vector3, explained: (Vector3 | null)[], position: Vector3 | null}} R
 * @param {{readings: R[], joints: {name: string}[],
 *   explanations: {effects: Cause[], enough?: boolean}[]}} document
 * @param {number} index @returns {ErrorPair<R>}
 */
export function errorsOfExplanation({readings, joints, explanations}, index) {
  const explanation = explanations[index];
  /** @type {ErrorSeries[]} */
  const series = [
    {name: `before: ${WITHOUT_IT}`, mark: BEFORE, errors: readings.map((reading) => reading.before)},
    ...(explanation
      ? [
          {
            name: `after: ${withIt(explanation)}`,
            mark: AFTER,
            errors: readings.map((reading) => reading.explained[index] ?? null),
          },
        ]
      : []),
  ];
  return {
    readings,
    places: readings.map((reading) => reading.position),
    series,
    joints: joints.map((joint) => joint.name),
    judged: 0,
    tested: 0,
    causes: explanation && isEnough(explanation) ? explanation.effects : [],
  };
}

/**
 * Returns the errors (measured minus predicted) of a comparison, before and after the refit.
 * @template {VariedReading} R
 * @param {R[]} readings @param {(Vector3 | null)[]} places @param {string[]} joints
 * @param {(Vector3 | null)[]} before @param {(Vector3 | null)[]} after @param {string} when suffix of both series'
 * names
 * @returns {ErrorPair<R>}
 */
export function errorsOfRefit(readings, places, joints, before, after, when = "") {
  return {
    readings,
    places,
    series: [
      {name: `before: ${AS_IT_STANDS}${when}`, mark: BEFORE, errors: before},
      {name: `after: ${REFITTED}${when}`, mark: AFTER, errors: after},
    ],
    joints,
    judged: 1,
    tested: 1,
    causes: [],
  };
}

/**
 * Returns the error before minus the error after the change at each reading; null where either is missing.
 * @param {ErrorPair} pair @returns {(Vector3 | null)[]}
 */
export function doneBy({series: [before, after]}) {
  return before.errors.map((from, i) => {
    const to = after?.errors[i];
    return from && to ? [from[0] - to[0], from[1] - to[1], from[2] - to[2]] : null;
  });
}

/** @param {readonly (Vector3 | null)[]} errors @param {Part} part */
export function partsAlong(errors, part) {
  return errors.map((error, i) => (error ? part.of(error, i) : null));
}

// ---- choice of the view

/** @param {ErrorPair} pair @param {readonly Variable[]} variables @param {readonly Part[]} parts */
export function viewOfPair(pair, variables, parts) {
  return pair.causes.length === 0 ? null : viewOfCauses(pair.causes, doneBy(pair), pair.readings, variables, parts);
}

/**
 * Returns the component of the judged errors that a variable explains best (by fraction of variance).
 * @param {Variable} variable @param {ErrorPair} pair @param {readonly Part[]} parts
 */
export function partFollowing(variable, pair, parts) {
  const xs = pair.readings.map((reading, i) => variable.of(reading, i));
  let best = parts[0],
    most = 0;
  for (const part of parts) {
    const share = part.isSigned ? followedShare(xs, partsAlong(pair.series[pair.judged].errors, part)) : 0;
    if (share > most + 0.02) [best, most] = [part, share];
  }
  return best;
}

/**
 * Returns the view of the unexplained residual against the variable that explains most of it; null if there is none.
 * @param {{remainder?: {follows?: {variable: string}[]} | null} | null | undefined} diagnosis
 * @param {ErrorPair} pair @param {readonly Variable[]} variables @param {readonly Part[]} parts
 * @returns {View | null}
 */
export function viewOfRemainder(diagnosis, pair, variables, parts) {
  const variable = findVariable(diagnosis?.remainder?.follows?.[0]?.variable, variables);
  return variable ? {variable, part: partFollowing(variable, pair, parts)} : null;
}

/**
 * Returns the view of the first pattern found; null if there is none. Patterns over the touched point come last,
 * because a point is a label, not a quantity.
 * @param {readonly {variable: string, frame?: string, component?: string}[]} patterns
 * @param {readonly Variable[]} variables @param {readonly Part[]} parts @returns {View | null}
 */
export function viewOfPatterns(patterns, variables, parts) {
  const found = patterns.flatMap(({variable: name, frame, component}) => {
    const variable = findVariable(name, variables);
    return variable ? [{variable, part: findPart(frame, component, parts) ?? parts[0]}] : [];
  });
  return found.find((view) => view.variable.kind !== "point") ?? found[0] ?? null;
}

// ---- content of a plot

/**
 * Returns the data of a view: the variable at each reading, the component in each series, the bin means of the judged
 * series, and the binned contribution of the causes. The last two are empty for an unsigned component.
 * @param {ErrorPair} pair @param {View} view
 */
export function plotted(pair, {variable, part}) {
  const isLevel = variable.kind === "sense" || variable.levels !== undefined;
  const xs = pair.readings.map((reading, index) => variable.of(reading, index));
  const values = pair.series.map((series) => partsAlong(series.errors, part));
  const hasLaw = part.isSigned && pair.causes.length > 0;
  return {
    isLevel,
    xs,
    values,
    means: part.isSigned ? binnedMeans(xs, values[pair.judged]) : [],
    law: hasLaw ? lawOf(pair, variable, part, isLevel, xs) : [],
  };
}

/**
 * @param {ErrorPair} pair @param {Variable} variable @param {Part} part @param {boolean} isLevel
 * @param {readonly (number | undefined)[]} xs
 */
function lawOf(pair, variable, part, isLevel, xs) {
  const done = partsAlong(doneBy(pair), part);
  return isLevel ? lawAlong(xs, done) : lawCurve(xs, done, variable.kind === "joint" ? variable.unit : "");
}

/**
 * Returns the plotted position of a value. At a discrete level, points are spread slightly, so that all are visible.
 * @param {boolean} isLevel @param {number} value @param {number} index
 */
export function spreadAtLevel(isLevel, value, index) {
  return isLevel ? value + 0.5 * levelOffset(index) : value;
}

/** @param {Variable} variable */
export function levelTicks({levels}) {
  return levels ? levels.map((_, k) => k) : [-1, 0, 1];
}

/** @param {Variable} variable @returns {[number, number]} */
export function levelRange({levels}) {
  return levels ? [-0.5, levels.length - 0.5] : [-1.3, 1.3];
}

/**
 * Returns the largest absolute error in several plots, as their common scale; null if they show different components.
 * @param {[ErrorPair, View][]} plots
 */
export function commonMost(...plots) {
  if (new Set(plots.map(([, {part}]) => part.key)).size > 1) return null;
  let most = 0;
  for (const [pair, {part}] of plots)
    for (const series of pair.series)
      for (const value of partsAlong(series.errors, part)) most = Math.max(most, Math.abs(value ?? 0));
  return most;
}

/**
 * Returns the axis range of a component: symmetric about zero if signed, else from zero. `most`: largest value of a
 * common scale, or null if the axis has its own scale.
 * @param {Part} part @param {number} low @param {number} high @param {number | null} most @returns {[number, number]}
 */
export function partRange({isSigned}, low, high, most) {
  return isSigned ? symmetric(most === null ? low : -most, most ?? high) : [0, 1.08 * (most ?? high) || 1];
}

/** Returns the letter that names an explanation: "A" for index 0. @param {number} index */
export function letterOf(index) {
  return String.fromCharCode(65 + index);
}

/** Returns the components that are equivalent joint errors. @param {ErrorPair} pair @param {readonly Part[]} parts */
export function jointParts({joints}, parts) {
  return parts.filter((part) => joints.some((name) => part.key === jointKey(name)));
}
