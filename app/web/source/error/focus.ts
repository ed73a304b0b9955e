// Initial view of the error plot: the variable of the chosen cause, else the variable that the unexplained residual
// follows, else the finding of the pattern search. A manual choice is kept until other errors are shown.
import {computed, effect, signal} from "@preact/signals";
import {cell, units} from "../server/workbench";
import {leverage} from "./leverage";
import {compare, currentDiagnosis} from "./loop";
import {moments} from "./moments";
import {readingErrors, secondErrors} from "./residuals";
import {partsOf, type Part} from "../../../drawing/error_parts.js";
import type {View} from "../../../drawing/own_variable.js";
import {
  jointParts,
  partFollowing,
  viewOfPair,
  viewOfPatterns,
  viewOfRemainder,
} from "../../../drawing/reading_errors.js";
import {findVariable, variablesOf, type Variable} from "../../../drawing/variables.js";

export const variables = computed<Variable[]>(() => {
  const errors = readingErrors.value;
  if (!errors) return [];
  const joints = errors.joints.map((name, k) => ({name, unit: cell.value?.joints[k]?.unit}));
  const {readings, places} = errors;
  return variablesOf({readings, joints, places}, units.value, moments.value.document);
});

export const parts = computed<Part[]>(() => {
  const errors = readingErrors.value;
  if (!errors) return [];
  return partsOf({
    ids: errors.readings.map((reading) => reading.id),
    places: errors.places,
    unit: units.value,
    leverage: leverage.value.document,
  });
});

export const suggestedView = computed<View | null>(() => {
  const errors = readingErrors.value;
  if (!errors || variables.value.length === 0) return null;
  return (
    viewOfPair(errors, variables.value, parts.value) ??
    viewOfRemainder(currentDiagnosis.value, errors, variables.value, parts.value) ??
    viewOfPatterns(compare.value.document?.patterns ?? [], variables.value, parts.value) ?? {
      variable: variables.value[0],
      part: parts.value[0],
    }
  );
});

/** Kinds of variables that no formula can name. */
const OUTSIDE_FORMULAS = new Set(["position", "set-up", "point", "order"]);

/**
 * Formula suggested if no known effect explains the error: an error of one joint as a function of the drawn variable, or
 * of the first one that a formula can name. The joint is the one whose equivalent error follows this variable best.
 */
export const suggestedFormula = computed(() => {
  const errors = readingErrors.value,
    view = suggestedView.value;
  if (!errors || !view) return "";
  const joints = jointParts(errors, parts.value);
  const variable = [view.variable, ...variables.value].find(({kind}) => !OUTSIDE_FORMULAS.has(kind));
  if (joints.length === 0 || !variable) return "";
  const target = joints.includes(view.part) ? view.part : partFollowing(variable, errors, joints);
  return `${target.key.replace("as ", "")} += ${lawOf(variable)}`;
});

function lawOf({key, kind}: Variable): string {
  return kind === "joint" ? `c*sin(${key}) + d*cos(${key})` : `c*${key}`;
}

/**
 * Formula suggested for the remainder of an explanation: an error of the joint that follows the first variable
 * which a formula can name; empty if there is none.
 */
export const remainderFormula = computed(() => {
  const errors = readingErrors.value;
  const followed = (currentDiagnosis.value?.remainder?.follows ?? [])
    .map(({variable}) => findVariable(variable, variables.value))
    .find((variable) => variable && !OUTSIDE_FORMULAS.has(variable.kind));
  const joints = errors ? jointParts(errors, parts.value) : [];
  if (!errors || !followed || joints.length === 0) return "";
  const target = partFollowing(followed, {...errors, judged: errors.series.length - 1}, joints);
  return `${target.key.replace("as ", "")} += ${lawOf(followed)}`;
});

/** View of the explanation drawn next to the main explanation; null if there is none. */
export const secondView = computed<View | null>(() => {
  const errors = secondErrors.value;
  return errors ? (viewOfPair(errors, variables.value, parts.value) ?? suggestedView.value) : null;
});

// ---- manual choice

export const chosenVariable = signal("");
export const chosenPart = signal("");

const shown = computed(() => {
  const errors = readingErrors.value;
  return errors ? errors.series.map((series) => series.name).join("|") : "";
});
effect(() => {
  void shown.value;
  chosenVariable.value = chosenPart.value = "";
});

export const shownView = computed<View | null>(() => {
  const suggested = suggestedView.value;
  if (!suggested) return null;
  return {
    variable: variables.value.find((entry) => entry.key === chosenVariable.value) ?? suggested.variable,
    part: parts.value.find((entry) => entry.key === chosenPart.value) ?? suggested.part,
  };
});
