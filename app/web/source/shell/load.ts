// Loading readings and cells. Readings are compared with the model as soon as they are here.
import type {WorkbenchState} from "../server/documents";
import {post, postText} from "../server/requests";
import {startCompare} from "../error/loop";
import {cell, report, runJob, takeState} from "../server/workbench";
import {askForColumns} from "./columns_dialog";
import {dialog, view} from "./page_state";
import {openInstead} from "./project";

async function afterReadings(): Promise<void> {
  dialog.value = "";
  view.value = "error";
  await startCompare();
}

/** One measurement table; else whatever another program wrote, in one file or in several that belong together. */
export async function loadFiles(files: File[]): Promise<void> {
  const names = files.map((file) => file.name).join(" and ");
  let refused: unknown = null;
  if (files.length === 1) {
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
