// Values along a variable as a smooth curve: at each of many points, a straight line through the values nearby, of which
// near ones count more.

/** @typedef {import("./binned.js").Bin} Bin */
/** Values at one place of the variable: their number, mean and sum of squared deviations from it.
 *  @typedef {{x: number, count: number, mean: number, square: number}} Level */

/** Points of a drawn curve. */
const POINTS = 121;
/** Fewest levels of the variable from which a curve is drawn. */
const FEWEST = 4;
/** Standard distance of values that count at a point: a share of the range, or of the widest gap if that is more. */
const OF_RANGE = 1 / 24;
const OF_GAP = 1 / 2;

/** @param {readonly [number, number][]} rows @returns {Level[]} */
function levelsOf(rows) {
  /** @type {Map<number, number[]>} */
  const values = new Map();
  for (const [x, value] of rows) {
    const own = values.get(x);
    if (own) own.push(value);
    else values.set(x, [value]);
  }
  return [...values]
    .map(([x, own]) => {
      const mean = own.reduce((sum, value) => sum + value, 0) / own.length;
      return {x, count: own.length, mean, square: own.reduce((sum, value) => sum + (value - mean) ** 2, 0)};
    })
    .sort((a, b) => a.x - b.x);
}

/**
 * Returns the line through the levels near `x`: its value at the middle of the weighed levels, the distance `at` of that
 * middle from `x`, and the slope.
 * @param {readonly Level[]} levels @param {Float64Array} weights @param {number} x
 */
function lineAt(levels, weights, x) {
  let all = 0,
    at = 0,
    middle = 0;
  for (let k = 0; k < levels.length; ++k) {
    const weight = weights[k] * levels[k].count;
    all += weight;
    at += weight * (levels[k].x - x);
    middle += weight * levels[k].mean;
  }
  at /= all;
  middle /= all;
  let along = 0,
    rise = 0;
  for (let k = 0; k < levels.length; ++k) {
    const step = levels[k].x - x - at,
      weighed = weights[k] * levels[k].count * step;
    along += weighed * step;
    rise += weighed * (levels[k].mean - middle);
  }
  return {all, at, middle, slope: along > 0 ? rise / along : 0};
}

/**
 * Returns the value at `x` of the line through the levels nearby, and the spread of their values about that line.
 * @param {readonly Level[]} levels @param {Float64Array} weights room for the weights of the levels
 * @param {number} x @param {number} reach standard distance @returns {Bin}
 */
function pointAt(levels, weights, x, reach) {
  for (let k = 0; k < levels.length; ++k) weights[k] = Math.exp(-(((levels[k].x - x) / reach) ** 2) / 2);
  const {all, at, middle, slope} = lineAt(levels, weights, x);
  let left = 0;
  for (let k = 0; k < levels.length; ++k) {
    const {count, mean, square} = levels[k];
    left += weights[k] * (square + count * (mean - middle - slope * (levels[k].x - x - at)) ** 2);
  }
  return {x, from: x, to: x, mean: middle - slope * at, error: 0, spread: Math.sqrt(left / all), count: all};
}

/** Returns the widest distance between neighbouring levels. @param {readonly Level[]} levels */
function widestGap(levels) {
  let widest = 0;
  for (let k = 1; k < levels.length; ++k) widest = Math.max(widest, levels[k].x - levels[k - 1].x);
  return widest;
}

/**
 * Returns the smooth curve of rows [x, value]; null if the variable has too few levels for one.
 * @param {readonly [number, number][]} rows @returns {Bin[] | null}
 */
export function smoothed(rows) {
  const levels = levelsOf(rows);
  if (levels.length < FEWEST) return null;
  const low = levels[0].x,
    range = levels[levels.length - 1].x - low;
  const reach = Math.max(OF_RANGE * range, OF_GAP * widestGap(levels)),
    weights = new Float64Array(levels.length);
  return Array.from({length: POINTS}, (_, k) => pointAt(levels, weights, low + (range * k) / (POINTS - 1), reach));
}
