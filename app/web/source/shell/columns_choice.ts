// Which column of foreign tables, of readings or of a work list, is what: as the program guessed, as the user chose, as it was chosen before.
import {keep, keptObject} from "./kept";

export interface ColumnsDocument {
  /** `names`: the column by which rows of several tables go together. */
  tables: {
    name: string;
    columns: string[];
    rows: string[][];
    count: number;
    names: number | null;
    /** What was made of the file's numbers, a sentence each. */
    remarks?: string[];
  }[];
  targets: {
    quantity: string;
    units: string[];
    is_required: boolean;
    found: {table: number; column: number; unit: string} | null;
  }[];
  /** What else may be said of the tables, by the name that the server takes it under. */
  options: {name: string; label: string; values: {value: string; words: string}[]}[];
  /** Lists of quantities: those of one list must be there. */
  needs?: string[][];
}

/** What a table seems to be to a reader of work lists. */
export interface ListColumnsDocument extends ColumnsDocument {
  states: "tubes" | "joints" | "neither";
  /** Its headings need no choice. */
  is_understood: boolean;
}

/** Of one column; an empty quantity: nothing is taken of it; a factor of its numbers, where it is stated. */
export interface ColumnChoice {
  quantity: string;
  unit: string;
  factor?: string;
}

/** Of the options those that were chosen. */
export type TableOptions = Record<string, string>;

export function guessed(document: ColumnsDocument): ColumnChoice[][] {
  const choices = document.tables.map((table) => table.columns.map(() => ({quantity: "", unit: ""})));
  for (const {quantity, found} of document.targets)
    if (found) choices[found.table][found.column] = {quantity, unit: found.unit};
  return choices;
}

/** What keeps the readings from being taken, in words. */
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

/** As the server takes them: "x_mm=points.txt:X". */
export function chosenColumns(document: ColumnsDocument, choices: ColumnChoice[][]): string[] {
  return document.tables.flatMap((table, t) =>
    choices[t].flatMap(({quantity, unit, factor}, c) => {
      if (quantity === "") return [];
      const name = unit === "" ? quantity : `${quantity}_${unit}`;
      return [`${name}=${table.name}:${table.columns[c]}${factor ? `*${factor}` : ""}`];
    }),
  );
}

// ---- remembered in this browser

const KEPT = "tubeplan.columns";
const MOST_KEPT = 20;

/** Tables are the same where their columns are, for an arm with the same joints. */
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
