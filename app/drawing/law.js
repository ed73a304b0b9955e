// The law of a cause along a variable, as a curve: a straight line or a wave where one describes the contributions of
// the cause as well as their means in bins do, else a smooth curve through them.
import {lawAlong} from "./binned.js";
import {followedShare, knownPairs} from "./groups.js";
import {smoothed} from "./smoothed.js";

/** @typedef {import("./binned.js").Bin} Bin */
/** @typedef {(x: number) => number[]} Terms Values of the terms of a law at x, the first of them 1. */

/** Loss of the adjusted share of the variance up to which a simple law is preferred to the bins. */
const LOSS = 0.02;
/** Points of a drawn wave. */
const POINTS = 73;

/** @type {Terms} */
const LINE = (x) => [1, x];

/** @param {string} unit @param {number} times waves in a turn @returns {Terms} */
function waveIn(unit, times) {
  const factor = times * (unit === "deg" ? Math.PI / 180 : 1);
  return (x) => [1, Math.sin(factor * x), Math.cos(factor * x)];
}

/**
 * Returns the law of a cause along a variable as consecutive points, or bins where the variable has few levels. `unit`: unit of the variable if it is an angle that a
 * wave may follow, else empty.
 * @param {readonly (number | undefined)[]} xs @param {readonly (number | null)[]} done @param {string} unit
 * @returns {Bin[]}
 */
export function lawCurve(xs, done, unit) {
  const rows = knownPairs(xs, done);
  const least = followedShare(xs, done) - LOSS;
  const levels = new Set(rows.map(([x]) => x)).size;
  const tried = [LINE, ...(unit === "deg" || unit === "rad" ? [waveIn(unit, 1), waveIn(unit, 2)] : [])];
  for (const [k, terms] of tried.entries()) {
    const law = levels > 3 ? fitted(rows, terms) : null;
    if (law && law.share >= Math.max(least, 0)) return drawn(rows, terms, law, k === 0 ? 2 : POINTS);
  }
  return smoothed(rows) ?? lawAlong(xs, done);
}

/**
 * Returns the least-squares fit of the terms, with the adjusted share of the variance that it explains; null if it is
 * not determined.
 * @param {readonly [number, number][]} rows @param {Terms} terms
 */
function fitted(rows, terms) {
  const count = terms(0).length;
  if (rows.length <= count + 1) return null;
  /** @type {number[][]} */
  const sums = Array.from({length: count}, () => new Array(count + 1).fill(0));
  for (const [x, value] of rows) {
    const own = terms(x);
    for (let i = 0; i < count; ++i) {
      for (let j = 0; j < count; ++j) sums[i][j] += own[i] * own[j];
      sums[i][count] += own[i] * value;
    }
  }
  const factors = solved(sums);
  if (!factors) return null;
  const mean = rows.reduce((sum, row) => sum + row[1], 0) / rows.length;
  const all = rows.reduce((sum, row) => sum + (row[1] - mean) ** 2, 0);
  const left = rows.reduce((sum, [x, value]) => sum + (value - valueOf(factors, terms(x))) ** 2, 0);
  const free = rows.length - count;
  return all > 0 ? {factors, spread: Math.sqrt(left / free), share: 1 - left / free / (all / (rows.length - 1))} : null;
}

/** @param {readonly number[]} factors @param {readonly number[]} terms */
function valueOf(factors, terms) {
  return factors.reduce((sum, factor, k) => sum + factor * terms[k], 0);
}

/**
 * Returns the solution of linear equations, given as rows of coefficients and the right-hand side; null if they are
 * singular.
 * @param {number[][]} rows
 */
function solved(rows) {
  const count = rows.length;
  for (let k = 0; k < count; ++k) {
    const best = rows.slice(k).reduce((at, row, i) => (Math.abs(row[k]) > Math.abs(rows[at][k]) ? k + i : at), k);
    [rows[k], rows[best]] = [rows[best], rows[k]];
    if (Math.abs(rows[k][k]) < 1e-12 * (1 + Math.abs(rows[k][count]))) return null;
    for (let i = 0; i < count; ++i) {
      if (i === k) continue;
      const share = rows[i][k] / rows[k][k];
      for (let j = k; j <= count; ++j) rows[i][j] -= share * rows[k][j];
    }
  }
  return rows.map((row, k) => row[count] / row[k]);
}

/**
 * @param {readonly [number, number][]} rows @param {Terms} terms @param {{factors: number[], spread: number}} law
 * @param {number} points @returns {Bin[]}
 */
function drawn(rows, terms, {factors, spread}, points) {
  const [low, high] = rows.reduce(
    ([least, most], [x]) => [Math.min(least, x), Math.max(most, x)],
    [Infinity, -Infinity],
  );
  return Array.from({length: points}, (_, k) => {
    const x = low + ((high - low) * k) / (points - 1);
    return {x, from: x, to: x, mean: valueOf(factors, terms(x)), error: 0, spread, count: rows.length};
  });
}
