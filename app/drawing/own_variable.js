// View of a cause: a variable of its law, and the component of the error that shows the law best. The view uses the
// variable that explains the largest fraction of the cause's contribution to the errors of the readings.
import {jointKey} from "./error_parts.js";
import {followedShare} from "./groups.js";

/** @typedef {import("./error_parts.js").Part} Part */
/** @typedef {import("./error_parts.js").Vector3} Vector3 */
/** @typedef {import("./variables.js").Variable} Variable */
/** @typedef {import("./variables.js").VariedReading} VariedReading */
/** @typedef {{effect: string, at: string, varies_with?: readonly string[]}} Cause */
/** `score`: fraction of the cause's contribution to the error that the variable explains in this component.
 *  @typedef {{variable: Variable, part: Part, score?: number}} View */

/**
 * Returns the view with the highest score among the causes, or null without causes. A later cause replaces an earlier
 * cause only with a clearly higher score. `done`: contribution of all causes to the error at each reading.
 * @param {readonly Cause[]} causes @param {readonly (Vector3 | null)[]} done @param {readonly VariedReading[]} readings
 * @param {readonly Variable[]} variables @param {readonly Part[]} parts @returns {View | null}
 */
export function viewOfCauses(causes, done, readings, variables, parts) {
  /** @type {View | null} */
  let best = null;
  for (const cause of causes) {
    const view = viewOfCause(cause, done, readings, variables, parts);
    if (view && (!best || (view.score ?? 0) > (best.score ?? 0) + CLEARLY)) best = view;
  }
  return best;
}

/**
 * Returns the joint or axis that the effect displaces: "theta3" for "theta3<-theta2", "forearm.z" for "forearm.z".
 * @param {{at: string}} effect
 */
export function turnedBy({at}) {
  return at.split("<-")[0];
}

/**
 * Returns the moments at the effect's location: about an axis such as "forearm.z", or about all axes of a link such as
 * "forearm".
 * @param {Cause} cause @param {readonly Variable[]} variables
 */
function ownMoments({at}, variables) {
  const key = `moment_${at.replace(/\W/g, "_")}`;
  return variables.filter((variable) => variable.key === key || new RegExp(`^${key}_[xyz]$`).test(variable.key));
}

/** Returns true if `at` holds a user-defined law, such as "theta2 += c*sin(theta1)". @param {Cause} cause */
function isLaw({at}) {
  return at.includes("+=");
}

/**
 * Returns the variables that a cause's law may depend on: those named in a formula or a coupling, else the variables of
 * the kinds in `varies_with`.
 * @param {Cause} cause @param {readonly Variable[]} variables @returns {readonly Variable[]}
 */
function variablesOfLaw(cause, variables) {
  const driver = cause.at.split("<-")[1];
  if (driver) return variables.filter((variable) => variable.key === driver);
  if (isLaw(cause)) {
    const words = new Set(/** @type {string[]} */ (cause.at.match(/[A-Za-z_]\w*/g) ?? []));
    return variables.filter((variable) => words.has(variable.key));
  }
  const kinds = cause.varies_with ?? [];
  const own = variables.find((variable) => variable.key === cause.at);
  if (own && kinds.includes(own.kind)) return [own];
  const moments = kinds[0] === "moment" ? ownMoments(cause, variables) : [];
  if (moments.length > 0) return moments;
  return kinds.flatMap((kind) => variables.filter((variable) => variable.kind === kind));
}

/** Returns the mean square of the known values; 0 if none is known. @param {readonly (number | null)[]} values */
function meanSquare(values) {
  const known = values.flatMap((value) => (value === null ? [] : [value]));
  return known.length > 0 ? known.reduce((sum, value) => sum + value * value, 0) / known.length : 0;
}

/** Smallest gain in score for which a view replaces an earlier view. */
const CLEARLY = 0.02;

/**
 * Returns the best view of a cause, where `done` is the cause's contribution to the error at each reading. If the cause
 * turns a joint or axis, the view shows that joint's equivalent error. Otherwise, it shows the component with the
 * highest score: its fraction of the contribution's mean square, as displacements of the tip, times the fraction that
 * the variable explains.
 * @param {Cause} cause @param {readonly (Vector3 | null)[]} done @param {readonly VariedReading[]} readings
 * @param {readonly Variable[]} variables @param {readonly Part[]} parts @returns {View | null}
 */
export function viewOfCause(cause, done, readings, variables, parts) {
  const named = variablesOfLaw(cause, variables);
  const tried = named.length > 0 ? named : variables.filter((variable) => variable.kind !== "order");
  const own = parts.find((part) => part.key === jointKey(turnedBy(cause)));
  const shown = own ? [own] : parts.filter((part) => part.isSigned && !part.key.startsWith("as "));
  const whole = meanSquare(done.map((error) => (error ? Math.hypot(...error) : null)));
  const columns = tried.map((variable) => readings.map((reading, i) => variable.of(reading, i)));
  /** @type {(View & {score: number}) | null} */
  let best = null;
  for (const part of shown) {
    const values = done.map((error, i) => (error ? part.of(error, i) : null));
    const moved = values.map((value, i) => (value === null ? null : value * (part.lever?.(i) ?? 1)));
    const share = meanSquare(moved) / (whole || 1);
    for (const [k, variable] of tried.entries()) {
      const score = share * followedShare(columns[k], values);
      if (!best || score > best.score + CLEARLY) best = {variable, part, score};
    }
  }
  return best;
}
