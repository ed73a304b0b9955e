// Number formatting with typographic minus signs and about three significant digits. All files of this folder are ASCII
// only, because reports embed them unchanged.

export const MISSING = "\u2013";

/** @type {(value: unknown) => value is number} */
export function isNumber(value) {
  return typeof value === "number" && Number.isFinite(value);
}

/** @param {unknown} value @param {number} digits */
export function fixed(value, digits) {
  if (!isNumber(value)) return MISSING;
  const text = value.toLocaleString("en", {minimumFractionDigits: digits, maximumFractionDigits: digits});
  return /[1-9]/.test(text) ? text.replace("-", "\u2212") : text.replace("-", "");
}

/** Returns a number to about three significant digits: 0.0302, 12.4, 4,674, 3.1e-8. @param {unknown} value */
export function short(value) {
  if (!isNumber(value)) return MISSING;
  const size = Math.abs(value);
  if (size === 0) return "0";
  if (size < 5e-4 || size >= 1e6)
    return value
      .toExponential(size < 1 ? 1 : 2)
      .replaceAll("-", "\u2212")
      .replace("e+", "e");
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 ? 3 : 4;
  return fixed(value, digits);
}

/** Returns a number to at most six significant digits: 0.089, 20. @param {unknown} value */
export function exact(value) {
  return isNumber(value) ? value.toLocaleString("en", {maximumSignificantDigits: 6}).replace("-", "\u2212") : MISSING;
}

/**
 * Returns the tick labels of one axis, all with as many decimals as the tick spacing needs: 0.05, 0.10.
 * @param {readonly number[]} values @returns {string[]}
 */
export function tickTexts(values) {
  const steps = values.slice(1).map((value, k) => Math.abs(value - values[k]));
  const step = Math.min(...steps.filter((size) => size > 0));
  const most = Math.max(...values.map(Math.abs));
  if (!isNumber(step) || most >= 1e6 || most < 5e-4) return values.map(short);
  const digits =
    [0, 1, 2, 3, 4, 5, 6, 7].find((n) => Math.abs(step * 10 ** n - Math.round(step * 10 ** n)) < 1e-6) ?? 7;
  return values.map((value) => (Math.abs(value) < 1e-9 * most ? "0" : fixed(value, digits)));
}

/** @param {unknown} value */
export function whole(value) {
  return fixed(value, 0);
}

/** @param {unknown} fraction */
export function percent(fraction, digits = 0) {
  return isNumber(fraction) ? `${fixed(100 * fraction, digits)}\u00a0%` : MISSING;
}

/** Returns a probability in percent; 0 % and 100 % appear only if exact, else "< 0.1 %" and "> 99.9 %".
 *  @param {unknown} value */
export function probability(value) {
  if (!isNumber(value)) return MISSING;
  if (value > 0 && value < 0.001) return "<\u00a00.1\u00a0%";
  if (value < 1 && value > 0.999) return ">\u00a099.9\u00a0%";
  return percent(value, 1);
}

/** Returns a p-value for a table: 0.032, 6e-173. @param {unknown} p */
export function pValue(p) {
  if (!isNumber(p)) return MISSING;
  if (p < 1e-300) return "<\u00a01e\u2212300";
  return p < 0.001 ? p.toExponential(0).replace("e-", "e\u2212") : fixed(p, p < 0.095 ? 3 : 2);
}

/** Returns a p-value for a sentence: p = 0.032, or "not tested". @param {unknown} p */
export function chance(p) {
  if (!isNumber(p)) return "not tested";
  const text = pValue(p);
  return text.startsWith("<") ? `p ${text}` : `p = ${text}`;
}

/** Returns a duration, such as 75 s, 12 min 05 s or 1 h 20 min. @param {unknown} seconds */
export function duration(seconds) {
  if (!isNumber(seconds)) return MISSING;
  if (seconds < 120) return `${fixed(seconds, seconds < 10 ? 1 : 0)} s`;
  const minutes = Math.floor(Math.round(seconds) / 60);
  if (minutes < 120) return `${minutes} min ${twoDigits(Math.round(seconds) % 60)} s`;
  const all = Math.round(seconds / 60);
  return `${Math.floor(all / 60)} h ${twoDigits(all % 60)} min`;
}

/** @param {number} value */
function twoDigits(value) {
  return String(value).padStart(2, "0");
}

/** Returns a time as minutes and seconds of fixed width: 03:07.5. @param {number} seconds */
export function clock(seconds) {
  const minutes = Math.floor(seconds / 60);
  return `${twoDigits(minutes)}:${(seconds - 60 * minutes).toFixed(1).padStart(4, "0")}`;
}

/** @param {unknown} count @param {string} one */
export function plural(count, one, many = `${one}s`) {
  return `${whole(count)} ${count === 1 ? one : many}`;
}

/** Returns a unit with a leading space, to follow a number; empty if dimensionless. @param {unknown} unit */
export function unitText(unit) {
  return typeof unit !== "string" || unit === "" || unit === "1" ? "" : `\u00a0${plainUnit(unit)}`;
}

const POWERS = {"^2": "\u00b2", "^3": "\u00b3", "^4": "\u2074"};

/** Returns a unit as engineering drawings write it: deg/(lbf\u00b7in) for deg/(lbf*in). @param {string} unit */
export function plainUnit(unit) {
  return unit
    .replace("degree", "deg")
    .replace(/\^[234]/g, (power) => POWERS[/** @type {keyof typeof POWERS} */ (power)])
    .replaceAll("*", "\u00b7");
}

/** Returns the unit of a quantity's inverse: lbf\u00b7in/deg for deg/(lbf*in). @param {string} unit */
export function inverseUnit(unit) {
  const [over, under = "1"] = unit.replace(/[()]/g, "").split("/");
  return plainUnit(`${under}${over === "1" ? "" : `/${over}`}`);
}

/** Number of additional decimals for lengths in each unit, relative to inches. @type {Record<string, number>} */
const DECIMALS = {in: 0, mm: -1, cm: 0, m: 2, ft: 1};

/**
 * Returns a length with the given number of decimals in inches, or equivalent precision in another unit.
 * @param {unknown} value @param {string} unit of `value`
 */
export function lengthFigure(value, unit, decimals = 3) {
  return fixed(value, Math.max(0, decimals + (DECIMALS[unit] ?? 0)));
}

/** Smaller units of lengths, and how many of them make the larger one. @type {Record<string, [string, number]>} */
const SMALLER = {m: ["mm", 1000], ft: ["in", 12]};
const SMALL = 0.1; // length below which the smaller unit is chosen
const LEAST_PLAIN = 1e-6; // least value written without a power of ten

/**
 * Returns an error with its unit, without a power of ten where possible: 0.0302 in, 0.17 mm (for 0.00017 m).
 * @param {unknown} value @param {string} unit
 */
export function errorText(value, unit) {
  if (!isNumber(value)) return MISSING;
  const [name, times] = (value !== 0 && Math.abs(value) < SMALL && SMALLER[unit]) || [unit, 1];
  const size = times * value,
    text = short(size);
  const isPlain = !text.includes("e") || Math.abs(size) < LEAST_PLAIN || Math.abs(size) >= 1;
  return `${isPlain ? text : Number(size.toPrecision(2)).toString().replace("-", "\u2212")} ${name}`;
}

/** @param {unknown} value @param {string} unit */
export function lengthAndUnit(value, unit, decimals = 3) {
  return isNumber(value) ? `${lengthFigure(value, unit, decimals)} ${unit}` : MISSING;
}

/** Returns the number of decimals of a joint's encoder reading in this unit. @param {string} unit */
export function jointDecimals(unit) {
  return unit === "deg" || unit === "" ? 2 : unit === "rad" ? 4 : 3 + (DECIMALS[unit] ?? 0);
}
