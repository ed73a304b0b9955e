// ---- numbers.js: reading values that may be missing, and writing numbers.

const MISSING = "\u2013";

function isNumber(value) { return typeof value === "number" && Number.isFinite(value); }

function isPoint(value) {
  return Array.isArray(value) && value.length >= 2 && isNumber(value[0]) && isNumber(value[1]);
}

function list(value) {
  return Array.isArray(value) ? value.filter((entry) => entry !== null && typeof entry === "object") : [];
}

function points(value) { return Array.isArray(value) ? value.filter(isPoint) : []; }

function numbers(value, count) {
  return Array.isArray(value) && value.length === count && value.every(isNumber) ? value : null;
}

function object(value) { return value !== null && typeof value === "object" && !Array.isArray(value) ? value : null; }

function textOf(value, otherwise = MISSING) {
  return typeof value === "string" && value !== "" ? value : isNumber(value) ? String(value) : otherwise;
}

/// A number with about three figures: 0.0302, 12.4, 4,674, 3.1e-8.
function short(value) {
  if (!isNumber(value)) return MISSING;
  const size = Math.abs(value);
  if (size === 0) return "0";
  if (size < 5e-4) return value.toExponential(1).replace("-", "\u2212").replace("e-", "e\u2212").replace("e+", "e");
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 ? 3 : 4;
  return fixed(value, digits);
}

function fixed(value, digits) {
  if (!isNumber(value)) return MISSING;
  return value.toLocaleString("en", {minimumFractionDigits: digits, maximumFractionDigits: digits})
      .replace("-", "\u2212");
}

/// A given number as it was given, to six figures: 0.089, 20.
function exact(value) {
  return isNumber(value) ? value.toLocaleString("en", {maximumSignificantDigits: 6}).replace("-", "\u2212") : MISSING;
}

function whole(value) { return fixed(value, 0); }

function percent(fraction, digits = 0) {
  return isNumber(fraction) ? `${fixed(100 * fraction, digits)}\u00a0%` : MISSING;
}

/// A probability: certainty is said only where it is certain.
function probability(value) {
  if (!isNumber(value)) return MISSING;
  if (value > 0 && value < 0.001) return "<\u00a00.1\u00a0%";
  if (value < 1 && value > 0.999) return ">\u00a099.9\u00a0%";
  return percent(value, 1);
}

/// 75 s, 12 min 05 s, 1 h 20 min.
function duration(seconds) {
  if (!isNumber(seconds)) return MISSING;
  if (seconds < 120) return `${fixed(seconds, seconds < 10 ? 1 : 0)} s`;
  const total = Math.round(seconds);
  const two = (value) => String(value).padStart(2, "0");
  if (total < 7200) return `${Math.floor(total / 60)} min ${two(total % 60)} s`;
  return `${Math.floor(total / 3600)} h ${two(Math.round((total % 3600) / 60))} min`;
}

function plural(count, one, many = `${one}s`) { return `${whole(count)} ${count === 1 ? one : many}`; }

/// The 1, 2 or 5 times a power of ten at or below a positive value.
function roundDown125(value) {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  const step = [5, 2, 1].find((factor) => factor * power <= value * (1 + 1e-9)) ?? 1;
  return Number((step * power).toPrecision(1));
}

function tubeName(tube) { return `R${textOf(tube.row)}\u00a0C${textOf(tube.column)}`; }

function distance(a, b) { return Math.hypot(a[0] - b[0], a[1] - b[1]); }

function lengthUnit(report) { return textOf(object(report.units)?.length, ""); }

function angleUnit(report) { return textOf(object(report.units)?.angle, "").replace("degree", "deg"); }
