// Effects and freed numbers that a model has, as needed by the buttons that add or remove them.
import {causeKey} from "../../../drawing/explanations.js";
import type {EffectAt, Model} from "../server/documents";

type Cause = Pick<EffectAt, "effect" | "at">;
type ModelParts = Pick<Model, "effects" | "free">;

/** Name of a cause that consists of numbers of the arm's file. */
const FREED = "free";

/** Returns true if the model has the effect, or fits the freed numbers. */
export function hasCause(model: ModelParts | null, {effect, at}: Cause): boolean {
  if (effect === FREED) return model?.free.includes(at) ?? false;
  return model?.effects.some((own) => own.effect === effect && own.at === at) ?? false;
}

interface Alternative {
  effects: readonly Cause[];
}

function isPartOf(small: Alternative, large: Alternative): boolean {
  const keys = new Set(large.effects.map(causeKey));
  return small.effects.length < keys.size && small.effects.every((effect) => keys.has(causeKey(effect)));
}

/** State of an alternative: not in the model, added itself, or only part of a larger alternative that was added. */
export type Standing = "open" | "added" | "part of the added";

/** Returns the standing of an alternative among all alternatives of a diagnosis. */
export function standingOf(one: Alternative, all: readonly Alternative[], model: ModelParts | null): Standing {
  const isIn = ({effects}: Alternative) => effects.length > 0 && effects.every((effect) => hasCause(model, effect));
  if (!isIn(one)) return "open";
  return all.some((other) => isIn(other) && isPartOf(one, other)) ? "part of the added" : "added";
}
