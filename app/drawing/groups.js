// Readings grouped along a variable, by level or in bins, and the fraction of the values' variance that the variable
// explains.

const BINS = 12;

/**
 * Groups rows [x, value] by level (distinct value) of x if there are at most `bins` levels, else in bins of about
 * equally many rows. Rows of one level are never split between bins.
 * @param {readonly [number, number][]} rows
 */
export function groupsOf(rows, bins = BINS) {
  const sorted = [...rows].sort((a, b) => a[0] - b[0]);
  const levels = new Set(sorted.map((row) => row[0])).size;
  const most = levels <= bins ? 1 : Math.ceil(sorted.length / Math.min(bins, Math.max(2, sorted.length / 3)));
  /** @type {[number, number][][]} */
  const groups = [];
  for (const row of sorted) {
    const last = groups[groups.length - 1];
    const isSameLevel = last !== undefined && last[last.length - 1][0] === row[0];
    if (last && (isSameLevel || (levels > bins && last.length < most))) last.push(row);
    else groups.push([row]);
  }
  return groups;
}

/**
 * Returns the pairs [x, value] in which both entries are known.
 * @param {readonly (number | undefined)[]} xs @param {readonly (number | null)[]} values
 * @returns {[number, number][]}
 */
export function knownPairs(xs, values) {
  return xs.flatMap((x, i) => {
    const value = values[i];
    const isKnown = x !== undefined && Number.isFinite(x) && value !== null && Number.isFinite(value);
    return isKnown ? [/** @type {[number, number]} */ ([x, value])] : [];
  });
}

/**
 * Returns the fraction of the values' variance explained by x, adjusted for degrees of freedom: 1 minus the variance
 * within groups of x over the total variance.
 * @param {readonly (number | undefined)[]} xs @param {readonly (number | null)[]} values
 */
export function followedShare(xs, values) {
  const rows = knownPairs(xs, values);
  if (rows.length < 3) return 0;
  const mean = rows.reduce((sum, row) => sum + row[1], 0) / rows.length;
  const all = rows.reduce((sum, row) => sum + (row[1] - mean) ** 2, 0);
  if (!(all > 0)) return 0;
  const groups = groupsOf(rows);
  const within = groups.reduce((sum, group) => {
    const own = group.reduce((total, row) => total + row[1], 0) / group.length;
    return sum + group.reduce((total, row) => total + (row[1] - own) ** 2, 0);
  }, 0);
  const free = rows.length - groups.length;
  return free > 0 ? 1 - within / free / (all / (rows.length - 1)) : 0;
}
