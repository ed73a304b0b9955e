// Error ladder: the fitted and held-out errors of each model, relative to the noise floor.
import {errorText, fixed, isNumber} from "./numbers.js";

/** @typedef {{name: string, fitted: number | null, heldout: number | null}} ComparedModel */

/** Legend of the two kinds of bars and of the line. */
export const LADDER_WORDS = {
  fitted: "fitted: on the readings that the fit used",
  heldout: "held out: on readings that the fit did not use",
  floor: "noise floor: expected from the stated noise alone",
};

/**
 * Shortens file paths to file names without extension; returns them in full if the short names would not be distinct.
 * @param {readonly string[]} names
 */
export function modelNames(names) {
  const brief = names.map((name) => name.replace(/^.*\//, "").replace(/\.yaml\b/, ""));
  return new Set(brief).size === new Set(names).size ? brief : [...names];
}

/** The first model's bar is truncated if its error exceeds the largest other error by more than this factor. */
const MOST_TIMES = 12;

/**
 * Returns the end of the axis: slightly above the largest error, unless the other bars would become too short to read.
 * @param {readonly ComparedModel[]} models @param {number | null} floor
 */
export function axisEnd(models, floor) {
  const errors = models.map((model) => Math.max(model.fitted ?? 0, model.heldout ?? 0));
  const others = Math.max(floor ?? 0, ...errors.slice(1));
  const largest = Math.max(floor ?? 0, ...errors) || 1;
  return errors.length > 1 && others > 0 && largest > MOST_TIMES * others ? 1.7 * others : 1.06 * largest;
}

/** Returns, for example, "1.04 x floor"; empty without a floor. @param {number} value @param {number | null} floor */
export function timesFloor(value, floor) {
  return floor ? `${fixed(value / floor, value / floor < 10 ? 2 : 0)} \u00d7 floor` : "";
}

/** @param {number} floor @param {string} unit */
export function floorText(floor, unit) {
  return `noise floor ${errorText(floor, unit)}`;
}

/**
 * Returns a bar's length as a fraction of the axis, and a flag for bars truncated at the end of the axis.
 * @param {number} value @param {number} end
 */
export function barOf(value, end) {
  return {share: Math.min(1, value / end), isCut: value > end * 1.001};
}

/**
 * Returns the held-out error of a model; null if nothing was fitted, where documents repeat the other error in its place.
 * @template T @param {number | null} fitted @param {T} heldout @returns {T | null}
 */
export function heldOutOf(fitted, heldout) {
  return heldout === fitted ? null : heldout;
}

/**
 * Returns the models of a document's list, whose errors are plain numbers or objects {rms}.
 * @param {readonly any[]} entries @returns {ComparedModel[]}
 */
export function comparedModels(entries) {
  const names = modelNames(entries.map((entry) => String(entry.name ?? entry.model ?? entry.cell ?? "")));
  return entries
    .map((entry, k) => ({
      name: names[k],
      fitted: errorOf(entry.rms),
      heldout: heldOutOf(errorOf(entry.rms), errorOf(entry.heldout_rms ?? entry.heldout)),
    }))
    .filter((model) => model.fitted !== null || model.heldout !== null);
}

/**
 * Returns a root mean square given as a number or as {rms}; null if absent.
 * @param {any} value @returns {number | null}
 */
export function errorOf(value) {
  const bare = value !== null && typeof value === "object" ? value.rms : value;
  return isNumber(bare) ? bare : null;
}
