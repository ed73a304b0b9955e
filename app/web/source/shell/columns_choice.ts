// Meanings of the columns of foreign tables, of readings or of a work list: as the program guessed, as the user chose,
// as chosen earlier.
import {keep, keptObject} from "./kept";

export interface ColumnsDocument {
  /** Tables; `names` is the column that matches the rows of several tables. */
  tables: {
    name: string;
    columns: string[];
    rows: string[][];
    count: number;
    names: number | null;
    /** Remarks on the conversion of the file's numbers, one sentence each. */
    remarks?: string[];
  }[];
  targets: {
    quantity: string;
    units: string[];
    is_required: boolean;
    found: {table: number; column: number; unit: string} | null;
  }[];
  /** Further choices about the tables, by their names for the server. */
  options: {name: string; label: string; values: {value: string; words: string}[]}[];
  /** Alternative lists of quantities, one of which must be complete. */
  needs?: string[][];
}

/** Likely meanings of a table's columns as a work list. */
export interface ListColumnsDocument extends ColumnsDocument {
  states: "tubes" | "joints" | "neither";
  /** True if its headings need no choice. */
  is_understood: boolean;
}

/** Choice for one column; an empty quantity ignores it; a factor of its numbers, if stated. */
export interface ColumnChoice {
  quantity: string;
  unit: string;
  factor?: string;
}

/** Chosen values of the options. */
export type TableOptions = Record<string, string>;

export function guessed(document: ColumnsDocument): ColumnChoice[][] {
  const choices = document.tables.map((table) => table.columns.map(() => ({quantity: "", unit: ""})));
  for (const {quantity, found} of document.targets)
    if (found) choices[found.table][found.column] = {quantity, unit: found.unit};
  return choices;
}

/** Returns in words what prevents accepting the readings. */
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

/** Returns the columns in the notation of the server: "x_mm=points.txt:X". */
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

/** Returns a key, equal for tables with the same columns and arms with the same joints. */
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
