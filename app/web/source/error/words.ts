// Verdicts and effects in plain words, and what a document says of the model that is current.
import type {Mark} from "../drawing/marks";
import {isNumber, percent, withSigma} from "../drawing/numbers";
import type {EffectAt, EffectNumber, Explanation} from "../server/documents";

export interface Verdict {
  words: string;
  mark: Mark;
}

export const VERDICTS: Record<string, Verdict> = {
  adequate: {words: "Adequate: nothing is missing", mark: {shape: "disc", colour: "case3"}},
  explained: {words: "Explained", mark: {shape: "square", colour: "accent"}},
  "partly-explained": {
    words: "Partly explained: sure causes, and a remainder",
    mark: {shape: "square", colour: "violet"},
  },
  ambiguous: {words: "One of several: A or B", mark: {shape: "half", colour: "violet"}},
  unexplained: {words: "Unexplained: none of the known effects", mark: {shape: "cross", colour: "case0"}},
  inconclusive: {words: "Inconclusive: more readings are needed", mark: {shape: "ring", colour: "muted"}},
  "falls-short": {words: "The model falls short", mark: {shape: "triangle", colour: "case0"}},
};

export function verdictOf(name: string): Verdict {
  return Object.hasOwn(VERDICTS, name) ? VERDICTS[name] : {words: name, mark: {shape: "diamond", colour: "muted"}};
}

const EFFECT_WORDS: Record<string, string> = {
  "joint-offset": "a joint's zero is off",
  "joint-scale": "a joint's gear ratio is off",
  "encoder-eccentricity": "a joint's encoder runs off centre",
  "transmission-error": "a joint's gear errs twice per turn",
  hysteresis: "a joint rests elsewhere by the sense of its last motion",
  "joint-coupling": "one joint's motion moves another",
  "link-length": "a link is longer or shorter than drawn",
  "link-twist": "a link is twisted",
  "tool-offset": "the tip is elsewhere on the tool",
  "link-weight": "a link weighs more or less",
  "tool-weight": "the tool weighs more or less",
  "payload-offset": "the load hangs beside the tip",
  "gravity-tilt": "gravity leans in the base's frame",
  "hose-pull": "a hose or cable pulls at a link",
  "contact-force": "something presses on the tip",
  "joint-compliance": "a joint axis taken as rigid gives",
  "link-bending": "a beam taken as rigid bends",
  "link-torsion": "a beam taken as rigid twists",
  stiffening: "a joint is soft under small moments, stiffer beyond",
  backlash: "a clearance is crossed with the moment's sense",
  "thermal-growth": "lengths grow with temperature",
  "base-slip": "the base has slipped once",
  "base-drift": "the base creeps in time",
  "scale-error": "the measuring scale is off",
  "gravity-sag": "a joint gives under weights that the arm file does not state",
  "tool-remount": "the tip was mounted anew for a set-up",
  "gear-wave": "a joint's gear errs once per turn of the motor",
  "slide-bending": "a slide bends by how far it is out",
  "cable-stretch": "a joint's cable stretches with torque and direction",
  free: "a number of the arm's file is off",
  formula: "a formula of one's own",
};

export function effectWords(effect: string): string {
  return Object.hasOwn(EFFECT_WORDS, effect) ? EFFECT_WORDS[effect] : "";
}

export function effectTitle(effect: EffectAt): string {
  return `${effect.effect}${effect.at ? ` at ${effect.at}` : ""}`;
}

export function explanationTitle(explanation: {effects: EffectAt[]}): string {
  return explanation.effects.map(effectTitle).join(" and ");
}

function isFigure(value: unknown): value is EffectNumber {
  return typeof value === "object" && value !== null && isNumber((value as EffectNumber).value);
}

/** The numbers that were fitted, with their sigmas; without any, those that are not zero. */
export function sizeText(effect: EffectAt): string {
  const all = Object.entries(effect.parameters ?? {}).flatMap(([name, value]) =>
    isFigure(value) ? [{...value, name: name.replaceAll("_", " ")}] : [],
  );
  const fitted = all.filter((number) => isNumber(number.sigma));
  const telling = fitted.length > 0 ? fitted : all.filter((number) => number.value !== 0);
  return telling.map((number) => `${number.name} ${withSigma(number.value, number.sigma, number.unit)}`).join(", ");
}

/** What hides in the fitted numbers. */
export function keptText(fraction: number | undefined): string {
  if (!isNumber(fraction) || fraction > 0.98) return "";
  return `${percent(fraction, fraction < 0.1 ? 1 : 0)} of it shows; the rest hides in the fitted numbers`;
}

export function isEnough(explanation: Explanation): boolean {
  return explanation.enough !== false;
}
