// The one error of a document: its unit, what it divides into, and the readings that are not in it.
import {plainUnit, plural, whole} from "./numbers.js";

/** `total` in squares is explained and remainder and noise; `words` say so.
 *  @typedef {{of: string, unit: string, total: number, explained: number, remainder: number, noise: number,
 *    readings: number, set_aside: number, words: string}} ErrorBudget */
/** @typedef {{error_unit?: unknown, units?: any, error_budget?: any, set_aside?: unknown}} JudgedDocument */

/** The unit of a document's errors: an angle's where the readings measure nothing else. @param {JudgedDocument} document */
export function errorUnit({error_unit: own, units}) {
  return plainUnit(typeof own === "string" && own !== "" ? own : String(units?.length ?? ""));
}

/** Returns the document's words on the error and its parts; empty if it has none. @param {JudgedDocument} document */
export function budgetText({error_budget: budget}) {
  return typeof budget?.words === "string" ? budget.words : "";
}

/** Ids of the readings that are in no figure of the document. @param {JudgedDocument} document @returns {string[]} */
export function idsSetAside({set_aside: ids}) {
  return Array.isArray(ids) ? ids.map(String) : [];
}

/** "32 of 468 readings set aside as outliers"; empty of none. @param {JudgedDocument} document @param {number} readings */
export function setAsideText(document, readings) {
  const count = idsSetAside(document).length;
  return count === 0 ? "" : `${whole(count)} of ${plural(readings, "reading")} set aside as outliers`;
}
