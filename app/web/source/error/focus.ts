// What the plot of the errors opens on: where the chosen cause shows, else what the pattern search found, else what the
// unexplained remainder follows. A choice by hand holds until other errors are shown.
import {computed, effect, signal} from "@preact/signals";
import type {Vector3} from "../server/documents";
import {cell, units} from "../server/workbench";
import {leverage} from "./leverage";
import {compare, currentDiagnosis} from "./loop";
import {moments} from "./moments";
import {followedShare, viewOfCauses, type View} from "./own_variable";
import {findPart, jointKey, partsOf, type Part} from "./parts";
import {errorsBeside, readingErrors, type ReadingErrors} from "./residuals";
import {findVariable, variablesOf, type Variable} from "../../../drawing/variables.js";

export const variables = computed<Variable[]>(() => {
  const errors = readingErrors.value;
  if (!errors) return [];
  const joints = errors.joints.map((name, k) => ({name, unit: cell.value?.joints[k]?.unit}));
  const {readings, places} = errors;
  return variablesOf(
    {readings, joints, places},
    units.value as unknown as Record<string, string | undefined>,
    moments.value,
  );
});

export const parts = computed<Part[]>(() => {
  const errors = readingErrors.value;
  if (!errors) return [];
  return partsOf({
    ids: errors.readings.map((reading) => reading.id),
    places: errors.places,
    unit: units.value,
    leverage: leverage.value,
  });
});

/** What the causes take away from the error at each reading. */
export function doneBy(errors: ReadingErrors): (Vector3 | null)[] {
  const [before, after] = errors.series.map((series) => series.errors);
  return before.map((from, i) => {
    const to = after?.[i];
    return from && to ? [from[0] - to[0], from[1] - to[1], from[2] - to[2]] : null;
  });
}

/** The part of an error that follows a variable most. */
function partFollowing(variable: Variable, errors: ReadingErrors, among: readonly Part[]): Part {
  const xs = errors.readings.map((reading, i) => variable.of(reading, i));
  const shares = among
    .filter((part) => part.isSigned)
    .map((part) => ({
      part,
      share: followedShare(
        xs,
        errors.series[errors.judged].errors.map((error, i) => (error ? part.of(error, i) : null)),
      ),
    }));
  return shares.reduce((best, entry) => (entry.share > best.share + 0.02 ? entry : best), {part: among[0], share: 0})
    .part;
}

function viewOfPattern(): View | null {
  const drawn = (compare.value.document?.patterns ?? []).flatMap((pattern) => {
    const variable = findVariable(pattern.variable, variables.value);
    return variable
      ? [{variable, part: findPart(pattern.frame, pattern.component, parts.value) ?? parts.value[0]}]
      : [];
  });
  // A point is a name, not a measure: what else was found says more.
  return drawn.find((view) => view.variable.kind !== "point") ?? drawn[0] ?? null;
}

function viewOfRemainder(errors: ReadingErrors): View | null {
  const follows = currentDiagnosis.value?.remainder?.follows ?? [];
  const variable = findVariable(follows[0]?.variable, variables.value);
  return variable ? {variable, part: partFollowing(variable, errors, parts.value)} : null;
}

export const suggestedView = computed<View | null>(() => {
  const errors = readingErrors.value;
  if (!errors || variables.value.length === 0) return null;
  const ofCause =
    errors.causes.length > 0
      ? viewOfCauses(errors.causes, doneBy(errors), errors.readings, variables.value, parts.value)
      : null;
  return ofCause ?? viewOfRemainder(errors) ?? viewOfPattern() ?? {variable: variables.value[0], part: parts.value[0]};
});

/** A law to begin with where no known effect explains the error: an error of the joint that follows the variable most. */
export const suggestedFormula = computed(() => {
  const errors = readingErrors.value,
    view = suggestedView.value;
  if (!errors || !view) return "";
  const joints = parts.value.filter((part) => errors.joints.some((name) => part.key === jointKey(name)));
  if (joints.length === 0) return "";
  const target = joints.includes(view.part) ? view.part : partFollowing(view.variable, errors, joints);
  return `${target.key.replace("as ", "")} += ${lawOf(view.variable)}`;
});

function lawOf({key, kind}: Variable): string {
  return kind === "joint" ? `c*sin(${key}) + d*cos(${key})` : `c*${key}`;
}

/** Where the explanation that stands beside the drawn one shows. */
export const viewBeside = computed<View | null>(() => {
  const errors = errorsBeside.value;
  if (!errors) return null;
  const own =
    errors.causes.length > 0
      ? viewOfCauses(errors.causes, doneBy(errors), errors.readings, variables.value, parts.value)
      : null;
  return own ?? suggestedView.value;
});

// ---- a choice by hand

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
