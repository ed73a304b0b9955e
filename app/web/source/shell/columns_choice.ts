// Meanings of the columns of foreign tables (readings or a work list): guessed by the program, chosen by the user, or
// chosen earlier.
import {keep, keptObject} from "./kept";

export interface ColumnsDocument {
  /** The tables; `names` is the index of the column that matches the rows of several tables, null if there is none. */
  tables: {
    name: string;
    columns: string[];
    rows: string[][];
    count: number;
    names: number | null;
    /** Remarks on the conversion of the numbers in the file, one sentence each. */
    remarks?: string[];
  }[];
  targets: {
    quantity: string;
    units: string[];
    is_required: boolean;
    found: {table: number; column: number; unit: string} | null;
  }[];
  /** Further options of the tables, under their names for the server. */
  options: {name: string; label: string; values: {value: string; words: string}[]}[];
  /** Alternative lists of quantities; the columns of at least one list must be complete. */
  needs?: string[][];
}

/** Likely meanings of the columns of a work list. */
export interface ListColumnsDocument extends ColumnsDocument {
  states: "tubes" | "joints" | "neither";
  /** True if all headings are understood, so that nothing needs to be chosen. */
  is_understood: boolean;
}

/** Choice for one column. An empty quantity ignores the column; `factor` multiplies its numbers. */
export interface ColumnChoice {
  quantity: string;
  unit: string;
  factor?: string;
}

/** Chosen values of the options, keyed by option name. */
export type TableOptions = Record<string, string>;

export function guessed(document: ColumnsDocument): ColumnChoice[][] {
  const choices = document.tables.map((table) => table.columns.map(() => ({quantity: "", unit: ""})));
  for (const {quantity, found} of document.targets)
    if (found) choices[found.table][found.column] = {quantity, unit: found.unit};
  return choices;
}

/** Returns phrases on missing and duplicate choices; empty if the tables can be accepted. */
export function missingOf(document: ColumnsDocument, choices: ColumnChoice[][]): string[] {
  const chosen = choices.flat().filter((choice) => choice.quantity !== "");
  const words: string[] = [];
  for (const target of document.targets) {
    const mine = chosen.filter((choice) => choice.quantity === target.quantity);
    if (mine.length === 0 && target.is_required) words.push(`a column for ${target.quantity}`);
    if (mine.length > 1) words.push(`only one column for ${target.quantity}`);
    if (mine.some((choice) => choice.unit === "") && target.units.length > 0)
      words.push(`the unit of ${target.quantity}`);
  }
  const has = (quantity: string) => chosen.some((choice) => choice.quantity === quantity);
  if (document.needs && !document.needs.some((together) => together.every(has)))
    words.push(`a column for ${document.needs.map((together) => together.join(" and ")).join(", or for ")}`);
  return words;
}

/** Returns the chosen columns in the notation of the server, such as "x_mm=points.txt:X". */
export function chosenColumns(document: ColumnsDocument, choices: ColumnChoice[][]): string[] {
  return document.tables.flatMap((table, t) =>
    choices[t].flatMap(({quantity, unit, factor}, c) => {
      if (quantity === "") return [];
      const name = unit === "" ? quantity : `${quantity}_${unit}`;
      return [`${name}=${table.name}:${table.columns[c]}${factor ? `*${factor}` : ""}`];
    }),
  );
}

// ---- storage in this browser

const KEPT = "tubeplan.columns";
const MOST_KEPT = 20;

/** Returns a storage key that is equal for tables with the same columns and arms with the same joints. */
function keyOf(document: ColumnsDocument): string {
  const joints = document.targets.filter((target) => target.is_required).map((target) => target.quantity);
  return JSON.stringify([joints, ...document.tables.map((table) => table.columns)]);
}

export function rememberedChoices(document: ColumnsDocument): ColumnChoice[][] | null {
  const kept = keptObject<ColumnChoice[][]>(KEPT)[keyOf(document)];
  const fits =
    Array.isArray(kept) &&
    kept.length === document.tables.length &&
    kept.every(
      (row, t) =>
        Array.isArray(row) &&
        row.length === document.tables[t].columns.length &&
        row.every((choice) => typeof choice?.quantity === "string" && typeof choice?.unit === "string"),
    );
  return fits ? kept : null;
}

export function rememberChoices(document: ColumnsDocument, choices: ColumnChoice[][]): void {
  const others = Object.entries(keptObject<ColumnChoice[][]>(KEPT)).filter(([key]) => key !== keyOf(document));
  const kept = Object.fromEntries([...others.slice(1 - MOST_KEPT), [keyOf(document), choices]]);
  keep(KEPT, kept);
}
