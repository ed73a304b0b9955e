// Loading of readings and cells. Readings are compared with the model as soon as they are loaded.
import {signal} from "@preact/signals";
import {areTouches} from "../calibrate/touch_readings";
import type {MeasurementsDocument, WorkbenchState} from "../server/documents";
import {asProblem, get, post, postText} from "../server/requests";
import {startCompare, stopWorkOnReadings} from "../error/loop";
import {freshRows, idsHere, isFilledSheet, JOINING, joinReadings} from "../error/run_sheet";
import {isOfRow, tableOf} from "../error/run_sheet_table";
import {attempt, cell, forget, report, runJob, state, takeState} from "../server/workbench";
import {openList, seemsToBeList} from "../plan/work_list";
import {chooseColumns, type ColumnsUse} from "./columns_dialog";
import {dialog, view} from "./page_state";
import {OPENING, openInstead} from "./project";
import {importRobot, isRobot} from "./robot";

function showErrors(): void {
  dialog.value = "";
  view.value = "error";
}

/** Returns true if the loaded readings are touches of the sheet's holes only. */
async function areTouchesOfHoles(): Promise<boolean> {
  const {measurements} = state.peek() ?? {};
  if (!cell.peek()?.has_sheet || measurements?.kinds.touch !== measurements?.readings) return false;
  return areTouches((await get<MeasurementsDocument>("/api/measurements")).rows);
}

/**
 * Shows the readings in their view: touches of holes calibrate a base, other readings show errors. Notices of earlier
 * failures to read a file are removed.
 */
async function afterReadings(): Promise<void> {
  for (const about of [OPENING, JOINING]) forget(about);
  showErrors();
  if (await areTouchesOfHoles().catch(() => false)) view.value = "calibrate";
  await stopWorkOnReadings();
  await startCompare();
}

/** Adds the new rows of a returned run sheet that are filled in to the readings. */
async function joinSheet(name: string, text: string): Promise<void> {
  // Partly filled rows are sent too, so that the program refuses them line by line.
  const fresh = freshRows(text, await idsHere(), "begun");
  showErrors();
  if (fresh !== "") await joinReadings(fresh);
  else report(name, {message: "No row of this run sheet is filled in, or all of them are here already."}, OPENING);
}

/** Returns the ids in a measurement table; null if the text is not a measurement table. */
function idsOf(text: string): string[] | null {
  const {columns, rows} = tableOf(text);
  const id = columns.indexOf("id");
  return id >= 0 && columns.includes("kind") && rows.length > 0 ? rows.map((row) => row[id]) : null;
}

/**
 * Returns true if readings are loaded and the files are measurement tables with new ids only, which may be added to the
 * loaded readings or replace them.
 */
async function haveOthers(texts: string[]): Promise<boolean> {
  const here = await idsHere(),
    ids = texts.map(idsOf);
  return here.size > 0 && ids.every((own) => own !== null && own.every((id) => !here.has(id)));
}

/** Texts of measurement tables whose readings may be added to the loaded readings, with the names of their files. */
export const offered = signal<{name: string; texts: string[]} | null>(null);

export async function joinOffered(): Promise<void> {
  const {texts} = offered.peek()!;
  showErrors();
  await joinAll(texts);
}

/** Adds the readings of the tables, one table after another, until one is refused. */
async function joinAll(texts: string[]): Promise<void> {
  for (const text of texts) if (!(await joinReadings(text))) return;
}

export async function openOffered(): Promise<void> {
  const {name, texts} = offered.peek()!;
  await attempt(`${name} cannot be read`, () => openTables(name, texts), OPENING);
}

/** Replaces the readings by the first table and appends the other tables. Throws if the first table is refused. */
async function openTables(name: string, [first, ...others]: string[]): Promise<void> {
  takeState(await postText<WorkbenchState>(`/api/measurements?name=${encodeURIComponent(name)}`, first));
  if (others.length === 0) return afterReadings();
  showErrors();
  await stopWorkOnReadings();
  await joinAll(others); // the program compares added readings automatically
}

const READINGS: ColumnsUse = {
  address: "/api/measurements/columns",
  needsNoise: true,
  take: async ({options, ...taken}) =>
    takeState(await post<WorkbenchState>("/api/measurements/foreign", {...taken, ...options})),
  then: afterReadings,
};

/**
 * Loads a robot description, measurement tables or a work list; otherwise tables of another program, in one file or in
 * several files that belong together.
 */
export async function loadFiles(files: File[]): Promise<void> {
  const names = files.map((file) => file.name).join(" and ");
  forget(OPENING);
  if (files.some(({name}) => /\.(ya?ml|tubeplan)$/i.test(name))) {
    const advice = "A cell or a project is opened from the folder: O.";
    return report(names, {message: "This is not a table of readings.", advice}, OPENING);
  }
  const tables = await Promise.all(files.map(async (file) => ({name: file.name, text: await file.text()}))),
    texts = tables.map(({text}) => text);
  if (tables.length === 1 && isRobot(tables[0])) return importRobot(tables[0]);
  let refused: unknown = null;
  if (texts.length === 1 && isFilledSheet(texts[0])) return joinSheet(names, texts[0]);
  if (texts.length === 1 && idsOf(texts[0]) === null && (await seemsToBeList(tables[0]))) return openList(tables[0]);
  if (await haveOthers(texts)) {
    offered.value = {name: names, texts};
    dialog.value = "join";
    return;
  }
  if (texts.length === 1 || texts.every((text) => idsOf(text) !== null)) {
    try {
      return await openTables(names, texts);
    } catch (error) {
      refused = error;
      // The columns of a measurement table are known, so the dialog for columns is not needed.
      if (idsOf(texts[0]) !== null && isOfRow(asProblem(error).where, texts[0]))
        return report(`${names} cannot be read`, error, OPENING);
    }
  }
  try {
    await chooseColumns(tables, READINGS);
  } catch (error) {
    report(`${names} cannot be read`, refused ?? error, OPENING);
  }
}

export async function openReadings(file: string): Promise<void> {
  const open = async () => takeState(await post<WorkbenchState>("/api/measurements/open", {file}));
  if (await attempt(`${file} cannot be read`, open, OPENING)) await afterReadings();
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

interface Practice {
  design: string;
  readings: number;
  hide: string[];
  seed: number;
}

export async function simulate(practice: Practice): Promise<void> {
  const spread = cell.value && cell.value.identify.length > 0 ? 0.1 : 0; // spread of the cell's free parameters
  if (await runJob("Practice readings", "/api/simulate", {...practice, spread})) await afterReadings();
}
