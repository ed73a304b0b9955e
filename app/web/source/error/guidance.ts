// The steps after each verdict of a diagnosis: one table of steps, and one table of the steps for each verdict in
// their order. A step shows its evidence from the documents; a step without evidence does not apply and is left out.
import {closestToTry} from "../../../drawing/closest.js";
import {briefTitle, effectTitle, FREED, formulaTexts} from "../../../drawing/explanations.js";
import {errorUnit, idsSetAside} from "../../../drawing/error_budget.js";
import {errorText, isNumber, percent, plural, probability, short} from "../../../drawing/numbers.js";
import {findVariable, type Variable} from "../../../drawing/variables.js";
import type {CompareDocument, DiagnoseDocument, EffectAt, Model} from "../server/documents";
import {ofModel} from "./in_model";
import {notNeeded} from "./warning_groups";

/** Documents from which the evidence comes; null if unknown. */
export interface Known {
  diagnosis: DiagnoseDocument;
  comparison: CompareDocument | null;
  variables: readonly Variable[];
  /** Sentences on columns that the readings lack. */
  missingColumns: readonly string[];
  /** Formula suggested from the errors; empty if there is none. */
  formula: string;
  /** Names of the fitted numbers of the model. */
  free: readonly string[];
  /** Model that was diagnosed; null if it is unknown. */
  model: Model | null;
}

/** Actions of the page; which of them a step has, and with what. */
export type Act =
  | {kind: "add"; effects: EffectAt[]}
  | {kind: "remove"; effects: EffectAt[]}
  | {kind: "select"; ids: string[]}
  | {kind: "plot"; variable: string}
  | {kind: "formula"; text: string}
  | {kind: "tab"; tab: "split"}
  | {kind: "evidence"; tab: "joints" | "histogram" | "readings"}
  | {kind: "open"};

interface Found {
  evidence: string;
  button?: string;
  /** Tooltip of the button. */
  hint?: string;
  act?: Act;
}

interface StepRow {
  words: string;
  of: (known: Known) => Found | null;
}

/** Returns the first `most` entries, and the number of the others. */
function listed(entries: readonly string[], most: number): string {
  const others = entries.length - most;
  return `${entries.slice(0, most).join(", ")}${others > 0 ? ` and ${others} more` : ""}`;
}

const STEPS = {
  add: {
    words: "Add what is certain",
    of: ({diagnosis: {explanations, rms, ...document}}) => {
      const [first] = explanations;
      if (!first || first.enough === false) return null;
      const unit = errorUnit(document);
      return {
        evidence: `${briefTitle(first)}: the held-out error falls from ${errorText(rms.heldout_before, unit)} to ${errorText(first.heldout_rms, unit)}; noise alone leaves ${errorText(rms.noise_floor, unit)}`,
        button: "Add",
        act: {kind: "add", effects: first.effects},
      };
    },
  },
  addAnyway: {
    words: "Or take the most probable explanation, and test it on further readings",
    of: ({diagnosis: {explanations}}) => {
      const [first] = explanations;
      if (!first || first.enough === false || !isNumber(first.probability)) return null;
      return {
        evidence: `${briefTitle(first)} has the probability ${probability(first.probability)}`,
        button: "Add",
        act: {kind: "add", effects: first.effects},
      };
    },
  },
  tryClosest: {
    words: "Try the closest explanation, which is not certain",
    of: ({diagnosis}) => {
      const closest = closestToTry(diagnosis);
      if (!closest) return null;
      const {rms} = diagnosis,
        [left, whole, floor] = [closest.heldout_rms, rms.heldout_before, rms.noise_floor].map((error) =>
          errorText(error, errorUnit(diagnosis)),
        );
      return {
        evidence: `${briefTitle(closest)} leaves ${left} of the held-out error of ${whole}; noise alone leaves ${floor}, so that more is missing`,
        button: "Add anyway",
        act: {kind: "add", effects: closest.effects},
      };
    },
  },
  addNothing: {
    words: "Add none of the ranked effects yet",
    of: ({diagnosis}) => {
      const {ranking} = diagnosis;
      return ranking.length === 0 || closestToTry(diagnosis)
        ? null
        : {
            evidence: `${effectTitle(ranking[0])} comes first because it resembles the unknown cause most; no effect is certain`,
          };
    },
  },
  read: {
    words: "Take the readings that distinguish the explanations",
    of: ({diagnosis: {next_readings: next, splitting}}) => {
      if (next.length === 0) return null;
      const probabilities = splitting?.pairs?.map((pair) => pair.probability_distinguished).filter(isNumber) ?? [];
      const chance =
        probabilities.length > 0
          ? `; they decide with a probability of ${probability(Math.min(...probabilities))} or more`
          : "";
      return {
        evidence: `${plural(next.length, "reading")} proposed, each with posture, load and direction of approach${chance}`,
        button: "Run sheet",
        act: {kind: "tab", tab: "split"},
      };
    },
  },
  otherMeans: {
    words: "Also measure something else",
    of: ({diagnosis: {splitting}}) => {
      const means = (splitting?.other_means ?? []).map(({what}) => what);
      return means.length > 0 ? {evidence: means.join("; ")} : null;
    },
  },
  columns: {
    words: "Record more with each reading",
    of: ({diagnosis: {splitting}, missingColumns}) => {
      const columns = [...(splitting?.columns_to_add ?? []), ...missingColumns];
      return columns.length > 0 ? {evidence: [...new Set(columns)].join("; ")} : null;
    },
  },
  remainder: {
    words: "See what the remainder follows",
    of: ({diagnosis: {remainder, ...document}, variables}) => {
      if (!remainder || !isNumber(remainder.size) || !(remainder.size > 0)) return null;
      const size = `${short(remainder.size)} ${errorUnit(document)}`;
      if (remainder.follows.length === 0)
        return {evidence: `${size} does not depend on anything that the readings record: it looks like scatter`};
      const list = listed(
        remainder.follows.map(({variable, share}) => `${variable} (${percent(share)})`),
        5,
      );
      const drawn = remainder.follows.map(({variable}) => findVariable(variable, variables)).find((found) => found);
      return {
        evidence: `${size} follows ${list}`,
        ...(drawn ? {button: "Draw", act: {kind: "plot", variable: drawn.key}} : {}),
      };
    },
  },
  patterns: {
    words: "Read the most significant pattern",
    of: ({comparison, variables}) => {
      const [first] = comparison?.patterns ?? [];
      if (!first) return null;
      const drawn = findVariable(first.variable, variables);
      return {
        evidence: first.sentence,
        ...(drawn ? {button: "Draw", act: {kind: "plot", variable: drawn.key}} : {}),
      };
    },
  },
  joints: {
    words: "Look at the error as that of each joint",
    of: ({diagnosis: {joints}}) =>
      joints.length === 0
        ? null
        : {
            evidence: `of ${plural(joints.length, "joint")}, against its angle, its direction, its moment and the load, on one scale`,
            button: "Joints",
            act: {kind: "evidence", tab: "joints"},
          },
  },
  formula: {
    words: "Try the suspected law as a formula",
    of: ({formula}) =>
      formula === ""
        ? null
        : {
            evidence: `${formula}; reject it unless the held-out error falls`,
            button: "Formula",
            act: {kind: "formula", text: formula},
          },
  },
  geometry: {
    words: "Free the geometry that the model keeps fixed",
    of: ({free}) =>
      free.includes("geometry")
        ? null
        : {
            evidence: "lengths and twists that differ from the drawing look like an unknown effect of the posture",
            button: "Free",
            act: {kind: "add", effects: [{effect: FREED, at: "geometry"}]},
          },
  },
  outliers: {
    words: "Check the readings that were set aside",
    of: ({diagnosis}) => {
      const ids = idsSetAside(diagnosis);
      return ids.length === 0
        ? null
        : {
            evidence: `${plural(ids.length, "reading")} beyond the noise: ${listed(ids, 6)}`,
            button: "Select",
            act: {kind: "select", ids},
          };
    },
  },
  worst: {
    words: "Look at the worst readings",
    of: ({comparison}) => {
      const worst = (comparison?.worst ?? []).slice(0, 5);
      return worst.length === 0
        ? null
        : {
            evidence: worst.map(({id, sigmas}) => `${id} (${short(sigmas)} sigmas)`).join(", "),
            button: "Select",
            act: {kind: "select", ids: worst.map(({id}) => id)},
          };
    },
  },
  noise: {
    words: "Check the stated noise",
    of: ({diagnosis: {repeats, probability: chances}}) => {
      if (repeats && isNumber(repeats.noise_ratio))
        return {
          evidence: `repeated readings scatter ${short(repeats.noise_ratio)} times as much as stated (${plural(repeats.groups, "group")} of repeats)`,
          button: "Histogram",
          act: {kind: "evidence", tab: "histogram"},
        };
      const scatter = chances.scatter_alone;
      return isNumber(scatter) && scatter > 0.5
        ? {
            evidence: `what is left looks like scatter (probability ${probability(scatter)}): take some readings twice`,
            button: "Histogram",
            act: {kind: "evidence", tab: "histogram"},
          }
        : null;
    },
  },
  needless: {
    words: "Remove effects that the readings do not need",
    of: ({diagnosis: {warnings}, model}) => {
      const effects = notNeeded(warnings).map((warning) => ofModel(model, warning));
      return effects.length === 0
        ? null
        : {
            evidence: `${briefTitle({effects})}, each tested with the others in the model`,
            button: "Remove",
            hint: formulaTexts(effects),
            act: {kind: "remove", effects},
          };
    },
  },
  untried: {
    words: "State in the arm file what could not be tested",
    of: ({diagnosis: {not_tried: list}}) => (list.length > 0 ? {evidence: list.join("; ")} : null),
  },
  more: {
    words: "Take more readings, or fit fewer numbers",
    of: ({
      diagnosis: {
        probability: {nothing_missing: nothing},
      },
    }) => ({
      evidence: isNumber(nothing)
        ? `the probability that nothing is missing is ${probability(nothing)}, which is not conclusive`
        : "these readings allow no verdict",
      button: "Open readings",
      act: {kind: "open"},
    }),
  },
} satisfies Record<string, StepRow>;

/** Steps after each verdict, in their order; other verdicts need none. */
const AFTER: Record<string, readonly (keyof typeof STEPS)[]> = {
  "partly-explained": [
    "add",
    "needless",
    "remainder",
    "patterns",
    "columns",
    "outliers",
    "noise",
    "formula",
    "geometry",
    "untried",
  ],
  ambiguous: ["read", "otherMeans", "columns", "joints", "needless", "outliers", "addAnyway"],
  unexplained: [
    "tryClosest",
    "addNothing",
    "remainder",
    "patterns",
    "joints",
    "worst",
    "outliers",
    "columns",
    "noise",
    "geometry",
    "formula",
    "untried",
  ],
  inconclusive: ["read", "otherMeans", "columns", "outliers", "noise", "more"],
};

export interface Advice extends Found {
  name: string;
  words: string;
}

/** Returns the steps that apply after the verdict of the diagnosis, each with its evidence. */
export function adviceAfter(known: Known): Advice[] {
  return (AFTER[known.diagnosis.verdict] ?? []).flatMap((name) => {
    const {words, of} = STEPS[name] as StepRow;
    const found = of(known);
    return found ? [{name, words, ...found}] : [];
  });
}
