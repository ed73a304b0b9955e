// The readings' errors as series to draw, from the diagnosis of the current model, else from the comparison.
import {computed} from "@preact/signals";
import type {Mark} from "../drawing/marks";
import type {ErrorReading, Vector3} from "../server/documents";
import {state} from "../server/workbench";
import {currentDiagnosis, compare} from "./loop";
import {explanationTitle, isEnough} from "./words";

export interface ErrorSeries {
  name: string;
  mark: Mark;
  errors: (Vector3 | null)[];
}

export interface ReadingErrors {
  readings: ErrorReading[];
  places: (Vector3 | null)[];
  series: ErrorSeries[];
  joints: string[];
}

const BEFORE: Mark = {shape: "triangle", colour: "case0"};
const AFTER: Mark = {shape: "disc", colour: "accent"};

export const readingErrors = computed<ReadingErrors | null>(() => {
  const diagnosed = currentDiagnosis.value;
  if (diagnosed) {
    const first = diagnosed.explanations[0];
    const series: ErrorSeries[] = [
      {name: "refitted, no effect", mark: BEFORE, errors: diagnosed.readings.map((reading) => reading.before)},
    ];
    if (first)
      series.push({
        name: `with ${isEnough(first) ? "" : "the closest, "}${explanationTitle(first)}`,
        mark: AFTER,
        errors: diagnosed.readings.map((reading) => reading.after),
      });
    return {
      readings: diagnosed.readings,
      places: diagnosed.readings.map((reading) => reading.position),
      series,
      joints: diagnosed.joints.map((joint) => joint.name),
    };
  }
  const compared = compare.value.document;
  if (!compared) return null;
  const when = compared.model === state.value?.model ? "" : ", before the last change";
  return {
    readings: compared.readings,
    places: compared.readings.map((reading) => reading.position_after ?? reading.measured ?? null),
    series: [
      {
        name: `as the model stands${when}`,
        mark: BEFORE,
        errors: compared.readings.map((reading) => reading.error_before),
      },
      {name: `refitted${when}`, mark: AFTER, errors: compared.readings.map((reading) => reading.error_after)},
    ],
    joints: compared.joint_columns.map((name) => name.replace(/_[^_]*$/, "")),
  };
});
