// Loading readings and cells. Readings are compared with the model as soon as they are here.
import type {WorkbenchState} from "../server/documents";
import {post, postText} from "../server/requests";
import {startCompare} from "../error/loop";
import {cell, report, runJob, takeState} from "../server/workbench";
import {dialog, view} from "./page_state";
import {openInstead} from "./project";

async function afterReadings(): Promise<void> {
  dialog.value = "";
  view.value = "error";
  await startCompare();
}

export async function loadFile(file: File): Promise<void> {
  try {
    takeState(await postText<WorkbenchState>(`/api/measurements?name=${encodeURIComponent(file.name)}`, file));
  } catch (error) {
    report(`${file.name} cannot be read`, error);
    return;
  }
  await afterReadings();
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
