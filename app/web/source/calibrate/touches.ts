// The touches made, the touches proposed, and the calibration computed from touches.
import {computed} from "@preact/signals";
import type {
  CalibrateDocument,
  FieldDocument,
  MeasurementsDocument,
  TouchesDocument,
  TouchList,
} from "../server/documents";
import {answerTo} from "../server/answers";
import {result, state} from "../server/workbench";
import {sheet, view} from "../shell/page_state";
import type {SheetModel} from "../sheet/sheet_model";
import {touchesAmong} from "./touch_readings";

export const proposals = result<TouchesDocument>("touches"),
  outcome = result<CalibrateDocument>("calibrate"),
  field = result<FieldDocument>("field");
const list = answerTo<TouchList>({
  key: () => (state.value && view.value === "calibrate" ? `${state.value.revision} ${state.value.touches}` : null),
  path: () => "/api/touches",
  keeps: true,
});
const readings = answerTo<MeasurementsDocument>({
  key: () => {
    const {measurements, cell, model} = state.value ?? {};
    if (view.value !== "calibrate") return null;
    return measurements?.kinds.touch ? `${cell?.file} ${measurements.name} ${measurements.change} ${model}` : "";
  },
  path: () => "/api/measurements",
  keeps: true,
});
const entered = computed(() => list.value.document?.touches ?? []);

/** Touches of holes among the readings in use. The program calibrates from them if no touch has been entered here. */
export const touchReadings = computed(() =>
  entered.value.length > 0 ? [] : touchesAmong(readings.value.document?.rows ?? []),
);
/** Touches of which the base is calibrated: those entered here, otherwise those among the readings. */
export const touches = computed<TouchList["touches"]>(() => {
  const model = sheet.value;
  const listed = touchReadings.value.map(({id, point, joints}) => ({
    id,
    hole: model ? holeOf(model, point) : -1,
    joints,
  }));
  return listed.length > 0 ? listed : entered.value;
});

/** Returns the index of the hole with this name; -1 if the sheet has none. */
export function holeOf(model: SheetModel, point: string): number {
  const found = /R(\d+)\s*C(\d+)/.exec(point);
  return found ? model.find(Number(found[1]), Number(found[2])) : -1;
}
