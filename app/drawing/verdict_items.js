// Verdict of a diagnosis or a comparison as the list of sentences that the document contains, with one on an effect that
// probably acts at more joints than the verdict names.
import {effectTitle} from "./explanations.js";
import {probability} from "./numbers.js";

/** Place of an effect that acts at every joint. */
const ALL_JOINTS = "all joints";

/**
 * Verdict with its effects, each with its name and its place, and in the ranking with its probability.
 * @typedef {{sentence?: string, sentences?: string[], splitting?: {advice?: string} | null, joints?: unknown[],
 *   explanations?: {effects: any[]}[], ranking?: any[]}} Judged
 */

/**
 * Returns the sentences of the verdict, with the advice on further readings last. Documents of earlier versions contain
 * one text that includes the advice; it is returned unchanged.
 * @param {Judged} document @returns {string[]}
 */
export function verdictItems(document) {
  const {sentence, sentences, splitting} = document;
  if (!Array.isArray(sentences)) return sentence ? [sentence] : [];
  return [...sentences, ...commonItems(document), ...(splitting?.advice ? [splitting.advice] : [])];
}

/**
 * Returns a sentence for each effect that is more probable at all joints than not, if the leading explanation names it
 * at some joints only: at the others its size is within the noise.
 * @param {Judged} document
 */
function commonItems({explanations = [], ranking = [], joints = []}) {
  const effects = explanations[0]?.effects ?? [];
  return ranking.flatMap(({effect, at, probability: chance}) => {
    const places = effects.filter((one) => one.effect === effect).map((one) => one.at);
    const isCommon = at === ALL_JOINTS && typeof chance === "number" && chance > 0.5;
    if (!isCommon || places.length === 0 || places.length >= joints.length || places.includes(ALL_JOINTS)) return [];
    return [
      `${effectTitle({effect, at})} has the probability ${probability(chance)}; only at ${places.join(", ")} do the readings ` +
        "show its size.",
    ];
  });
}
