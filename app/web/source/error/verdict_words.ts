// The verdict as a list: every sentence of it, figures to as many digits as noise carries, nothing cut.
import {percent, short} from "../drawing/numbers";
import type {CompareDocument, DiagnoseDocument} from "../server/documents";
import {explanationTitle, sizeText} from "./words";

export function verdictItems(document: DiagnoseDocument): string[] {
  const advice = document.splitting?.advice ?? "";
  return [...findingItems(document), ...sentencesOf(advice)];
}

function findingItems(document: DiagnoseDocument): string[] {
  const {explanations, rms, units} = document,
    first = explanations[0];
  const alternatives = document.alternatives.length;
  if (first && (document.verdict === "explained" || document.verdict === "partly-explained")) {
    const sizes = first.effects.map(sizeText).filter((text) => text !== "");
    return [
      `Missing: ${explanationTitle(first)}${sizes.length > 0 ? ` (${sizes.join("; ")})` : ""}.`,
      `With it the held-out error falls from ${short(rms.heldout_before)} to ${short(rms.heldout_after)} ${units.length}; ` +
        `noise alone leaves ${short(rms.noise_floor)} ${units.length}.`,
      ...remainderItems(document),
    ];
  }
  if (document.verdict === "ambiguous" && alternatives > 1) {
    return [
      `${alternatives} explanations fit these readings equally well; each has a card below.`,
      `With the first, ${explanationTitle({effects: document.alternatives[0]})}, the held-out error falls from ` +
        `${short(rms.heldout_before)} to ${short(rms.heldout_after)} ${units.length}; noise alone leaves ` +
        `${short(rms.noise_floor)} ${units.length}.`,
    ];
  }
  if (document.verdict === "adequate")
    return [
      `Nothing is missing: the error of ${short(rms.before)} ${units.length} is what noise leaves ` +
        `(${short(rms.noise_floor)} ${units.length}).`,
    ];
  if (document.verdict === "unexplained" && !isScatter(document))
    return ["Something is missing, and no known effect is sure to be part of it.", ...remainderItems(document)];
  return sentencesOf(document.sentence);
}

/** Beyond the stated noise, and following nothing: then the program's own words say what that can be. */
function isScatter({probability}: DiagnoseDocument): boolean {
  return (probability.scatter_alone ?? 0) > 0.5;
}

function remainderItems({remainder, units}: DiagnoseDocument): string[] {
  if (!remainder || remainder.size === null || !(remainder.size > 0)) return [];
  const follows = remainder.follows.map(({variable, share}) => `${variable} (${percent(share)})`);
  return [
    `${short(remainder.size)} ${units.length} remains that no known effect explains` +
      `${follows.length > 0 ? `; it follows ${follows.slice(0, 3).join(", ")}` : ", and follows nothing that the readings state"}.`,
  ];
}

/** The comparison's reasons, one by one. */
export function comparisonItems(document: CompareDocument): string[] {
  const {rms, units} = document;
  return [
    `The error is ${short(rms.before)} ${units.length} as the model stands and ${short(rms.after)} ${units.length} refitted; ` +
      `noise alone leaves ${short(rms.noise_floor)} ${units.length}.`,
    ...document.grounds.map((ground) => `${ground[0].toUpperCase()}${ground.slice(1)}.`),
  ];
}

export function sentencesOf(text: string): string[] {
  return text
    .split(/(?<=[.;:])\s+(?=[A-Z(]|or |load )/)
    .map((part) => part.trim())
    .filter((part) => part !== "");
}
