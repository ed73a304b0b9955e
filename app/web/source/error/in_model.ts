// Effects and freed numbers that a model has, as needed by the buttons that add or remove them.
import {causeKey, effectTitle, FREED, formulaTexts} from "../../../drawing/explanations.js";
import type {EffectAt, IdentifyDocument, Model} from "../server/documents";

type Cause = Pick<EffectAt, "effect" | "at">;
type ModelParts = Pick<Model, "effects" | "free">;

/** Returns true if the model has the effect, or fits the freed numbers. */
export function hasCause(model: ModelParts | null, {effect, at}: Cause): boolean {
  if (effect === FREED) return model?.free.includes(at) ?? false;
  return model?.effects.some((own) => own.effect === effect && own.at === at) ?? false;
}

/** Returns the effect as the model has it, which includes the formula of a user-defined one; otherwise the effect itself. */
export function ofModel(model: ModelParts | null | undefined, {effect, at}: Cause): EffectAt {
  return model?.effects.find((own) => own.effect === effect && own.at === at) ?? {effect, at};
}

type Parameter = IdentifyDocument["parameters"][number];

/** Returns the parameters of a fit; those of formulas are titled by the formula, with its whole text as a hint. */
export function withFormulas(parameters: readonly Parameter[], model: ModelParts | null | undefined): Parameter[] {
  const formulas = model?.effects.filter(({formula}) => formula) ?? [];
  return parameters.map((parameter) => {
    const own = formulas.find((effect) => parameter.name.startsWith(`${causeKey(effect)}.`));
    if (!own) return parameter;
    const title = `${parameter.name.slice(causeKey(own).length + 1)} of ${effectTitle(own)}`;
    return {...parameter, title, hint: `${parameter.name}: ${formulaTexts([own])}`};
  });
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
