// Loading readings and cells. Readings are compared with the model as soon as they are here.
import {signal} from "@preact/signals";
import type {WorkbenchState} from "../server/documents";
import {post, postText} from "../server/requests";
import {startCompare, stopWorkOnReadings} from "../error/loop";
import {freshRows, idsHere, isFilledSheet, joinReadings} from "../error/run_sheet";
import {tableOf} from "../error/run_sheet_table";
import {cell, report, runJob, takeState} from "../server/workbench";
import {askForColumns} from "./columns_dialog";
import {dialog, view} from "./page_state";
import {openInstead} from "./project";

async function afterReadings(): Promise<void> {
  dialog.value = "";
  view.value = "error";
  await stopWorkOnReadings();
  await startCompare();
}

/** A run sheet that comes back: what is filled in and not here yet joins the readings. */
async function joinSheet(name: string, text: string): Promise<void> {
  const fresh = freshRows(text, await idsHere());
  view.value = "error";
  dialog.value = "";
  if (fresh !== "") await joinReadings(fresh);
  else report(name, {message: "No row of this run sheet is filled in, or all of them are here already."});
}

/** Whether a measurement table has readings of which none is here: it may join those that are, or take their place. */
async function hasOthers(text: string): Promise<boolean> {
  const here = await idsHere();
  const {columns, rows} = tableOf(text);
  const id = columns.indexOf("id");
  return (
    here.size > 0 && id >= 0 && columns.includes("kind") && rows.length > 0 && rows.every((row) => !here.has(row[id]))
  );
}

/** Readings that may join: their file's name and text. */
export const offered = signal<{name: string; text: string} | null>(null);

function offer(name: string, text: string): void {
  offered.value = {name, text};
  dialog.value = "join";
}

export async function joinOffered(): Promise<void> {
  const {text} = offered.peek()!;
  dialog.value = "";
  view.value = "error";
  await joinReadings(text);
}

export async function openOffered(): Promise<void> {
  const {name, text} = offered.peek()!;
  try {
    takeState(await postText<WorkbenchState>(`/api/measurements?name=${encodeURIComponent(name)}`, text));
  } catch (error) {
    report(`${name} cannot be read`, error);
    return;
  }
  await afterReadings();
}

/** One measurement table; else whatever another program wrote, in one file or in several that belong together. */
export async function loadFiles(files: File[]): Promise<void> {
  const names = files.map((file) => file.name).join(" and ");
  let refused: unknown = null;
  if (files.length === 1) {
    const text = await files[0].text();
    if (isFilledSheet(text)) return joinSheet(names, text);
    if (await hasOthers(text)) {
      offer(names, text);
      return;
    }
    try {
      takeState(await postText<WorkbenchState>(`/api/measurements?name=${encodeURIComponent(names)}`, files[0]));
      await afterReadings();
      return;
    } catch (error) {
      refused = error;
    }
  }
  try {
    await askForColumns(files, afterReadings);
    if (refused !== null) report(`${names} is no measurement table as it is`, refused);
  } catch (error) {
    report(`${names} cannot be read`, refused ?? error);
  }
}

export async function openReadings(file: string): Promise<void> {
  try {
    takeState(await post<WorkbenchState>("/api/measurements/open", {file}));
  } catch (error) {
    report(`${file} cannot be read`, error);
    return;
  }
  await afterReadings();
}

export function openCell(file: string): Promise<void> {
  return openInstead("/api/cell/open", {file}, file);
}

export function openProject(file: string): Promise<void> {
  return openInstead("/api/project/open", {file}, file);
}

export function openRecent(recent: string, name: string): Promise<void> {
  return openInstead("/api/project/open", {recent}, name);
}

export interface Practice {
  design: string;
  readings: number;
  hide: string[];
  seed: number;
}

export async function simulate(practice: Practice): Promise<void> {
  const spread = cell.value && cell.value.identify.length > 0 ? 0.1 : 0; // of the numbers that the cell sets free
  if (await runJob("Practice readings", "/api/simulate", {...practice, spread})) await afterReadings();
}
