// Effects and explanations of a diagnosis as text. The documents contain the description of each effect.
import {inverseUnit, isNumber, percent} from "./numbers.js";
import {valueAndSigma, withSigma} from "./sigma_text.js";

/**
 * @typedef {{effect: string, at?: string, title?: string, formula?: string}} NamedEffect
 * @typedef {{effect: string, at: string, title?: string, words?: string, parameters?: object}} FoundEffect
 */
/** @typedef {{effects: FoundEffect[], enough?: boolean}} BareExplanation */
/** @typedef {{name: string, value: number, sigma?: number | null, unit?: string}} NamedNumber */

/** Name of a cause that consists of numbers of the arm's file. */
export const FREED = "free";

/** Most letters of a formula within a title. */
const MOST_LETTERS = 32;

/**
 * Returns the title that an effect has of its own: that of the document, as for numbers of the arm's file, or the
 * shortened text of a formula. Undefined if name and location name the effect.
 * @param {NamedEffect} effect
 */
function ownTitle({effect, title, formula}) {
  if (title !== undefined || !formula) return title;
  const isLong = formula.length > MOST_LETTERS;
  return `${effect} ${isLong ? `${formula.slice(0, MOST_LETTERS - 1).trimEnd()}\u2026` : formula}`;
}

/** Returns an effect's own title, otherwise its name and location. @param {NamedEffect} effect */
export function effectTitle(effect) {
  return ownTitle(effect) ?? `${effect.effect}${effect.at ? ` at ${effect.at}` : ""}`;
}

/** Returns the whole formulas of effects, one a line; empty if there are none. @param {readonly NamedEffect[]} effects */
export function formulaTexts(effects) {
  return effects.flatMap(({formula}) => (formula ? [formula] : [])).join("\n");
}

/** Returns an effect in the notation of requests. @param {{effect: string, at: string}} effect */
export function causeKey({effect, at}) {
  return `${effect}@${at}`;
}

/**
 * Returns an effect with its sizes, each with its unit, in the notation of requests: EFFECT@PLACE:SIZE=VALUE,...
 * @param {{effect: string, at: string}} effect
 * @param {readonly {name: string, value: number | string, unit?: string}[]} sizes
 */
export function causeText(effect, sizes) {
  const texts = sizes.map(({name, value, unit}) => `${name}=${value}${unit && unit !== "1" ? unit : ""}`);
  return `${causeKey(effect)}${texts.length > 0 ? `:${texts.join(",")}` : ""}`;
}

/**
 * Returns the names and locations of an explanation's effects, grouped by kind of effect.
 * @param {{effects: readonly NamedEffect[]}} explanation
 */
export function explanationTitle({effects}) {
  return titleOf(effects, Infinity);
}

/**
 * Returns the title of an explanation for a button, where more than two locations of an effect are only counted.
 * @param {{effects: readonly NamedEffect[]}} explanation
 */
export function briefTitle({effects}) {
  return titleOf(effects, 2);
}

/**
 * Returns the words of a button that adds an explanation's effects, or that fits numbers of the arm's file.
 * @param {{effects: readonly NamedEffect[]}} explanation
 */
export function addWords({effects}) {
  const added = effects.filter(({effect}) => effect !== FREED),
    freed = effects
      .filter(({effect}) => effect === FREED)
      .map(({at}) => (at === "geometry" ? `the ${at}` : (at ?? "")));
  const add = added.length > 0 ? [`Add ${briefTitle({effects: added})}`] : [];
  return [...add, ...(freed.length > 0 ? [`${add.length > 0 ? "fit" : "Fit"} ${freed.join(", ")} again`] : [])].join(
    " and ",
  );
}

/** @param {readonly NamedEffect[]} effects @param {number} most */
function titleOf(effects, most) {
  /** @type {Map<string, string[]>} */
  const places = new Map();
  for (const one of effects)
    if (!ownTitle(one)) places.set(one.effect, [...(places.get(one.effect) ?? []), ...(one.at ? [one.at] : [])]);
  const named = [...places]
    .map(([effect, at]) => effectTitle({effect, at: at.length > most ? `${at.length} places` : at.join(", ")}))
    .join(" and ");
  return [named, ...effects.flatMap((effect) => ownTitle(effect) ?? [])].filter((text) => text !== "").join("; ");
}

/** Returns the fitted size of each effect, with the location if there are several. @param {BareExplanation} explanation */
export function sizesOf({effects}) {
  return effects.flatMap((effect) => {
    const text = sizeText(effect);
    return text === "" ? [] : [effects.length > 1 ? `${effect.at}: ${text}` : text];
  });
}

/** Number of effects of one explanation from which their sizes are a table rather than a sentence. */
const MANY_SIZES = 4;

/**
 * Returns the sizes of an explanation with many effects as rows of text: place, parameter, value, sigma and unit, and
 * the stiffness if all are compliances; null for few effects, whose sizes are a sentence (see sizesOf).
 * @param {BareExplanation} explanation
 */
export function sizeRows({effects}) {
  if (effects.length < MANY_SIZES) return null;
  const numbers = effects.flatMap((effect) => shownNumbers(effect).map((number) => ({at: effect.at, number})));
  const hasStiffness = numbers.every(({number}) => /compliance/.test(number.name));
  const rows = numbers.map(({at, number}) => {
    const [value, sigma] = valueAndSigma(number.value, number.sigma);
    const unit = number.unit && number.unit !== "1" ? number.unit : "";
    const stiffness = stiffnessText(number).replace(/^, stiffness /, "");
    return [at, number.name, value, sigma, unit, ...(hasStiffness ? [stiffness || null] : [])];
  });
  return {heads: ["at", "number", "size", "\u00b1 sigma", "unit", ...(hasStiffness ? ["stiffness"] : [])], rows};
}

/** Returns "half width" for the name "half_width". @param {unknown} name */
export function plainName(name) {
  return String(name ?? "").replaceAll("_", " ");
}

/**
 * Returns an effect's fitted parameters; if none was fitted, its parameters other than zero.
 * @param {FoundEffect} effect @returns {NamedNumber[]}
 */
function shownNumbers({parameters}) {
  const all = Object.entries(parameters ?? {}).flatMap(([name, number]) =>
    number !== null && isNumber(number?.value) ? [{...number, name: plainName(name)}] : [],
  );
  const fitted = all.filter((number) => isNumber(number.sigma));
  return asWave(fitted.length > 0 ? fitted : all.filter((number) => number.value !== 0));
}

/**
 * Replaces a sine and a cosine coefficient by amplitude and phase: sine sin(q) + cosine cos(q) equals
 * amplitude sin(q + phase). Other parameters are kept.
 * @param {NamedNumber[]} numbers @returns {NamedNumber[]}
 */
function asWave(numbers) {
  const sine = numbers.find(({name}) => name === "sine"),
    cosine = numbers.find(({name}) => name === "cosine");
  if (!sine || !cosine) return numbers;
  const amplitude = Math.hypot(sine.value, cosine.value);
  const isKnown = isNumber(sine.sigma) && isNumber(cosine.sigma) && amplitude > 0;
  /** @param {number} a @param {number} b */
  const spread = (a, b) =>
    isKnown ? Math.hypot(a * Number(sine.sigma), b * Number(cosine.sigma)) / amplitude : undefined;
  const unit = sine.unit === "rad" ? "rad" : "deg",
    turn = unit === "rad" ? 1 : 180 / Math.PI,
    doubt = spread(cosine.value, sine.value);
  return [
    {name: "amplitude", value: amplitude, sigma: spread(sine.value, cosine.value), unit: sine.unit},
    {
      name: "phase",
      value: turn * Math.atan2(cosine.value, sine.value),
      sigma: doubt === undefined ? undefined : (turn * doubt) / amplitude,
      unit,
    },
    ...numbers.filter((number) => number !== sine && number !== cosine),
  ];
}

/** Returns an effect's parameters, such as "half width 0.0586 +- 0.0010 deg". @param {FoundEffect} effect */
export function sizeText(effect) {
  return shownNumbers(effect)
    .map((number) => `${number.name} ${withSigma(number.value, number.sigma, number.unit)}${stiffnessText(number)}`)
    .join(", ");
}

/** @param {number} compliance @param {number | null | undefined} sigma */
function stiffnessOf(compliance, sigma) {
  return valueAndSigma(1 / compliance, isNumber(sigma) ? sigma / compliance ** 2 : null)[0];
}

/**
 * Returns the stiffness, which drawings and data sheets state instead of the compliance, as text to append. Empty if
 * the parameter is not a compliance or has a sigma above 30 %.
 * @param {NamedNumber} number
 */
function stiffnessText({name, value, sigma, unit}) {
  const isKnown = /compliance/.test(name) && value > 0 && (!isNumber(sigma) || sigma < 0.3 * value);
  return isKnown && unit ? `, stiffness ${stiffnessOf(value, sigma)} ${inverseUnit(unit)}` : "";
}

/**
 * Returns text on the fraction of an effect that is visible in the readings; empty if unknown. @param {unknown}
 * fraction
 */
export function keptText(fraction) {
  if (!isNumber(fraction)) return "";
  if (fraction > 0.98) return "all of it is observable";
  return `${percent(fraction, fraction < 0.1 ? 1 : 0)} of it is observable; the rest is absorbed by the fitted numbers`;
}

/** Returns true if the explanation's effects account for the whole error. @param {{enough?: boolean}} explanation */
export function isEnough(explanation) {
  return explanation.enough !== false;
}

/**
 * Returns a description of the explanation's effects, or a statement that they do not suffice. @param {BareExplanation}
 * explanation
 */
export function explanationWords(explanation) {
  if (!isEnough(explanation)) return "the closest of the known effects, but not enough";
  const words = new Set(explanation.effects.map((effect) => effect.words ?? ""));
  return [...words].filter((text) => text !== "").join("; ");
}

/**
 * Returns every explanation: first the judged explanations, best first, then alternatives known only by name and size.
 * @template {FoundEffect} E @template {{effects: E[], enough?: boolean}} T
 * @param {{explanations?: T[] | null, alternatives?: E[][] | null}} document
 * @returns {(T | {effects: E[], enough?: boolean})[]}
 */
export function explanationsOf(document) {
  const drawn = Array.isArray(document.explanations) ? document.explanations : [];
  const titles = new Set(drawn.map(explanationTitle));
  const others = (Array.isArray(document.alternatives) ? document.alternatives : []).map((effects) => ({effects}));
  return [...drawn, ...others.filter((other) => !titles.has(explanationTitle(other)))];
}

/** Name of the errors of the model refitted without the explanation. */
export const WITHOUT_IT = "refitted without it";
/** Returns the name of the errors of the model refitted with the explanation. @param {BareExplanation} explanation */
export function withIt(explanation) {
  return `with ${isEnough(explanation) ? "" : "the closest, "}${briefTitle(explanation)}`;
}

/** Names of the errors of a model as given, and of the refitted model. */
export const AS_IT_STANDS = "as it stands";
export const REFITTED = "refitted";
