// Conclusion on the current model: the newest verdict, or the effect of the last model change on the error.
import {computed} from "@preact/signals";
import {explanationTitle} from "../../../drawing/explanations.js";
import {verdictMark} from "../../../drawing/kinds.js";
import {errorText} from "../../../drawing/numbers.js";
import {verdictItems} from "../../../drawing/verdict_items.js";
import type {Mark} from "../drawing/marks";
import {pageWords} from "../server/page_words";
import {currentModel, hasModelBefore, state} from "../server/workbench";
import {ladderOf, lastChange} from "./ladder";
import {currentComparison, currentDiagnosis, ladder} from "./loop";
import {addedInVain} from "./within_noise";

interface Answer {
  words: string;
  mark: Mark;
  items: string[];
}

function answerOf({verdict, verdict_words}: {verdict: string; verdict_words?: string}, items: string[]): Answer {
  return {words: verdict_words ?? verdict, mark: verdictMark(verdict), items: items.map(pageWords)};
}

/** Verdict and sentences at the top of the view, from the newest document about the current model. */
export const answer = computed<Answer | null>(() => {
  const diagnosed = currentDiagnosis.value,
    compared = currentComparison.value;
  if (diagnosed) return answerOf(diagnosed, verdictItems(diagnosed));
  const fallen = fallOfError();
  // The first sentence of the comparison states the error, which the change of the error states already.
  if (fallen && compared && compared.verdict !== "adequate")
    return answerOf(compared, [...fallen.items, ...verdictItems(compared).slice(1)]);
  return fallen ?? (compared ? answerOf(compared, verdictItems(compared)) : null);
});

/** Returns a statement of how the last model change affected the error; null if the ladder lacks the models. */
function fallOfError(): Answer | null {
  const document = ladder.value.document;
  if (!document || document.model !== state.value?.model || document.models.length < 2 || !hasModelBefore.value)
    return null;
  const {models, floor, unit} = ladderOf(document),
    errors = lastChange(models);
  if (!errors) return null;
  const {before, now, error} = errors,
    isAtFloor = floor !== null && now < 1.25 * floor;
  const [from, to] = [errorText(before, unit), errorText(now, unit)];
  const change = from === to ? `stays at ${to}` : `${now < before ? "fell" : "rose"} from ${from} to ${to}`;
  return {
    words: isAtFloor ? "At the noise floor" : "Above the noise floor",
    mark: verdictMark(isAtFloor ? "adequate" : "falls-short"),
    items: [
      `With ${(currentModel.value?.label ?? "this model").replace(/^\+ /, "")} the ${error} error ${change}; ` +
        `noise alone leaves ${errorText(floor, unit)}.`,
      ...vainItems(),
    ],
  };
}

/** Returns a sentence on effects that were added without need; empty if there are none. */
function vainItems(): string[] {
  const effects = addedInVain.value;
  if (effects.length === 0) return [];
  const size = effects.length === 1 ? "its size is" : "their sizes are";
  return [`Not significant: ${explanationTitle({effects})}; ${size} within two standard deviations of zero.`];
}
