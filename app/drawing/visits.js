// Visits of a plan in words, and what it keeps clear.
import {exact, plural} from "./numbers.js";

/** @param {number} index from 0 @param {number} count */
export function visitText(index, count) {
  return `visit ${index + 1} of ${count}`;
}

/** @param {number} clearance @param {string} unit */
export function requiredText(clearance, unit) {
  return `required ${exact(clearance)} ${unit}`;
}

/** How far the tool goes in, in the plan's own words where it has some. @param {unknown} words @param {number} steps */
export function stepText(words, steps) {
  const own = Array.isArray(words) ? words[steps] : undefined;
  return typeof own === "string" && own !== "" ? own : plural(steps, "step");
}

/**
 * The number of steps of the tool that enter at a centring error, by the tolerances of all of them.
 * @param {number} error @param {readonly number[]} tolerances
 */
export function stepsAtError(error, tolerances) {
  const first = tolerances.findIndex((tolerance) => error > tolerance);
  return first < 0 ? tolerances.length : first;
}
