// A value with its sigma, where sigma has two significant digits and the value as many decimals as sigma.
import {fixed, isNumber, MISSING, short, unitText} from "./numbers.js";

/**
 * Returns, for example, "0.11010 +- 0.00070 deg" or "(9.930 +- 0.070)e6 lbf/in^2"; the value alone if sigma is unknown.
 * @param {unknown} value @param {unknown} sigma @param {unknown} [unit]
 */
export function withSigma(value, sigma, unit) {
  if (!isNumber(value) || !isNumber(sigma) || sigma <= 0) return `${short(value)}${unitText(unit)}`;
  const {value: shown, sigma: about, power} = pairOf(value, sigma);
  const pair = `${shown} \u00b1 ${about}`;
  return `${power === "" ? pair : `(${pair})${power}`}${unitText(unit)}`;
}

/**
 * Returns value and sigma as separate strings, for a table.
 * @param {unknown} value @param {unknown} sigma @returns {[string, string]}
 */
export function valueAndSigma(value, sigma) {
  if (!isNumber(value) || !isNumber(sigma) || sigma <= 0) return [short(value), MISSING];
  const {value: shown, sigma: about, power} = pairOf(value, sigma);
  return [shown + power, about + power];
}

// Numbers outside this range are written with a power of ten.
const LARGEST_PLAIN = 1e5;
const SMALLEST_PLAIN = 1e-3;

/** @param {number} value @param {number} sigma */
function pairOf(value, sigma) {
  const size = Math.max(Math.abs(value), sigma);
  const exponent = size >= LARGEST_PLAIN || size < SMALLEST_PLAIN ? Math.floor(Math.log10(size) + 1e-12) : 0;
  const scale = 10 ** exponent;
  const order = Math.floor(Math.log10(sigma / scale));
  const digits = Math.max(0, Math.min(9, 1 - order));
  const step = 10 ** Math.max(0, order - 1);
  const written = (/** @type {number} */ number) =>
    step > 1 ? fixed(Math.round(number / scale / step) * step, digits) : fixed(number / scale, digits);
  return {
    value: written(value),
    sigma: written(sigma),
    power: exponent === 0 ? "" : `e${String(exponent).replace("-", "\u2212")}`,
  };
}

/**
 * Number of sigmas above which the error of a touch is marked. The limit for readings is higher, because there may be
 * thousands.
 */
export const TOUCH_SIGMAS = 3;
export const READING_SIGMAS = 5;

/** Sign before a marked number, for readers who cannot see the colour. */
export const MARKED = "\u25b2 ";

/**
 * Returns an error in sigmas as text, and whether it exceeds the limit and is marked.
 * @param {unknown} times @param {number} limit
 */
export function sigmasText(times, limit) {
  if (!isNumber(times)) return {text: MISSING, isMany: false};
  const isMany = times > limit;
  return {text: `${isMany ? MARKED : ""}${fixed(times, 1)}`, isMany};
}
