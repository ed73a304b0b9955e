// Residuals binned along a variable: bin means with standard errors, and, for the law of a cause, the mean and standard
// deviation of its contribution in each bin.
import {groupsOf, knownPairs} from "./groups.js";

/** `error`: standard error of the mean; `spread`: standard deviation of the values in the bin.
 *  @typedef {{x: number, from: number, to: number, mean: number, error: number, spread: number, count: number}} Bin */

const MEANS = 10;
const MOST_LAW_STEPS = 40;
/** Number of readings in each bin of a law, enough to average out the influence of other variables. */
const OF_A_STEP = 6;

/** @param {[number, number][]} group @returns {Bin} */
function binOf(group) {
  const count = group.length;
  const mean = group.reduce((sum, [, value]) => sum + value, 0) / count;
  const square = group.reduce((sum, [, value]) => sum + (value - mean) ** 2, 0);
  const spread = count > 1 ? Math.sqrt(square / (count - 1)) : 0;
  return {
    x: group.reduce((sum, [x]) => sum + x, 0) / count,
    from: group[0][0],
    to: group[count - 1][0],
    mean,
    error: spread / Math.sqrt(count),
    spread,
    count,
  };
}

/**
 * Returns the bin means of the values along `xs`, without bins of a single reading, whose scatter is unknown.
 * @param {readonly (number | undefined)[]} xs @param {readonly (number | null)[]} values
 */
export function binnedMeans(xs, values) {
  return groupsOf(knownPairs(xs, values), MEANS)
    .map(binOf)
    .filter((bin) => bin.count > 1);
}

/**
 * Returns the law of a cause along `xs` as bins of its contributions `done` to the error.
 * @param {readonly (number | undefined)[]} xs @param {readonly (number | null)[]} done
 */
export function lawAlong(xs, done) {
  const rows = knownPairs(xs, done);
  return groupsOf(rows, Math.min(MOST_LAW_STEPS, Math.max(MEANS, Math.ceil(rows.length / OF_A_STEP)))).map(binOf);
}
