// How far joints take the tip at the readings, asked of the program while errors are looked at: of every joint, and of
// the axes that the found causes turn.
import {computed, effect, signal} from "@preact/signals";
import type {EffectAt, LeverageDocument} from "../server/documents";
import {get, isMissing} from "../server/requests";
import {cell, currentModel, report, state} from "../server/workbench";
import {view} from "../shell/page_state";
import {diagnose} from "./loop";
import {turnedBy} from "../../../drawing/own_variable.js";

export const leverage = signal<LeverageDocument | null>(null);

const AXIS = /^[^,]+\.[xyz]$/;
const MOST_AXES = 4;

const names = computed(() => {
  const joints = cell.value?.joints.map((joint) => joint.name) ?? [];
  const causes: EffectAt[] = [
    ...(diagnose.value.document?.explanations.flatMap((explanation) => explanation.effects) ?? []),
    ...(currentModel.value?.effects ?? []),
  ];
  const axes = [...new Set(causes.map(turnedBy).filter((at) => AXIS.test(at)))];
  return [...joints, ...axes.slice(0, MOST_AXES)].join(",");
});

const key = computed(() => {
  const now = state.value;
  if (!now?.measurements || view.value !== "error") return "";
  return `${now.measurements.name} ${now.model} ${now.results.compare?.revision ?? -1} ${names.value}`;
});

let fetched = "";
effect(() => {
  const wanted = key.value;
  if (wanted === "" || wanted === fetched) return;
  fetched = wanted;
  get<LeverageDocument>(`/api/leverage?at=${encodeURIComponent(names.peek())}`).then(
    (found) => {
      if (fetched === wanted) leverage.value = found;
    },
    (error) => {
      if (fetched !== wanted) return;
      leverage.value = null;
      if (!isMissing(error)) report("The leverage of the joints", error);
    },
  );
});
