// A run sheet: the readings proposed by a diagnosis, as a measurement table with fields for the measured values. This
// browser stores one sheet for each cell, with ticks and typed values, even if a new diagnosis differs.
import {computed, effect, signal} from "@preact/signals";
import type {MeasurementsDocument} from "../server/documents";
import {get, postText} from "../server/requests";
import {attempt, cell, state} from "../server/workbench";
import {keep, keptObject} from "../shell/kept";
import {currentDiagnosis} from "./loop";
import {readingErrors} from "./residuals";
import {fillById, filledRows, lineOf, tableOf, type RunSheet} from "./run_sheet_table";

// ---- storage of run sheets in the browser

const KEPT = "tubeplan.run-sheet";
const sheets = signal(keptObject<RunSheet>(KEPT));

export const runSheet = computed<RunSheet | null>(() => {
  const kept = sheets.value[cell.value?.file ?? ""];
  // A sheet stored by an earlier version lacks the fields to fill in, and may contain predictions there.
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

// A new diagnosis with other proposals replaces a sheet that is untouched or complete.
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

/** Ids of the current readings for which errors are drawn. */
export const takenIds = computed(() => new Set((readingErrors.value?.readings ?? []).map(({id}) => id)));

/**
 * Returns the ids of all readings in the program, including readings without errors yet. Returns an empty set if the
 * program does not answer, because the next request would also fail.
 */
export async function idsHere(): Promise<Set<string>> {
  if (!state.peek()?.measurements) return new Set();
  try {
    const {rows} = await get<MeasurementsDocument>("/api/measurements");
    return new Set(rows.map(({id}) => id));
  } catch {
    return new Set();
  }
}

// ---- return of readings

/** Title of notices of readings that could not be added. */
export const JOINING = "Readings to join";

/** Adds new readings to the current readings, compares, and diagnoses if there was a diagnosis. */
export function joinReadings(text: string): Promise<boolean> {
  return attempt(JOINING, () => postText("/api/live/readings", text));
}

/** Returns true if a table is a measurement table whose ids all belong to this run sheet. */
export function isFilledSheet(text: string): boolean {
  const sheet = runSheet.peek();
  if (!sheet) return false;
  const own = new Set(tableOf(sheet.text).rows.map((row) => row[0]));
  const {columns, rows} = tableOf(text);
  return columns[0] === "id" && rows.length > 0 && rows.every((row) => own.has(row[0]));
}

/**
 * Returns the rows of a returned sheet that are filled in, completely ("whole") or at least partly ("begun"), and whose
 * ids are not in `here`; without a stored sheet, all rows are treated as filled in.
 */
export function freshRows(text: string, here: ReadonlySet<string>, asFarAs: "whole" | "begun"): string {
  const sheet = runSheet.peek();
  const {columns, rows} = tableOf(sheet ? filledRows(text, fillById(sheet), asFarAs) : text);
  const fresh = rows.filter((row) => !here.has(row[0]));
  return fresh.length === 0 ? "" : `${[columns, ...fresh].map(lineOf).join("\n")}\n`;
}
