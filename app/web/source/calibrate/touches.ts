// The touches made, the touches proposed, and the calibration computed from touches.
import {computed} from "@preact/signals";
import type {CalibrateDocument, FieldDocument, TouchesDocument, TouchList} from "../server/documents";
import {answerTo} from "../server/answers";
import {result, state} from "../server/workbench";
import {view} from "../shell/page_state";
import type {SheetModel} from "../sheet/sheet_model";

export const proposals = result<TouchesDocument>("touches"),
  outcome = result<CalibrateDocument>("calibrate"),
  field = result<FieldDocument>("field");
const list = answerTo<TouchList>({
  key: () => (state.value && view.value === "calibrate" ? `${state.value.revision} ${state.value.touches}` : null),
  path: () => "/api/touches",
  keeps: true,
});
export const touches = computed(() => list.value.document?.touches ?? []);

/** Returns the index of the hole with this name; -1 if the sheet has none. */
export function holeOf(model: SheetModel, point: string): number {
  const found = /R(\d+)\s*C(\d+)/.exec(point);
  return found ? model.find(Number(found[1]), Number(found[2])) : -1;
}
