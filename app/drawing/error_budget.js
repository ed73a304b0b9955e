// Errors in a result document: their unit, their budget, and the readings set aside.
import {plainUnit, plural, whole} from "./numbers.js";

/** Root mean squares, whose signed squares add up: total = explained + remainder + noise; `words` states them as text.
 *  @typedef {{of: string, unit: string, total: number, explained: number, remainder: number, noise: number,
 *    readings: number, set_aside: number, words: string}} ErrorBudget */
/** @typedef {{error_unit?: unknown, units?: any, error_budget?: any, set_aside?: unknown}} JudgedDocument */

/**
 * Returns the unit of a document's errors: a length, or an angle if the readings measure angles only.
 * @param {JudgedDocument} document
 */
export function errorUnit({error_unit: own, units}) {
  return plainUnit(typeof own === "string" && own !== "" ? own : String(units?.length ?? ""));
}

/** Returns the text of a document's error budget; empty if the document has none. @param {JudgedDocument} document */
export function budgetText({error_budget: budget}) {
  return typeof budget?.words === "string" ? budget.words : "";
}

/** Returns the ids of the readings excluded from all results. @param {JudgedDocument} document @returns {string[]} */
export function idsSetAside({set_aside: ids}) {
  return Array.isArray(ids) ? ids.map(String) : [];
}

/**
 * Returns, for example, "32 of 468 readings set aside as outliers"; empty if no reading was set aside.
 * @param {JudgedDocument} document @param {number} readings total number
 */
export function setAsideText(document, readings) {
  const count = idsSetAside(document).length;
  return count === 0 ? "" : `${whole(count)} of ${plural(readings, "reading")} set aside as outliers`;
}
