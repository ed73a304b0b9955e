// Warnings about the effects of a model, grouped by kind.
import type {EffectWarning} from "../server/documents";

export interface WarningGroup {
  kind: string;
  warnings: EffectWarning[];
}

/** Returns the warnings in groups of one kind, in the order in which the kinds first occur. */
export function warningGroups(warnings: readonly (string | EffectWarning)[]): WarningGroup[] {
  const groups = new Map<string, EffectWarning[]>();
  for (const entry of warnings) {
    const warning = typeof entry === "string" ? {sentence: entry} : entry;
    const kind = warning.kind ?? "";
    groups.set(kind, [...(groups.get(kind) ?? []), warning]);
  }
  return [...groups].map(([kind, own]) => ({kind, warnings: own}));
}

/** Returns the warnings about effects that the readings do not need. */
export function notNeeded(warnings: readonly (string | EffectWarning)[]) {
  return warnings.flatMap((entry) =>
    typeof entry !== "string" && entry.kind === "not-needed" && entry.effect && entry.at
      ? [{...entry, effect: entry.effect, at: entry.at}]
      : [],
  );
}
