// The ladder of errors: each model's, fitted and held out, over the noise floor.
import {fixed, isNumber, short} from "./numbers.js";

/** @typedef {{name: string, fitted: number | null, heldout: number | null}} ComparedModel */

/** Words for the two kinds of bars and the line. */
export const LADDER_WORDS = {
  fitted: "fitted: on the readings that the fit used",
  heldout: "held out: on readings that the fit did not use",
  floor: "noise floor: expected from the stated noise alone",
};

/**
 * Model names as files are long: their last part tells them apart, else they stay whole.
 * @param {readonly string[]} names
 */
export function modelNames(names) {
  const brief = names.map((name) => name.replace(/^.*\//, "").replace(/\.yaml\b/, ""));
  return new Set(brief).size === new Set(names).size ? brief : [...names];
}

/** The largest error may be so many times the next before its bar is cut. */
const MOST_TIMES = 12;

/**
 * Returns the end of the axis: the largest error, unless that would squeeze the others at the left.
 * @param {readonly ComparedModel[]} models @param {number | null} floor
 */
export function axisEnd(models, floor) {
  const errors = models.map((model) => Math.max(model.fitted ?? 0, model.heldout ?? 0));
  const others = Math.max(floor ?? 0, ...errors.slice(1));
  const largest = Math.max(floor ?? 0, ...errors) || 1;
  return errors.length > 1 && others > 0 && largest > MOST_TIMES * others ? 1.7 * others : 1.06 * largest;
}

/** "1.04 x floor"; empty without a floor. @param {number} value @param {number | null} floor */
export function timesFloor(value, floor) {
  return floor ? `${fixed(value / floor, value / floor < 10 ? 2 : 0)} \u00d7 floor` : "";
}

/** @param {number} floor @param {string} unit */
export function floorText(floor, unit) {
  return `noise floor ${short(floor)} ${unit}`;
}

/** A bar's length as a share of the axis, and whether it is cut there. @param {number} value @param {number} end */
export function barOf(value, end) {
  return {share: Math.min(1, value / end), isCut: value > end * 1.001};
}

/**
 * The models of a list as documents have it: bare errors, or inside {rms}.
 * @param {readonly any[]} entries @returns {ComparedModel[]}
 */
export function comparedModels(entries) {
  const names = modelNames(entries.map((entry) => String(entry.name ?? entry.model ?? entry.cell ?? "")));
  return entries
    .map((entry, k) => ({
      name: names[k],
      fitted: errorOf(entry.rms),
      heldout: errorOf(entry.heldout_rms ?? entry.heldout),
    }))
    .filter((model) => model.fitted !== null || model.heldout !== null);
}

/** A root mean square, given bare or inside {rms}. @param {any} value @returns {number | null} */
export function errorOf(value) {
  const bare = value !== null && typeof value === "object" ? value.rms : value;
  return isNumber(bare) ? bare : null;
}
