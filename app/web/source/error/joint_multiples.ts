// The errors as those of each joint against its angle, its direction, its moment and the load, each with the p-value
// that the program's pattern search gave that variable: which panels there are, and which is the loudest.
import type {PatternTest} from "../server/documents";
import {followedShare} from "./own_variable";
import {jointKey, type Part} from "./parts";
import type {ReadingErrors} from "./residuals";
import {findVariable, type Variable} from "../../../drawing/variables.js";

export const COLUMNS = ["angle", "direction", "moment", "load"] as const;
export type ColumnName = (typeof COLUMNS)[number];

export interface Multiple {
  joint: string;
  column: ColumnName;
  variable: Variable;
  part: Part;
  /** Over all tests, of the search; null where it was not tested. */
  p: number | null;
  /** The share of this joint's error that follows the variable. */
  share: number;
}

/** Less than this is no finding: as the program's own search has it. */
const FOUND = 0.01;

export interface MultiplesSource {
  errors: ReadingErrors;
  variables: readonly Variable[];
  parts: readonly Part[];
  tested: readonly PatternTest[];
  /** Of each joint: the name of the row that it turns. */
  rowOf: (joint: string) => string;
}

export function multiplesOf(source: MultiplesSource): Multiple[] {
  return source.errors.joints.flatMap((joint) => {
    const part = source.parts.find((entry) => entry.key === jointKey(joint));
    if (!part) return [];
    const names: Record<ColumnName, string> = {
      angle: joint,
      direction: `sense of ${joint}`,
      moment: `moment ${source.rowOf(joint)}.z`,
      load: "load",
    };
    return COLUMNS.flatMap((column) => {
      const variable = findVariable(names[column], source.variables);
      return variable ? [multipleOf(source, joint, column, variable, part, names[column])] : [];
    });
  });
}

function multipleOf(
  {errors, tested}: MultiplesSource,
  joint: string,
  column: ColumnName,
  variable: Variable,
  part: Part,
  name: string,
): Multiple {
  const values = errors.series[errors.tested].errors.map((error, i) => (error ? part.of(error, i) : null));
  const chances = tested.flatMap((test) => (test.variable === name && test.p_value !== null ? [test.p_value] : []));
  return {
    joint,
    column,
    variable,
    part,
    p: chances.length > 0 ? Math.min(...chances) : null,
    share: followedShare(
      errors.readings.map((reading, i) => variable.of(reading, i)),
      values,
    ),
  };
}

/** The least p-value; of those alike, as the load's are, where the joint's own error follows most. Null: none is found. */
export function loudest(multiples: readonly Multiple[]): Multiple | null {
  const found = multiples.filter((entry) => entry.p !== null && entry.p < FOUND);
  return found.reduce<Multiple | null>((best, entry) => {
    if (best === null || entry.p! < best.p!) return entry;
    return entry.p === best.p && entry.share > best.share ? entry : best;
  }, null);
}
