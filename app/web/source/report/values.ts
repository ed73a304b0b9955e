// Functions that read a report's document, any part of which may be missing.
import {isNumber, MISSING, plainUnit, short} from "../../../drawing/numbers.js";
import {tubeTitle} from "../../../drawing/sheet_model.js";

/** Document in the report file; any part may be missing or of an unexpected type. */
export type Report = Record<string, any>;

export function list(value: unknown): Report[] {
  return Array.isArray(value) ? value.filter((entry) => entry !== null && typeof entry === "object") : [];
}

export function textList(value: unknown): string[] {
  return Array.isArray(value) ? value.map((text) => textOf(text, "")).filter((text) => text) : [];
}

export function numbers(value: unknown, count: number): number[] | null {
  return Array.isArray(value) && value.length === count && value.every(isNumber) ? value : null;
}

export function vector(value: unknown): [number, number, number] | null {
  return numbers(value, 3) as [number, number, number] | null;
}

export function isPoint(value: unknown): value is [number, number] {
  return Array.isArray(value) && value.length >= 2 && isNumber(value[0]) && isNumber(value[1]);
}

export function points(value: unknown): [number, number][] {
  return Array.isArray(value) ? value.filter(isPoint) : [];
}

export function object(value: unknown): Report | null {
  return value !== null && typeof value === "object" && !Array.isArray(value) ? value : null;
}

export function textOf(value: unknown, otherwise = MISSING): string {
  return typeof value === "string" && value !== "" ? value : isNumber(value) ? String(value) : otherwise;
}

export function tubeName(tube: Report): string {
  return tubeTitle(textOf(tube.row), textOf(tube.column));
}

export function lengthUnit(report: Report): string {
  return textOf(object(report.units)?.length, "");
}

export function angleUnit(report: Report): string {
  return plainUnit(textOf(object(report.units)?.angle, ""));
}

export function lengthText(value: unknown, report: Report): string {
  return `${short(value)}\u00a0${lengthUnit(report)}`;
}
