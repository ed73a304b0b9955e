// History of the posterior: the probabilities in successive diagnoses of one model with different numbers of readings,
// as seen by this page.
import {computed, effect, signal} from "@preact/signals";
import {explanationTitle} from "../../../drawing/explanations.js";
import {cell, state} from "../server/workbench";
import {currentDiagnosis} from "./loop";

export interface PosteriorStep {
  readings: number;
  /** Probabilities of the explanations, keyed by title, and of nothing missing. */
  of: Record<string, number>;
}

const NOTHING = "nothing missing";
const MOST_STEPS = 200;
const MOST_TITLES = 5;
const steps = signal<PosteriorStep[]>([]);

let seen = "";
effect(() => {
  const document = currentDiagnosis.value;
  if (!document || !cell.value) return;
  const key = `${cell.value.file} ${document.model}`;
  if (key !== seen) steps.value = [];
  seen = key;
  const readings = document.readings.length;
  const of: Record<string, number> = {[NOTHING]: document.probability.nothing_missing};
  for (const explanation of document.explanations) of[explanationTitle(explanation)] = explanation.probability ?? 0;
  const earlier = steps.peek().filter((step) => step.readings !== readings);
  steps.value = [...earlier, {readings, of}].sort((a, b) => a.readings - b.readings).slice(-MOST_STEPS);
});

/**
 * Steps of the history, with the titles that were most probable at some step, the currently most probable first; null
 * for fewer than two steps.
 */
export const posteriorHistory = computed<{steps: PosteriorStep[]; titles: string[]} | null>(() => {
  if (steps.value.length < 2 || !state.value) return null;
  const most = new Map<string, number>();
  for (const {of} of steps.value)
    for (const [title, probability] of Object.entries(of)) most.set(title, Math.max(most.get(title) ?? 0, probability));
  const last = steps.value.at(-1)!.of;
  const titles = [...most.keys()]
    .filter((title) => most.get(title)! > 0.02)
    .sort((a, b) => (last[b] ?? 0) - (last[a] ?? 0) || most.get(b)! - most.get(a)!)
    .slice(0, MOST_TITLES);
  return {steps: steps.value, titles};
});
