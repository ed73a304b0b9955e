// Effects of the model that the readings do not show: all their fitted sizes are within the noise.
import {computed} from "@preact/signals";
import {causeKey} from "../../../drawing/explanations.js";
import type {EffectAt, EffectWarning} from "../server/documents";
import {currentModel, state} from "../server/workbench";
import {identify} from "./loop";
import {notNeeded} from "./warning_groups";

/** Returns the effects that the fit warns of as not needed, because all their sizes are near neutral. */
export function withinNoise(effects: readonly EffectAt[], warnings: readonly (string | EffectWarning)[]): EffectAt[] {
  const keys = notNeeded(warnings)
    .filter((warning) => warning.at_neutral)
    .map(causeKey);
  return effects.filter((effect) => keys.includes(causeKey(effect)));
}

/** Effects that the last step added to the model and that the readings do not show. */
export const addedInVain = computed<EffectAt[]>(() => {
  const fitted = identify.value.document,
    model = currentModel.value;
  if (!fitted || !model || fitted.model !== model.id) return [];
  const models = state.value!.models,
    before = models[models.indexOf(model) - 1]?.effects.map(causeKey) ?? [];
  const added = model.effects.filter((effect) => !before.includes(causeKey(effect)));
  return withinNoise(added, fitted.warnings ?? []);
});
