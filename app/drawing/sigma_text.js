// A value beside its sigma: with as many digits as that warrants, sigma with two.
import {fixed, isNumber, MISSING, short, unitText} from "./numbers.js";

/**
 * 0.1101 +- 0.0007 deg, (9.93 +- 0.07)e6 lbf/in^2.
 * @param {unknown} value @param {unknown} sigma @param {unknown} [unit]
 */
export function withSigma(value, sigma, unit) {
  if (!isNumber(value) || !isNumber(sigma) || sigma <= 0) return `${short(value)}${unitText(unit)}`;
  const {value: shown, sigma: about, power} = pairOf(value, sigma);
  const pair = `${shown} \u00b1 ${about}`;
  return `${power === "" ? pair : `(${pair})${power}`}${unitText(unit)}`;
}

/** The two by themselves, for a table. @param {unknown} value @param {unknown} sigma @returns {[string, string]} */
export function valueAndSigma(value, sigma) {
  if (!isNumber(value) || !isNumber(sigma) || sigma <= 0) return [short(value), MISSING];
  const {value: shown, sigma: about, power} = pairOf(value, sigma);
  return [shown + power, about + power];
}

// Figures beyond these are written with a power of ten.
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

/** From so many sigmas on an error is marked: of a few touches, and of readings, of which there may be thousands. */
export const TOUCH_SIGMAS = 3;
export const READING_SIGMAS = 5;

/** The sign before a figure that is marked: the colour alone says it to few. */
export const MARKED = "\u25b2 ";

/**
 * Returns an error in sigmas, marked if it is above the limit.
 * @param {unknown} times @param {number} limit
 */
export function sigmasText(times, limit) {
  if (!isNumber(times)) return {text: MISSING, isMany: false};
  const isMany = times > limit;
  return {text: `${isMany ? MARKED : ""}${fixed(times, 1)}`, isMany};
}
