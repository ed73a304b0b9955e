// Small panels of each joint's equivalent error against the joint's angle, direction of motion, moment, and the load.
// Each panel has the p-value of its variable in the pattern search; loudest() returns the most significant panel.
import {binnedMeans} from "./binned.js";
import {jointKey} from "./error_parts.js";
import {followedShare} from "./groups.js";
import {isNumber} from "./numbers.js";
import {partsAlong} from "./reading_errors.js";
import {rangeOf} from "./scales.js";
import {isInShare, MOST_POINTS} from "./shares.js";
import {findVariable, levelOffset} from "./variables.js";

/** @typedef {import("./error_parts.js").Part} Part */
/** @typedef {import("./reading_errors.js").ErrorPair} ErrorPair */
/** @typedef {import("./variables.js").Variable} Variable */
/** @typedef {"angle" | "direction" | "moment" | "load"} ColumnName */
/** `p`: smallest p-value of the variable in the pattern search, null if not tested; `share`: fraction of the variance
 *  of this joint's equivalent error that the variable explains.
 *  @typedef {{joint: string, column: ColumnName, variable: Variable, part: Part, p: number | null,
 *    share: number}} Multiple */
/** `rowOf` returns the name of the row that a joint turns.
 *  @typedef {{errors: ErrorPair, variables: readonly Variable[], parts: readonly Part[],
 *    tested: readonly {variable: string, p_value: number | null}[], rowOf: (joint: string) => string}} MultiplesSource */

/** @type {readonly ColumnName[]} */
export const MULTIPLE_COLUMNS = ["angle", "direction", "moment", "load"];

/** p-value below which a pattern is significant, as in the program's pattern search. */
const FOUND = 0.01;

/** @param {MultiplesSource} source @returns {Multiple[]} */
export function multiplesOf(source) {
  return source.errors.joints.flatMap((joint) => {
    const part = source.parts.find((entry) => entry.key === jointKey(joint));
    if (!part) return [];
    /** @type {Record<ColumnName, string>} */
    const names = {
      angle: joint,
      direction: `sense of ${joint}`,
      moment: `moment ${source.rowOf(joint)}.z`,
      load: "load",
    };
    return MULTIPLE_COLUMNS.flatMap((column) => {
      const variable = findVariable(names[column], source.variables);
      return variable ? [multipleOf(source, {joint, column, variable, part}, names[column])] : [];
    });
  });
}

/**
 * @param {MultiplesSource} source
 * @param {{joint: string, column: ColumnName, variable: Variable, part: Part}} of
 * @param {string} name of the variable, as the search has it @returns {Multiple}
 */
function multipleOf({errors, tested}, of, name) {
  const chances = tested.flatMap((test) => (test.variable === name && test.p_value !== null ? [test.p_value] : []));
  return {
    ...of,
    p: chances.length > 0 ? Math.min(...chances) : null,
    share: followedShare(
      errors.readings.map((reading, i) => of.variable.of(reading, i)),
      partsAlong(errors.series[errors.tested].errors, of.part),
    ),
  };
}

/**
 * Returns the panel with the smallest p-value, or null if no pattern was found. Between equal p-values, such as those
 * of the load, the panel whose variable explains the largest fraction of the joint's error is chosen.
 * @param {readonly Multiple[]} multiples
 */
export function loudest(multiples) {
  /** @type {Multiple | null} */
  let best = null;
  for (const entry of multiples) {
    if (entry.p === null || entry.p >= FOUND) continue;
    const isLouder = best === null || best.p === null || entry.p < best.p;
    if (best === null || isLouder || (entry.p === best.p && entry.share > best.share)) best = entry;
  }
  return best;
}

/**
 * Returns the common scale of all panels: the 97 % quantile of the judged errors' absolute values.
 * @param {readonly Multiple[]} multiples @param {ErrorPair | null} errors
 */
export function multiplesScale(multiples, errors) {
  if (!errors) return 1;
  const sizes = [...new Set(multiples.map((entry) => entry.part))].flatMap((part) =>
    partsAlong(errors.series[errors.judged].errors, part).filter(isNumber).map(Math.abs),
  );
  sizes.sort((a, b) => a - b);
  return sizes[Math.floor(0.97 * (sizes.length - 1))] || 1;
}

/**
 * Returns the positions within a panel of this size [px]: the points of every series, the bin means, and the zero line.
 * @param {Multiple} multiple @param {ErrorPair} errors @param {number} most value at the end of the scale
 * @param {number} width @param {number} height
 */
export function panelPlaces({variable, part}, errors, most, width, height) {
  const xs = errors.readings.map((reading, i) => variable.of(reading, i));
  const values = errors.series.map((series) => partsAlong(series.errors, part));
  const [low, high] = rangeOf(xs.filter(isNumber));
  const inner = width - 16;
  const across = (/** @type {number} */ x) => 8 + (inner * (x - low)) / (high - low || 1);
  const up = (/** @type {number} */ value) =>
    height / 2 - (0.46 * height * Math.max(-1.08, Math.min(1.08, value / most))) / 1.08;
  const points = values.map((column) => {
    /** @type {[number, number][]} */
    const places = [];
    for (let i = 0; i < column.length; ++i) {
      const x = xs[i],
        value = column[i];
      if (!isNumber(x) || !isNumber(value) || !isInShare(i, column.length, MOST_POINTS)) continue;
      // Spread points at a discrete level slightly, so that they do not overlap.
      const offset = variable.kind === "sense" ? levelOffset(i) * 0.2 * inner : 0;
      places.push([across(x) + (x > (low + high) / 2 ? -Math.abs(offset) : Math.abs(offset)), up(value)]);
    }
    return places;
  });
  const means = binnedMeans(xs, values[errors.tested] ?? []).map((bin) => [across(bin.x), up(bin.mean)]);
  return {points, means, zero: up(0)};
}
