// The touches made, those proposed, and what came of them.
import {effect, signal} from "@preact/signals";
import type {CalibrateDocument, FieldDocument, TouchesDocument, TouchList} from "../server/documents";
import {get} from "../server/requests";
import {result, state} from "../server/workbench";
import {view} from "../shell/page_state";
import type {SheetModel} from "../sheet/sheet_model";

export const proposals = result<TouchesDocument>("touches"),
  outcome = result<CalibrateDocument>("calibrate"),
  field = result<FieldDocument>("field");
export const touches = signal<TouchList["touches"]>([]);

effect(() => {
  void state.value?.revision;
  if (state.value === null || view.value !== "calibrate") return;
  get<TouchList>("/api/touches").then(
    (list) => (touches.value = list.touches ?? []),
    () => (touches.value = []),
  );
});

/** The hole of a name, -1 where the sheet has none. */
export function holeOf(model: SheetModel, point: string): number {
  const found = /R(\d+)\s*C(\d+)/.exec(point);
  return found ? model.find(Number(found[1]), Number(found[2])) : -1;
}
