// A run sheet: the readings that a diagnosis proposes, as a measurement table whose coordinates are to be filled in. This
// browser keeps it, one for each cell, with what is ticked off and typed in, also when a new diagnosis says something else.
import {computed, effect, signal} from "@preact/signals";
import {postText} from "../server/requests";
import {cell, report} from "../server/workbench";
import {keep, keptObject} from "../shell/kept";
import {currentDiagnosis} from "./loop";
import {readingErrors} from "./residuals";

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

export function tableOf(text: string): RunSheetTable {
  const lines = text.split(/\r?\n/).filter((line) => line.trim() !== "" && !line.startsWith("#"));
  const [columns = [], ...rows] = lines.map(fieldsOf);
  return {columns, rows};
}

function lineOf(fields: readonly string[]): string {
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

// ---- what is kept

const KEPT = "tubeplan.run-sheet";
const sheets = signal(keptObject<RunSheet>(KEPT));

export const runSheet = computed<RunSheet | null>(() => {
  const kept = sheets.value[cell.value?.file ?? ""];
  return kept && typeof kept.text === "string" ? kept : null;
});

function put(sheet: RunSheet | null): void {
  const {[cell.peek()?.file ?? ""]: _, ...others} = sheets.peek();
  sheets.value = sheet ? {...others, [cell.peek()!.file]: sheet} : others;
  keep(KEPT, sheets.peek());
}

export function change(by: Partial<RunSheet>): void {
  const sheet = runSheet.peek();
  if (sheet) put({...sheet, ...by});
}

export function putRunSheetAway(): void {
  put(null);
}

// A new diagnosis with other proposals replaces a sheet on which nothing was done yet, or all.
effect(() => {
  const document = currentDiagnosis.value;
  if (!document?.run_sheet || !cell.value) return;
  const sheet = runSheet.peek();
  if (sheet?.text === document.run_sheet) return;
  const isBegun = sheet !== null && (sheet.ticked.length > 0 || Object.keys(sheet.typed).length > 0);
  const isDone = sheet !== null && tableOf(sheet.text).rows.every((row) => takenIds.peek().has(row[0]));
  if (isBegun && !isDone) return;
  const readings = document.next_readings,
    {rows} = tableOf(document.run_sheet);
  put({
    text: document.run_sheet,
    ticked: [],
    typed: {},
    separations: readings.length === rows.length ? readings.map((reading) => reading.separation_sigmas ?? null) : [],
  });
});

/** Ids of the readings that are here. */
export const takenIds = computed(() => new Set((readingErrors.value?.readings ?? []).map(({id}) => id)));

// ---- given back

/** Readings that are new join those that are here; the comparison follows, and a diagnosis where there was one. */
export async function joinReadings(text: string): Promise<boolean> {
  try {
    await postText("/api/live/readings", text);
    return true;
  } catch (error) {
    report("Readings to join", error);
    return false;
  }
}

/** Whether a table is this run sheet, filled in: its ids, none of which is here yet. */
export function isFilledSheet(text: string): boolean {
  const sheet = runSheet.peek();
  if (!sheet) return false;
  const own = new Set(tableOf(sheet.text).rows.map((row) => row[0]));
  const {columns, rows} = tableOf(text);
  return columns[0] === "id" && rows.length > 0 && rows.every((row) => own.has(row[0]));
}

/** Of a sheet that comes back: the rows that are filled in and not here yet. */
export function freshRows(text: string): string {
  const sheet = runSheet.peek();
  const {columns, rows} = tableOf(sheet ? filledRows(text, openColumns(tableOf(sheet.text))) : text);
  const fresh = rows.filter((row) => !takenIds.peek().has(row[0]));
  return fresh.length === 0 ? "" : `${[columns, ...fresh].map(lineOf).join("\n")}\n`;
}
