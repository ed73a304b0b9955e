// The catalogue of effects by kind: law, parameters, possible places on this arm, and how well the readings determine
// the effect.
import {causeKey} from "../../../drawing/explanations.js";
import type {CatalogueDocument, DiagnoseDocument, ConfoundingDocument} from "../server/documents";

export interface EffectPlace {
  at: string;
  /** Fraction of the effect's displacement that no fitted parameter can reproduce; null without readings. */
  kept: number | null;
  /** Smallest detectable size: a parameter with its value and unit; null if it was not computed. */
  least: {number: string; size: number | null; unit: string; isBeyondUsual: boolean} | null;
  confounded: {effect: string; at: string; title?: string; share: number}[];
}

export interface EffectKind {
  effect: string;
  words: string;
  law: string;
  validity: string;
  source: string;
  parameters: CatalogueDocument["effects"][number]["parameters"];
  places: EffectPlace[];
}

export function kindsOf(
  catalogue: CatalogueDocument,
  confounding: ConfoundingDocument | null,
  diagnosis: DiagnoseDocument | null,
): EffectKind[] {
  const confoundedCauses = new Map((confounding?.causes ?? []).map((cause) => [causeKey(cause), cause]));
  const seen = new Map((diagnosis?.detectable ?? []).map((entry) => [causeKey(entry), entry]));
  const kinds = new Map<string, EffectKind>();
  for (const {effect, at, ...about} of catalogue.effects) {
    const kind = kinds.get(effect) ?? {effect, ...about, places: []};
    kinds.set(effect, kind);
    const cause = confoundedCauses.get(causeKey({effect, at})),
      least = seen.get(causeKey({effect, at}));
    kind.places.push({
      at,
      kept: cause?.kept ?? null,
      least: least
        ? {number: least.number, size: least.size, unit: least.unit, isBeyondUsual: least.beyond_plausible}
        : null,
      confounded: cause?.confounded ?? [],
    });
  }
  return [...kinds.values()];
}

/** Returns the kinds whose name, description, law and places contain all words of the text. */
export function filteredKinds(kinds: readonly EffectKind[], text: string): EffectKind[] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  return kinds.filter((kind) => {
    const all = [kind.effect, kind.words, kind.law, ...kind.places.map(({at}) => at)].join(" ").toLowerCase();
    return words.every((word) => all.includes(word));
  });
}
