// The readings' errors in two series, before and after: what the plots of page and reports are made of.
import {AS_IT_STANDS, isEnough, REFITTED, withIt, WITHOUT_IT} from "./explanations.js";
import {AFTER, BEFORE} from "./kinds.js";
import {binnedMeans, lawAlong} from "./binned.js";
import {findPart, jointKey} from "./error_parts.js";
import {followedShare} from "./groups.js";
import {viewOfCauses} from "./own_variable.js";
import {symmetric} from "./scales.js";
import {besideLevel, findVariable} from "./variables.js";

/** @typedef {import("./error_parts.js").Part} Part */
/** @typedef {import("./error_parts.js").Vector3} Vector3 */
/** @typedef {import("./kinds.js").Mark} Mark */
/** @typedef {import("./own_variable.js").Cause} Cause */
/** @typedef {import("./own_variable.js").View} View */
/** @typedef {import("./variables.js").Variable} Variable */
/** @typedef {import("./variables.js").VariedReading} VariedReading */
/** @typedef {{name: string, mark: Mark, errors: (Vector3 | null)[]}} ErrorSeries */
/**
 * `series`: before, then after; one alone where there is no after. `judged`: the series that means and shares are about,
 * what the causes take away from; of a refit, what it leaves. `tested`: the series that the pattern search's tests are
 * about. `causes`: what is between before and after, first the one that is looked at; none for a mere refit.
 * @template {VariedReading} [R=VariedReading]
 * @typedef {{readings: R[], places: (Vector3 | null)[], series: ErrorSeries[], joints: string[], judged: number,
 *    tested: number, causes: Cause[]}} ErrorPair
 */

/**
 * Returns the errors of a diagnosis: of the model without one of its explanations, and with it.
 * @template {VariedReading & {before: Vector3, explained: (Vector3 | null)[], position: Vector3 | null}} R
 * @param {{readings: R[], joints: {name: string}[],
 *    explanations: {effects: Cause[], enough?: boolean}[]}} document
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
 * Returns the errors of a comparison, measured minus predicted: of the model as given, and refitted.
 * @template {VariedReading} R
 * @param {R[]} readings @param {(Vector3 | null)[]} places @param {string[]} joints
 * @param {(Vector3 | null)[]} before @param {(Vector3 | null)[]} after @param {string} when after the names
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

/** Returns the error that causes remove at each reading. @param {ErrorPair} pair @returns {(Vector3 | null)[]} */
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

// ---- where to look

/** @param {ErrorPair} pair @param {readonly Variable[]} variables @param {readonly Part[]} parts */
export function viewOfPair(pair, variables, parts) {
  return pair.causes.length === 0 ? null : viewOfCauses(pair.causes, doneBy(pair), pair.readings, variables, parts);
}

/**
 * The part of the judged errors that follows a variable most.
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
 * Returns the view of the unexplained remainder: the variable that it follows most.
 * @param {{remainder?: {follows?: {variable: string}[]} | null} | null | undefined} diagnosis
 * @param {ErrorPair} pair @param {readonly Variable[]} variables @param {readonly Part[]} parts
 * @returns {View | null}
 */
export function viewOfRemainder(diagnosis, pair, variables, parts) {
  const variable = findVariable(diagnosis?.remainder?.follows?.[0]?.variable, variables);
  return variable ? {variable, part: partFollowing(variable, pair, parts)} : null;
}

/**
 * Returns the view of a found pattern. A point is a name, not a measure, so that other findings come first.
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

// ---- what a plot shows

/**
 * A view's figures: each reading's variable, the series' parts, means of bins of the judged series, and the law of the
 * causes as what they do; the last two of signed parts alone.
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
    law: hasLaw ? lawAlong(xs, partsAlong(doneBy(pair), part)) : [],
  };
}

/**
 * Points of one level are spread a little, so that all of them are seen.
 * @param {boolean} isLevel @param {number} value @param {number} index
 */
export function spreadAtLevel(isLevel, value, index) {
  return isLevel ? value + 0.5 * besideLevel(index) : value;
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
 * The largest error of several plots, where all are drawn as the same part: one scale. Null where they are not.
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
 * The scale of errors of one part: about zero where it has a sign, else from zero; to `most` where that is shared.
 * @param {Part} part @param {number} low @param {number} high @param {number | null} most @returns {[number, number]}
 */
export function partRange({isSigned}, low, high, most) {
  return isSigned ? symmetric(most === null ? low : -most, most ?? high) : [0, 1.08 * (most ?? high) || 1];
}

/** "A", "B", ... as explanations are called. @param {number} index */
export function letterOf(index) {
  return String.fromCharCode(65 + index);
}

/** The parts that are errors of a joint. @param {ErrorPair} pair @param {readonly Part[]} parts */
export function jointParts({joints}, parts) {
  return parts.filter((part) => joints.some((name) => part.key === jointKey(name)));
}
