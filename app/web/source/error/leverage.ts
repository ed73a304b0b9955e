// Leverage on the tip at each reading, requested while errors are shown: of all joints, and of the axes on which the
// found causes act.
import {computed} from "@preact/signals";
import type {EffectAt, LeverageDocument} from "../server/documents";
import {answerTo} from "../server/answers";
import {cell, currentModel, reporting} from "../server/workbench";
import {diagnose} from "./loop";
import {readingsKey} from "./moments";
import {turnedBy} from "../../../drawing/own_variable.js";

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

export const leverage = answerTo<LeverageDocument>({
  key: () => {
    const key = readingsKey();
    return key && `${key} ${names.value}`;
  },
  path: () => `/api/leverage?at=${encodeURIComponent(names.peek())}`,
  keeps: true,
  onProblem: reporting("The leverage of the joints"),
});
