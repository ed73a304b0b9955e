// Histograms: values counted in bins of equal, round width that several series share.
import {isNumber} from "./numbers.js";
import {roundUp125} from "./scales.js";

/** Approximate number of bins. */
const BINS = 24;

/**
 * Returns the left edges of the bins, from the multiple of the width below the smallest value, and the counts of each
 * series. Values that are not finite numbers are not counted. Without values there are no bins.
 * @param {readonly (readonly unknown[])[]} series @returns {{width: number, edges: number[], counts: number[][]}}
 */
export function histogramOf(series) {
  const known = series.map((values) => values.filter(isNumber));
  const all = known.flat();
  if (all.length === 0) return {width: 0, edges: [], counts: series.map(() => [])};
  const low = all.reduce((least, value) => Math.min(least, value), Infinity),
    high = all.reduce((most, value) => Math.max(most, value), -Infinity);
  const width = roundUp125((high - low || Math.abs(high) || 1) / BINS);
  const first = Math.floor(low / width);
  const count = Math.floor(high / width) - first + 1;
  const edges = Array.from({length: count}, (_, k) => Number(((first + k) * width).toPrecision(12)));
  const counts = known.map((values) => {
    const bins = new Array(count).fill(0);
    for (const value of values) ++bins[Math.max(0, Math.min(count - 1, Math.floor(value / width) - first))];
    return bins;
  });
  return {width, edges, counts};
}

/**
 * Returns the number of shares, which are from 0 to 1, in each of `bins` equal intervals; 1 belongs to the last one.
 * @param {readonly number[]} shares @param {number} bins @returns {number[]}
 */
export function shareCounts(shares, bins) {
  const counts = new Array(bins).fill(0);
  for (const share of shares) ++counts[Math.min(bins - 1, Math.floor(share * bins + 1e-9))];
  return counts;
}
