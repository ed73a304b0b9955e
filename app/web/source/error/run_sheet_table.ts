// A run sheet as a table: the fields to fill in and their values.
import type {FillIn} from "../server/documents";

export interface RunSheet {
  text: string;
  /** Fields to fill in for each row, as stated by the program. */
  fill: FillIn[];
  /** Ids of readings ticked off by hand. */
  ticked: string[];
  /** Typed values, keyed by reading id and column. */
  typed: Record<string, Record<string, string>>;
  /** Separation of the explanations by each reading [sigmas]; null or empty if unknown. */
  separations: (number | null)[];
}

export interface RunSheetTable {
  columns: string[];
  rows: string[][];
}

/** Returns the fields of a CSV line, which may be quoted. */
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

/** Returns true if a refusal refers to the line of a row of the table, and not to its heading. */
export function isOfRow(where: string | undefined, text: string): boolean {
  const line = Number(/:(\d+)/.exec(where ?? "")?.[1]);
  const heading = text.split("\n").findIndex(hasFields) + 1;
  return line > heading;
}

export function lineOf(fields: readonly string[]): string {
  return fields.map((field) => (/[",]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field)).join(",");
}

/** Returns the fields to fill in, keyed by reading id. */
export function fillById({text, fill}: RunSheet): Map<string, FillIn> {
  return new Map(tableOf(text).rows.map(([id], r) => [id, fill[r]]));
}

/** Returns the columns to fill in for at least one reading, in the order of the sheet. */
export function openColumns({text, fill}: RunSheet): string[] {
  const open = new Set(fill.flatMap(({columns, optional}) => [...columns, ...optional]));
  return tableOf(text).columns.filter((column) => open.has(column));
}

/** Returns the number of required fields of a reading that are filled in. */
function filledCount(columns: readonly string[], row: readonly string[], fill: FillIn): number {
  return fill.columns.filter((column) => (row[columns.indexOf(column)] ?? "") !== "").length;
}

/**
 * Returns the rows of a sheet that are filled in completely ("whole") or at least partly ("begun"), as CSV text; "" if
 * there are none.
 */
export function filledRows(text: string, fill: ReadonlyMap<string, FillIn>, asFarAs: "whole" | "begun"): string {
  const {columns, rows} = tableOf(text);
  const filled = rows.filter((row) => {
    const own = fill.get(row[0]);
    return own !== undefined && filledCount(columns, row, own) >= (asFarAs === "whole" ? own.least : 1);
  });
  return filled.length === 0 ? "" : `${[columns, ...filled].map(lineOf).join("\n")}\n`;
}

/** Returns the text of the sheet with the typed values inserted. */
export function withTyped({text, typed}: RunSheet): string {
  const {columns, rows} = tableOf(text);
  const filled = rows.map((row) => row.map((field, k) => typed[row[0]]?.[columns[k]]?.trim() || field));
  return `${[columns, ...filled].map(lineOf).join("\n")}\n`;
}
