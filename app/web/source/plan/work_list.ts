// A work list from a file: its tubes become the selection, with their dwell times, and excluded tubes are reported.
// Unrecognized headings open the dialog for columns.
import type {ListColumnsDocument} from "../shell/columns_choice";
import {chooseColumns, type ColumnsUse, type TableText} from "../shell/columns_dialog";
import {dwellTimes, selection, view} from "../shell/page_state";
import {OPENING} from "../shell/project";
import {post} from "../server/requests";
import {cell, inform, report} from "../server/workbench";

interface WorkListDocument {
  name: string;
  tubes: number[];
  /** Dwell time at each tube [s], keyed by tube index. */
  stays: Record<string, number>;
  notes: string[];
}

const COLUMNS = "/api/tubes/columns";

async function takeList(list: TableText, columns: string[] = []): Promise<void> {
  const {name, tubes, notes, stays: own} = await post<WorkListDocument>("/api/tubes", {...list, columns});
  dwellTimes.value = new Map(Object.entries(own).map(([tube, seconds]) => [Number(tube), seconds]));
  selection.value = new Set(tubes);
  if (notes.length > 0) inform(name, notes.join("; "), OPENING);
}

const LIST: ColumnsUse = {
  address: COLUMNS,
  needsNoise: false,
  take: ({tables: [list], columns}) => takeList(list, columns),
  then: async () => {
    view.value = "plan";
  },
};

/**
 * Returns true if a table is a work list: its headings name tubes, or it was opened as a list and its headings name no
 * joints.
 */
export async function seemsToBeList(table: TableText): Promise<boolean> {
  if (!cell.value?.has_sheet) return false;
  try {
    const {states} = await post<ListColumnsDocument>(COLUMNS, {tables: [table]});
    return states === "tubes" || (states === "neither" && view.value === "plan");
  } catch {
    return false; // not a table; the reason is reported when it is opened as readings
  }
}

export async function openList(list: TableText): Promise<void> {
  try {
    await takeList(list);
    await LIST.then();
  } catch (error) {
    await chooseColumnsAfter(list, error);
  }
}

/** Opens the dialog for column meanings, unless all headings are known and the list was rejected for another reason. */
async function chooseColumnsAfter(list: TableText, refused: unknown): Promise<void> {
  try {
    const document = await post<ListColumnsDocument>(COLUMNS, {tables: [list]});
    if (document.is_understood) throw refused;
    await chooseColumns([list], LIST);
  } catch {
    report(`${list.name} cannot be read`, refused, OPENING);
  }
}
