// A run sheet as a table: what is to be filled in, and what has been.

export interface RunSheet {
  text: string;
  /** Ids of readings that were taken, by the hand that ticks them off. */
  ticked: string[];
  /** Typed in: for each id the fields that were empty, by column. */
  typed: Record<string, Record<string, string>>;
  /** How far each reading sets the explanations apart, in sigmas, where that is known. */
  separations: (number | null)[];
}

export interface RunSheetTable {
  columns: string[];
  rows: string[][];
}

/** The fields of a line; quotes as in CSV. */
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

/** Whether what is refused is a row of a table, by its line, and not the columns. */
export function isOfRow(where: string | undefined, text: string): boolean {
  const line = Number(/:(\d+)/.exec(where ?? "")?.[1]);
  const heading = text.split("\n").findIndex(hasFields) + 1;
  return line > heading;
}

export function lineOf(fields: readonly string[]): string {
  return fields.map((field) => (/[",]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field)).join(",");
}

const COORDINATES = /^([xyz]|distance|tool_[xyz])_|^steps/;

/** Columns that somebody must fill in: coordinates that no row has. */
export function openColumns({columns, rows}: RunSheetTable): string[] {
  return columns.filter((column, k) => COORDINATES.test(column) && rows.every((row) => (row[k] ?? "") === ""));
}

/** The rows of a filled sheet whose open columns are all filled; "" where there is none. */
export function filledRows(text: string, open: readonly string[]): string {
  const {columns, rows} = tableOf(text);
  const at = open.map((column) => columns.indexOf(column));
  const filled = rows.filter((row) => at.every((k) => k >= 0 && (row[k] ?? "") !== ""));
  return filled.length === 0 ? "" : `${[columns, ...filled].map(lineOf).join("\n")}\n`;
}

/** The sheet with what was typed in. */
export function withTyped({text, typed}: RunSheet): string {
  const {columns, rows} = tableOf(text);
  const filled = rows.map((row) => row.map((field, k) => typed[row[0]]?.[columns[k]]?.trim() || field));
  return `${[columns, ...filled].map(lineOf).join("\n")}\n`;
}
