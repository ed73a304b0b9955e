// State of this browser only: the view, the picked hole, the selected holes and their dwell times, dialogs. The view,
// the selection and the dwell times survive a reload.
import {computed, effect, signal} from "@preact/signals";
import {sheetDocument, state} from "../server/workbench";
import {toggled} from "../drawing/fields";
import {makeSheetModel} from "../../../drawing/sheet_model.js";

/**
 * The views in the order of the work: look at sheet and arm, find the base, correct the model, plan, visit. `needs`:
 * part that a cell must have for the view to be of use.
 */
export const VIEWS = [
  {name: "sheet", words: "Sheet", needs: "sheet"},
  {name: "arm", words: "Arm", needs: "arm"},
  {name: "calibrate", words: "Calibrate", needs: "sheet"},
  {name: "error", words: "Error", needs: "arm"},
  {name: "effects", words: "Effects", needs: "arm"},
  {name: "plan", words: "Plan", needs: "sheet"},
  {name: "outage", words: "Outage", needs: "records"},
] as const;
export type ViewName = (typeof VIEWS)[number]["name"];

function viewOfAddress(): ViewName {
  const name = location.hash.slice(1);
  return VIEWS.find((entry) => entry.name === name)?.name ?? "sheet";
}

export const view = signal<ViewName>(viewOfAddress());

// An address without a view opens a view with content: the error view if there are readings, otherwise the sheet view
// if there is a sheet.
let isOpened = location.hash !== "";
effect(() => {
  if (isOpened || !state.value) return;
  isOpened = true;
  if (state.value.measurements || !state.value.cell.has_sheet) view.value = "error";
});
window.addEventListener("hashchange", () => (view.value = viewOfAddress()));
effect(() => {
  if (viewOfAddress() !== view.value) location.hash = view.value;
});

export type DialogName = "open" | "keys" | "practice" | "save" | "unsaved" | "columns" | "join" | "choice";
export const dialog = signal<"" | DialogName>("");

/** Closes the dialog of this name, not one opened since then: a browser reports a closing with a delay. */
export function closeDialog(name: DialogName): void {
  if (dialog.value === name) dialog.value = "";
}

/** The sheet of the cell as a model for drawing; null without a sheet. */
export const sheet = computed(() => {
  const document = sheetDocument.value.document;
  return document ? makeSheetModel(document) : null;
});

// ---- selection

const KEPT = "tubeplan.selection",
  KEPT_DWELL_TIMES = "tubeplan.stays";

function keptList(key: string): unknown[] {
  try {
    const kept = JSON.parse(sessionStorage.getItem(key) ?? "[]");
    return Array.isArray(kept) ? kept : [];
  } catch {
    return [];
  }
}

const isHole = (entry: unknown): entry is number => Number.isInteger(entry);
const isDwellTime = (entry: unknown): entry is [number, number] =>
  Array.isArray(entry) && isHole(entry[0]) && typeof entry[1] === "number";

export const selection = signal<ReadonlySet<number>>(new Set(keptList(KEPT).filter(isHole)));
/** Dwell time at each hole [s], keyed by tube index, from the work list opened last. */
export const dwellTimes = signal<ReadonlyMap<number, number>>(new Map(keptList(KEPT_DWELL_TIMES).filter(isDwellTime)));
export const picked = signal(-1);

/** Dwell times of those selected holes that have one, in the form for the server. */
export const dwellTimesOfSelection = computed(() =>
  Object.fromEntries([...dwellTimes.value].filter(([hole]) => selection.value.has(hole))),
);

effect(() => sessionStorage.setItem(KEPT, JSON.stringify([...selection.value])));
effect(() => sessionStorage.setItem(KEPT_DWELL_TIMES, JSON.stringify([...dwellTimes.value])));

// Selected holes are indices in one sheet, so another sheet begins without a selection.
let sheetName = "";
effect(() => {
  if (!sheet.value) return;
  const name = `${sheet.value.name} ${sheet.value.leg} ${sheet.value.count}`;
  if (sheetName !== "" && sheetName !== name) {
    forgetHoles();
    picked.value = -1;
  }
  sheetName = name;
  if ([...selection.peek()].some((hole) => hole >= sheet.value!.count)) forgetHoles();
});

function forgetHoles(): void {
  selection.value = new Set();
  dwellTimes.value = new Map();
}

export function toggleSelected(hole: number): void {
  selection.value = toggled(selection.value, hole);
}

export function select(holes: Iterable<number>, isMore = false): void {
  selection.value = new Set(isMore ? [...selection.value, ...holes] : holes);
}
