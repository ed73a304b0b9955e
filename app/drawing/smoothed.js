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
  for (const [x, value] of rows) values.set(x, [...(values.get(x) ?? []), value]);
  return [...values]
    .map(([x, own]) => {
      const mean = own.reduce((sum, value) => sum + value, 0) / own.length;
      return {x, count: own.length, mean, square: own.reduce((sum, value) => sum + (value - mean) ** 2, 0)};
    })
    .sort((a, b) => a.x - b.x);
}

/**
 * Returns the value at `x` of the line through the levels nearby, and the spread of their values about that line.
 * @param {readonly Level[]} levels @param {number} x @param {number} reach standard distance @returns {Bin}
 */
function pointAt(levels, x, reach) {
  const near = levels.map((level) => ({
    ...level,
    x: level.x - x,
    weight: Math.exp(-(((level.x - x) / reach) ** 2) / 2),
  }));
  /** @param {(level: Level) => number} of */
  const sum = (of) => near.reduce((total, level) => total + level.weight * of(level), 0);
  const all = sum(({count}) => count),
    at = sum(({x: dx, count}) => count * dx) / all,
    middle = sum(({mean, count}) => count * mean) / all;
  const along = sum(({x: dx, count}) => count * (dx - at) ** 2);
  const slope = along > 0 ? sum(({x: dx, mean, count}) => count * (dx - at) * (mean - middle)) / along : 0;
  const left = sum(({x: dx, mean, count, square}) => square + count * (mean - middle - slope * (dx - at)) ** 2);
  return {x, from: x, to: x, mean: middle - slope * at, error: 0, spread: Math.sqrt(left / all), count: all};
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
  const gap = Math.max(...levels.slice(1).map((level, k) => level.x - levels[k].x));
  const reach = Math.max(OF_RANGE * range, OF_GAP * gap);
  return Array.from({length: POINTS}, (_, k) => pointAt(levels, low + (range * k) / (POINTS - 1), reach));
}
