// View of a cause: the variable of its law, and the part of the error that shows it. Of the variables that the law
// may depend on, it is the one that the effect at these readings follows most.
import {jointKey} from "./error_parts.js";
import {followedShare} from "./groups.js";

/** @typedef {import("./error_parts.js").Part} Part */
/** @typedef {import("./error_parts.js").Vector3} Vector3 */
/** @typedef {import("./variables.js").Variable} Variable */
/** @typedef {import("./variables.js").VariedReading} VariedReading */
/** @typedef {{effect: string, at: string, varies_with?: readonly string[]}} Cause */
/** `score`: the share of what the cause does there that follows the variable.
 *  @typedef {{variable: Variable, part: Part, score?: number}} View */

/**
 * Returns the view of the cause that shows best: an earlier one unless another is clearly better.
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

/** The joint or axis that an effect turns: "theta3" of "theta3<-theta2", "forearm.z". @param {{at: string}} effect */
export function turnedBy({at}) {
  return at.split("<-")[0];
}

/**
 * Moments at the effect's own place: about its axis, "forearm.z", or any of its member's, "forearm".
 * @param {Cause} cause @param {readonly Variable[]} variables
 */
function ownMoments({at}, variables) {
  const key = `moment_${at.replace(/\W/g, "_")}`;
  return variables.filter((variable) => variable.key === key || new RegExp(`^${key}_[xyz]$`).test(variable.key));
}

/** A user's own law stands in the place of its place: "theta2 += c*sin(theta1)". @param {Cause} cause */
function isLaw({at}) {
  return at.includes("+=");
}

/**
 * The variables that a cause's law may hang on, the named ones of a formula or a coupling first.
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

/** The mean square of the values that are there. @param {readonly (number | null)[]} values */
function meanSquare(values) {
  const known = values.flatMap((value) => (value === null ? [] : [value]));
  return known.length > 0 ? known.reduce((sum, value) => sum + value * value, 0) / known.length : 0;
}

/** A view must be better by so much to be taken instead of an earlier one. */
const CLEARLY = 0.02;

/**
 * Returns the best view of a cause; `done` is its part of the error at each reading. It is the error of the joint or
 * axis that the cause turns, if it turns one; else the part along the axis that has most of it and follows its variable.
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
    const share = own ? 1 : meanSquare(values) / (whole || 1);
    for (const [k, variable] of tried.entries()) {
      const score = share * followedShare(columns[k], values);
      if (!best || score > best.score + CLEARLY) best = {variable, part, score};
    }
  }
  return best;
}
