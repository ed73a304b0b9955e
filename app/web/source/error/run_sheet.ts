// A run sheet: the readings that a diagnosis proposes, as a measurement table in which what is measured is to be filled in.
// This browser keeps it, one for each cell, with what is ticked off and typed in, also when a new diagnosis says something
// else.
import {computed, effect, signal} from "@preact/signals";
import type {MeasurementsDocument} from "../server/documents";
import {get, postText} from "../server/requests";
import {attempt, cell, state} from "../server/workbench";
import {keep, keptObject} from "../shell/kept";
import {currentDiagnosis} from "./loop";
import {readingErrors} from "./residuals";
import {fillById, filledRows, lineOf, tableOf, type RunSheet} from "./run_sheet_table";

// ---- what is kept

const KEPT = "tubeplan.run-sheet";
const sheets = signal(keptObject<RunSheet>(KEPT));

export const runSheet = computed<RunSheet | null>(() => {
  const kept = sheets.value[cell.value?.file ?? ""];
  // An earlier program's does not say what is to be filled in, and may have predictions there.
  return kept && typeof kept.text === "string" && Array.isArray(kept.fill) ? kept : null;
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
    {rows} = tableOf(document.run_sheet),
    fill = readings.flatMap(({fill_in}) => (fill_in ? [fill_in] : []));
  if (fill.length !== rows.length) return;
  put({
    text: document.run_sheet,
    fill,
    ticked: [],
    typed: {},
    separations: readings.map((reading) => reading.separation_sigmas ?? null),
  });
});

/** Ids of the readings that are here, as far as their errors are drawn. */
export const takenIds = computed(() => new Set((readingErrors.value?.readings ?? []).map(({id}) => id)));

/** The same as the program has them now: the errors of readings that have just come are not here yet. None where it does
 * not answer, for what is asked next would not be answered either. */
export async function idsHere(): Promise<Set<string>> {
  if (!state.peek()?.measurements) return new Set();
  try {
    const {rows} = await get<MeasurementsDocument>("/api/measurements");
    return new Set(rows.map(({id}) => id));
  } catch {
    return new Set();
  }
}

// ---- given back

/** Readings that are new join those that are here; the comparison follows, and a diagnosis where there was one. */
export function joinReadings(text: string): Promise<boolean> {
  return attempt("Readings to join", () => postText("/api/live/readings", text));
}

/** Whether a table is this run sheet, filled in: its ids, none of which is here yet. */
export function isFilledSheet(text: string): boolean {
  const sheet = runSheet.peek();
  if (!sheet) return false;
  const own = new Set(tableOf(sheet.text).rows.map((row) => row[0]));
  const {columns, rows} = tableOf(text);
  return columns[0] === "id" && rows.length > 0 && rows.every((row) => own.has(row[0]));
}

/** Of a sheet that comes back: the rows that are not here yet and filled in, as far as they must be or at all. */
export function freshRows(text: string, here: ReadonlySet<string>, asFarAs: "whole" | "begun"): string {
  const sheet = runSheet.peek();
  const {columns, rows} = tableOf(sheet ? filledRows(text, fillById(sheet), asFarAs) : text);
  const fresh = rows.filter((row) => !here.has(row[0]));
  return fresh.length === 0 ? "" : `${[columns, ...fresh].map(lineOf).join("\n")}\n`;
}
