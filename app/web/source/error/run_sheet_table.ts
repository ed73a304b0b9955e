// A run sheet as a table: the fields to fill in, and their values.
import type {FillIn} from "../server/documents";

export interface RunSheet {
  text: string;
  /** Fields to fill in for each row, as the program states them. */
  fill: FillIn[];
  /** Ids of readings ticked off by hand. */
  ticked: string[];
  /** Typed values: for each id the fields to fill in, by column. */
  typed: Record<string, Record<string, string>>;
  /** Separation of the explanations by each reading, in sigmas, if known. */
  separations: (number | null)[];
}

export interface RunSheetTable {
  columns: string[];
  rows: string[][];
}

/** Returns the fields of a line; quotes as in CSV. */
export function fieldsOf(line: string): string[] {
  const fields: string[] = [];
  let field = "",
    isQuoted = false;
  for (let i = 0; i < line.length; ++i) {
    const sign = line[i];
    if (sign === '"' && isQuoted && line[i + 1] === '"') field += line[++i];
    else if (sign === '"') isQuoted = !isQuoted;
    else if (sign === "," && !isQuoted) {
      fields.push(field.trim());
      field = "";
    } else field += sign;
  }
  return [...fields, field.trim()];
}

function hasFields(line: string): boolean {
  return line.trim() !== "" && !line.startsWith("#");
}

export function tableOf(text: string): RunSheetTable {
  const lines = text.split(/\r?\n/).filter(hasFields);
  const [columns = [], ...rows] = lines.map(fieldsOf);
  return {columns, rows};
}

/** Returns true if a refusal refers to a row of a table, by its line, and not to the columns. */
export function isOfRow(where: string | undefined, text: string): boolean {
  const line = Number(/:(\d+)/.exec(where ?? "")?.[1]);
  const heading = text.split("\n").findIndex(hasFields) + 1;
  return line > heading;
}

export function lineOf(fields: readonly string[]): string {
  return fields.map((field) => (/[",]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field)).join(",");
}

/** Returns the fields to fill in, by the ids of the rows. */
export function fillById({text, fill}: RunSheet): Map<string, FillIn> {
  return new Map(tableOf(text).rows.map(([id], r) => [id, fill[r]]));
}

/** Returns the columns of the sheet to fill in for at least one reading, in its order. */
export function openColumns({text, fill}: RunSheet): string[] {
  const open = new Set(fill.flatMap(({columns, optional}) => [...columns, ...optional]));
  return tableOf(text).columns.filter((column) => open.has(column));
}

/** Returns the number of filled fields among those that a reading requires. */
function filledCount(columns: readonly string[], row: readonly string[], fill: FillIn): number {
  return fill.columns.filter((column) => (row[columns.indexOf(column)] ?? "") !== "").length;
}

/** Returns the rows of a sheet that are filled in completely ("whole") or partly ("begun"); "" if there is none. */
export function filledRows(text: string, fill: ReadonlyMap<string, FillIn>, asFarAs: "whole" | "begun"): string {
  const {columns, rows} = tableOf(text);
  const filled = rows.filter((row) => {
    const own = fill.get(row[0]);
    return own !== undefined && filledCount(columns, row, own) >= (asFarAs === "whole" ? own.least : 1);
  });
  return filled.length === 0 ? "" : `${[columns, ...filled].map(lineOf).join("\n")}\n`;
}

/** Returns the sheet with the typed values. */
export function withTyped({text, typed}: RunSheet): string {
  const {columns, rows} = tableOf(text);
  const filled = rows.map((row) => row.map((field, k) => typed[row[0]]?.[columns[k]]?.trim() || field));
  return `${[columns, ...filled].map(lineOf).join("\n")}\n`;
}
