// Reading values that may be missing.
import {isNumber, MISSING, plainUnit, short} from "../drawing/numbers.js";
import {tubeTitle} from "../drawing/sheet_model.js";

export function isPoint(value) {
  return Array.isArray(value) && value.length >= 2 && isNumber(value[0]) && isNumber(value[1]);
}

export function list(value) {
  return Array.isArray(value) ? value.filter((entry) => entry !== null && typeof entry === "object") : [];
}

export function textList(value) {
  return Array.isArray(value) ? value.map((text) => textOf(text, "")).filter((text) => text) : [];
}

export function points(value) { return Array.isArray(value) ? value.filter(isPoint) : []; }

export function numbers(value, count) {
  return Array.isArray(value) && value.length === count && value.every(isNumber) ? value : null;
}

export function object(value) {
  return value !== null && typeof value === "object" && !Array.isArray(value) ? value : null;
}

export function textOf(value, otherwise = MISSING) {
  return typeof value === "string" && value !== "" ? value : isNumber(value) ? String(value) : otherwise;
}

export function tubeName(tube) { return tubeTitle(textOf(tube.row), textOf(tube.column)); }

export function lengthUnit(report) { return textOf(object(report.units)?.length, ""); }

export function angleUnit(report) { return plainUnit(textOf(object(report.units)?.angle, "")); }

export function lengthText(value, report) { return `${short(value)}\u00a0${lengthUnit(report)}`; }
