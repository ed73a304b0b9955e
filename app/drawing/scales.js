// Round lengths and ticks of axes.

/** Returns the largest 1, 2 or 5 times a power of ten not above a positive value. @param {number} value */
export function roundDown125(value) {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  const step = [5, 2, 1].find((factor) => factor * power <= value * (1 + 1e-9)) ?? 1;
  return Number((step * power).toPrecision(1));
}

/** Returns the smallest 1, 2 or 5 times a power of ten not below a positive value. @param {number} value */
export function roundUp125(value) {
  const below = roundDown125(value);
  if (below >= value * (1 - 1e-9)) return below;
  const isTwo = String(below.toExponential()).startsWith("2");
  return Number(((isTwo ? 2.5 : 2) * below).toPrecision(1));
}

/**
 * Returns about `count` round values between `low` and `high`, evenly spaced.
 * @param {number} low @param {number} high @param {number} count
 */
export function roundTicks(low, high, count) {
  if (!(high > low)) return [low];
  const step = roundUp125((high - low) / (Math.max(1, count) + 0.5));
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    ticks.push(Number((k * step).toPrecision(12)));
  return ticks;
}

const ROOT_VALUES = [0, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

/**
 * Returns the ticks of a square-root axis from 0 to `high`, which shows small clearances enlarged.
 * @param {number} high
 */
export function rootTicks(high) {
  /** @type {number[]} */
  const kept = [];
  for (const value of ROOT_VALUES) {
    if (value > high) break;
    if (kept.length === 0 || Math.sqrt(value / high) - Math.sqrt(kept[kept.length - 1] / high) > 0.09) kept.push(value);
  }
  return kept.length > 2 ? kept : roundTicks(0, high, 4);
}

/**
 * Returns an interval extended by 4 % at both ends.
 * @param {number} low @param {number} high @returns {[number, number]}
 */
export function widened(low, high) {
  const more = 0.04 * (high - low || 1);
  return [low - more, high + more];
}

/**
 * Returns an interval symmetric about zero that contains `low` and `high` with a margin of 8 %.
 * @param {number} low @param {number} high @returns {[number, number]}
 */
export function symmetric(low, high) {
  const most = 1.08 * Math.max(Math.abs(low), Math.abs(high)) || 1;
  return [-most, most];
}

/** @param {Iterable<number>} values any number @returns {[number, number]} minimum and maximum */
export function rangeOf(values) {
  let low = Infinity,
    high = -Infinity;
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return [low, high];
}
