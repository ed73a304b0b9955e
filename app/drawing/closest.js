// Closest explanations of an error that no known effect accounts for: their order, and the one that is worth a trial.
import {FREED} from "./explanations.js";
import {isNumber} from "./numbers.js";

/** @typedef {{effect: string, at: string, parameters?: object}} SizedEffect */
/** @typedef {{effects: SizedEffect[], heldout_rms?: number | null}} Closest */

/** Size below which an effect does not differ from zero [standard deviations]. */
const SIGMAS = 2;
/** Ratio of held-out errors up to which the explanation with fewer effects is preferred. */
const EQUAL = 1.02;
/** Share of the held-out error that an explanation may leave to be worth a trial. */
const MOST_LEFT = 0.5;

/** @param {{value?: unknown, sigma?: unknown} | null | undefined} number */
function isZero(number) {
  return isNumber(number?.value) && isNumber(number.sigma) && Math.abs(number.value) < SIGMAS * number.sigma;
}

/** Returns true if an effect has fitted sizes, and all are within two standard deviations of zero. Freed numbers of the
 *  arm's file are no deviations from zero.
 *  @param {SizedEffect} effect */
export function isWithinNoise({effect, parameters}) {
  const fitted = Object.values(parameters ?? {}).filter((number) => isNumber(number?.sigma));
  return effect !== FREED && fitted.length > 0 && fitted.every(isZero);
}

/** Returns true if the single size of a ranked effect is within two standard deviations of zero.
 *  @param {{effect: string, size?: {value?: unknown, sigma?: unknown} | null}} ranked */
export function isSizeWithinNoise({effect, size}) {
  return effect !== FREED && isZero(size);
}

/** @param {Closest} explanation */
function leftBy({heldout_rms: left}) {
  return isNumber(left) ? left : Infinity;
}

/**
 * Returns the explanations by their held-out error, smallest first. Those within 2 % of the smallest come first, by their
 * number of effects. Explanations without a held-out error come last, in their order.
 * @template {Closest} T @param {readonly T[]} explanations @returns {T[]}
 */
export function byHeldOut(explanations) {
  const least = Math.min(...explanations.map(leftBy));
  const isNear = (/** @type {T} */ one) => leftBy(one) <= EQUAL * least && least < Infinity;
  const order = (/** @type {T} */ a, /** @type {T} */ b) =>
    leftBy(a) < leftBy(b) ? -1 : leftBy(a) > leftBy(b) ? 1 : 0;
  const near = explanations.filter(isNear).sort((a, b) => a.effects.length - b.effects.length || order(a, b));
  return [...near, ...explanations.filter((one) => !isNear(one)).sort(order)];
}

/**
 * Returns the closest explanation that is worth a trial: it more than halves the held-out error, and all its effects
 * differ from zero. Null if there is none, or if the verdict is not that the error is unexplained.
 * @template {Closest} T
 * @param {{verdict: string, closest?: T[] | null, rms: Record<string, number>}} document @returns {T | null}
 */
export function closestToTry({verdict, closest, rms}) {
  if (verdict !== "unexplained" || !Array.isArray(closest)) return null;
  const [first] = byHeldOut(closest.filter(({effects}) => !effects.some(isWithinNoise)));
  return first && leftBy(first) < MOST_LEFT * rms.heldout_before ? first : null;
}
