// Text on the visits of a plan and on its required clearance.
import {exact} from "./numbers.js";

/** @param {number} index from 0 @param {number} count */
export function visitText(index, count) {
  return `visit ${index + 1} of ${count}`;
}

/** @param {number} clearance @param {string} unit */
export function requiredText(clearance, unit) {
  return `required ${exact(clearance)} ${unit}`;
}
