// Ranking of effects as table rows: values as text, and lengths of bars.
import {effectTitle, keptText, plainName} from "./explanations.js";
import {isNumber, MISSING, percent, plural, probability, short} from "./numbers.js";
import {withSigma} from "./sigma_text.js";

/** Number of ranked effects shown; further rows are folded. */
export const MOST_RANKED = 12;

/** Decrease of chi-square below which an effect is folded: noise alone gives as much in 1 of 20 cases. */
export const LEAST_FALL = 4;

/** @typedef {{name: string, value: number, sigma: number | null, unit: string}} RankedSize */
/** @typedef {{effect: string, at: string, words?: string, probability?: number | null, chi2_fall?: number | null,
 *    kept_fraction?: number | null, size?: RankedSize | null}} Ranked */

/** Heading of a ranked effect's probability: the sum over all explanations that contain the effect. */
export const IS_THERE = "probability that it is present";

/** Text with a bar, whose length is the fraction `share`. @typedef {{share: number, text: string}} Barred */

/** @param {unknown} value @param {number} most @param {string} text @returns {Barred} */
export function barred(value, most, text) {
  return {share: isNumber(value) && most > 0 ? Math.max(0, Math.min(1, value / most)) : 0, text};
}

/** @template {Ranked} T @param {readonly T[]} ranking */
export function rankingRows(ranking) {
  const falls = ranking.map((entry) => entry.chi2_fall).filter(isNumber);
  const most = falls.reduce((largest, fall) => Math.max(largest, fall), 1e-12);
  return ranking.map((entry) => ({
    entry,
    title: effectTitle(entry),
    words: entry.words ?? "",
    kept: keptText(entry.kept_fraction),
    probability: barred(entry.probability, 1, probability(entry.probability)),
    fall: barred(entry.chi2_fall, most, short(entry.chi2_fall)),
    size: entry.size
      ? {name: plainName(entry.size.name), text: withSigma(entry.size.value, entry.size.sigma, entry.size.unit)}
      : {name: "", text: MISSING},
    shows: barred(entry.kept_fraction, 1, percent(entry.kept_fraction)),
  }));
}

/**
 * Divides ranked rows into those shown, at most MOST_RANKED, and those folded. Effects that lower chi-square by less
 * than LEAST_FALL are folded.
 * @template {{entry: Ranked}} T @param {readonly T[]} rows @returns {{shown: T[], folded: T[], isWeak: boolean}}
 *   `isWeak`: all folded effects lower chi-square by less than LEAST_FALL
 */
export function foldedRows(rows) {
  const isNotable = (/** @type {T} */ {entry}) => !isNumber(entry.chi2_fall) || entry.chi2_fall >= LEAST_FALL;
  const shown = rows.filter(isNotable).slice(0, MOST_RANKED);
  const folded = rows.filter((row) => !shown.includes(row));
  return {shown, folded, isWeak: !folded.some(isNotable)};
}

/**
 * Returns text on the number of causes tried and, if available, on the probabilities that nothing is missing and that
 * no known effect is involved.
 * @param {{ranking: readonly unknown[], probability?: any, probability_words?: unknown}} document
 */
export function triedText({ranking, probability: chances, probability_words: meaning}) {
  const causes = `${plural(ranking.length, "cause")} ${ranking.length === 1 ? "was" : "were"}`;
  const tried = `${causes} tried, each alone and with others.${typeof meaning === "string" ? ` ${sentence(meaning)}` : ""}`;
  if (!isNumber(chances?.nothing_missing)) return tried;
  return (
    `${tried} The probability that nothing is missing is ${probability(chances.nothing_missing)}, ` +
    `that no known effect is involved ${probability(chances.unknown_alone)}.`
  );
}

/** @param {string} words */
function sentence(words) {
  return `${words.charAt(0).toUpperCase()}${words.slice(1)}.`;
}
