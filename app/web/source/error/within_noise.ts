// Effects of the model that the readings do not show: all their fitted sizes are within the noise.
import {computed} from "@preact/signals";
import {causeKey} from "../../../drawing/explanations.js";
import {isNumber} from "../../../drawing/numbers.js";
import type {EffectAt, IdentifyDocument} from "../server/documents";
import {currentModel, state} from "../server/workbench";
import {identify} from "./loop";

/** Size of an effect below which the readings do not show it [standard deviations]. */
const SIGMAS = 2;

/** Returns the effects with fitted sizes, none of which differs from zero. */
export function withinNoise(effects: readonly EffectAt[], parameters: IdentifyDocument["parameters"]): EffectAt[] {
  return effects.filter((effect) => {
    const own = parameters.filter(({name, sigma}) => name.startsWith(`${causeKey(effect)}.`) && isNumber(sigma));
    return own.length > 0 && own.every(({value, sigma}) => Math.abs(value) < SIGMAS * sigma!);
  });
}

/** Effects that the last step added to the model and that the readings do not show. */
export const addedInVain = computed<EffectAt[]>(() => {
  const fitted = identify.value.document,
    model = currentModel.value;
  if (!fitted || !model || fitted.model !== model.id) return [];
  const models = state.value!.models,
    before = models[models.indexOf(model) - 1]?.effects.map(causeKey) ?? [];
  const added = model.effects.filter((effect) => !before.includes(causeKey(effect)));
  return withinNoise(added, fitted.parameters);
});
