// Conditions of a reading, and proposed readings, as text and numbers.
import {exact, fixed, isNumber, jointDecimals, probability, short} from "./numbers.js";

/**
 * @typedef {{joints?: readonly number[], senses?: readonly number[] | null, load?: number | null,
 *    force?: readonly number[]}} Conditions
 */
/** @typedef {{name: string, unit?: string}} JointName */

/** Returns an arrow for the sign of a joint's last motion; empty if unknown or 0. @param {unknown} sense */
export function senseArrow(sense) {
  return !isNumber(sense) || sense === 0 ? "" : sense > 0 ? "\u2191" : "\u2193";
}

/**
 * Returns the joints, load and force of a reading, each with name, value and unit. A joint also has the direction of its
 * last motion.
 * @param {Conditions} reading @param {readonly JointName[]} joints @param {{force?: string}} units
 */
export function conditionsOf(reading, joints, units) {
  const rows = joints.map(({name, unit = ""}, k) => ({
    name,
    figure: fixed(reading.joints?.[k], jointDecimals(unit)),
    unit,
    sense: senseArrow(reading.senses?.[k]),
  }));
  const force = units.force ?? "";
  if (isNumber(reading.load)) rows.push({name: "load", figure: exact(reading.load), unit: force, sense: ""});
  if (reading.force) rows.push({name: "force", figure: reading.force.map(exact).join("  "), unit: force, sense: ""});
  return rows;
}

/**
 * Returns the proposed readings, each with the separation of explanations that it achieves [sigmas] and `share`, that
 * separation relative to the largest.
 * @template {{separation_sigmas?: number | null}} T @param {readonly T[]} readings
 */
export function separations(readings) {
  const most = readings.reduce((largest, {separation_sigmas: sigmas}) => Math.max(largest, sigmas ?? 0), 1e-12);
  return readings.map((reading) => ({
    reading,
    share: Math.max(0, reading.separation_sigmas ?? 0) / most,
    text: short(reading.separation_sigmas),
  }));
}

/** Headings of the table of explanation pairs that further readings would distinguish. */
export const PAIR_HEADS = ["if it is", "rather than", "BIC apart now", "expected then", "chance to be named"];

/**
 * Returns one row of the table of explanation pairs, in the order of PAIR_HEADS.
 * @param {{if_true?: unknown, against?: unknown, criterion_gap_now?: unknown, criterion_gap_expected?: unknown,
 *    probability_distinguished?: unknown}} pair
 */
export function pairCells(pair) {
  return [
    String(pair.if_true ?? ""),
    String(pair.against ?? ""),
    short(pair.criterion_gap_now),
    short(pair.criterion_gap_expected),
    probability(pair.probability_distinguished),
  ];
}
