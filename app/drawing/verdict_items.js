// A verdict as a list: every sentence of it, figures to as many digits as noise carries, nothing cut.
import {effectTitle, explanationTitle, sizesOf} from "./explanations.js";
import {fixed, isNumber, percent, short} from "./numbers.js";

/** @typedef {import("./explanations.js").FoundEffect} FoundEffect */
/** @typedef {{verdict: string, sentence?: string, units?: {length: string}, rms?: Record<string, number | null>,
 *    explanations?: {effects: FoundEffect[]}[], alternatives?: FoundEffect[][], splitting?: {advice?: string} | null,
 *    probability?: {scatter_alone?: number | null} | null, repeats?: {noise_ratio: number} | null,
 *    remainder?: {size: number | null, follows: {variable: string, share: number}[]} | null}} Diagnosed */
/**
 * @typedef {{sentence?: string, units?: {length: string}, rms?: Record<string, number | null>,
 *    grounds?: string[]}} Compared
 */

/** Of more effects the sizes stand on the card alone. */
const MOST_SIZES = 3;

/** @param {Diagnosed} document */
export function verdictItems(document) {
  return [...findingItems(document), ...sentencesOf(document.splitting?.advice ?? "")];
}

/** @param {Diagnosed} document @returns {string[]} */
function findingItems(document) {
  const {verdict, explanations = [], alternatives = []} = document,
    first = explanations[0];
  const error = lengthsOf(document);
  if (first && (verdict === "explained" || verdict === "partly-explained")) {
    const sizes = first.effects.length > MOST_SIZES ? [] : sizesOf(first);
    return [
      `Missing: ${explanationTitle(first)}${sizes.length > 0 ? ` (${sizes.join("; ")})` : ""}${equalsText(first)}.`,
      `With it ${fallText(error)}`,
      ...remainderItems(document),
      ...repeatsItems(document),
    ];
  }
  if (verdict === "ambiguous" && alternatives.length > 1)
    return [
      `${alternatives.length} explanations fit these readings equally well.`,
      `With the first, ${explanationTitle({effects: alternatives[0]})}, ${fallText(error)}`,
    ];
  if (verdict === "adequate")
    return [
      `Nothing is missing: the error of ${error("before")} is explained by noise (${error("noise_floor")}).`,
      ...repeatsItems(document),
    ];
  if (verdict === "unexplained" && !isScatter(document))
    return ["Something is missing, and no known effect is certain to be part of it.", ...remainderItems(document)];
  return sentencesOf(document.sentence ?? "");
}

/** @param {{rms?: Record<string, number | null>, units?: {length: string}}} document */
function lengthsOf({rms, units}) {
  return (/** @type {string} */ name) => `${short(rms?.[name])} ${units?.length ?? ""}`;
}

/** @param {(name: string) => string} error */
function fallText(error) {
  const from = error("heldout_before").split(" ")[0];
  const to = error("heldout_after");
  return `the held-out error falls from ${from} to ${to}; the noise floor is ${error("noise_floor")}.`;
}

/**
 * Beyond the stated noise, and following nothing: then the program's own words say what that can be.
 * @param {Diagnosed} document
 */
function isScatter({probability, remainder}) {
  return (probability?.scatter_alone ?? 0) > 0.5 && (remainder?.follows ?? []).length === 0;
}

/** @param {Diagnosed} document */
function remainderItems({remainder, units}) {
  if (!remainder || !isNumber(remainder.size) || !(remainder.size > 0)) return [];
  const follows = (remainder.follows ?? []).slice(0, 3).map(({variable, share}) => `${variable} (${percent(share)})`);
  const what =
    follows.length > 0
      ? `no known effect explains; it follows ${follows.join(", ")}`
      : "follows no slow function of what the readings record";
  return [`${short(remainder.size)} ${units?.length ?? ""} remains that ${what}.`];
}

/** Effects that no reading could distinguish from those that were found. @param {{effects: FoundEffect[]}} explanation */
function equalsText({effects}) {
  const equals = effects.flatMap((effect) =>
    (effect.also ?? []).map((other) => `${effectTitle(other)} in place of ${effectTitle(effect)}`),
  );
  return equals.length > 0 ? `, or ${equals.join(" and ")}, which no reading with this tool tells apart` : "";
}

/** @param {Diagnosed} document */
function repeatsItems({repeats}) {
  if (!repeats) return [];
  return [
    `Repeated readings scatter ${fixed(repeats.noise_ratio, 2)} times as much as stated, and this is all that is left.`,
  ];
}

/** The comparison's reasons, one by one. @param {Compared} document */
export function comparisonItems(document) {
  const error = lengthsOf(document);
  return [
    `The error is ${error("before")} as given and ${error("after")} refitted; ` +
      `noise alone explains ${error("noise_floor")}.`,
    ...(document.grounds ?? []).map((ground) => `${ground.charAt(0).toUpperCase()}${ground.slice(1)}.`),
  ];
}

/** @param {string} text */
export function sentencesOf(text) {
  return text
    .split(/(?<=[.;:])\s+(?=[A-Z(]|or |load )/)
    .map((part) => part.trim())
    .filter((part) => part !== "");
}
