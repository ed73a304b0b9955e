// The errors of the readings (measured minus predicted) before and after: the diagnosis with the chosen explanation,
// else the previous model and the current model, else the model as given and refitted.
import {causeKey} from "../../../drawing/explanations.js";
import {computed, effect, signal} from "@preact/signals";
import {AFTER, BEFORE} from "../../../drawing/kinds.js";
import {errorsOfExplanation, errorsOfRefit, type ErrorPair} from "../../../drawing/reading_errors.js";
import type {
  CompareDocument,
  ComparedReading,
  DiagnosedReading,
  DiagnoseDocument,
  ErrorReading,
  Model,
  Vector3,
} from "../server/documents";
import {answerTo} from "../server/answers";
import {currentModel, reporting, state} from "../server/workbench";
import {compare, currentDiagnosis} from "./loop";

export interface ReadingErrors extends ErrorPair<ErrorReading> {
  /** Error of each reading [sigmas], for the series before and after; undefined if unknown. */
  sigmas: (number | undefined)[][];
  /**
   * Size of each reading's error, for the series before and after, in the unit of its measured quantity (length or
   * angle).
   */
  sizes: (number | null)[][];
  sizeUnits: string[];
}

/** Index of the drawn explanation among the explanations of the diagnosis. */
export const chosenExplanation = signal(0);
effect(() => {
  void currentDiagnosis.value?.revision;
  chosenExplanation.value = 0;
});

// ---- comparison of the previous model

/**
 * The newest compared model below the current model on the stack; null if there is none or the current model was not
 * compared.
 */
const modelBefore = computed<Model | null>(() => {
  const now = state.value;
  if (!now) return null;
  const at = now.models.findIndex((model) => model.id === now.model);
  const compared = new Set(now.results.compare?.models ?? []);
  if (at < 1 || !compared.has(now.model)) return null;
  return now.models.slice(0, at).findLast((model) => compared.has(model.id)) ?? null;
});
const comparisonBefore = answerTo<CompareDocument>({
  key: () => (modelBefore.value ? `${modelBefore.value.id} ${state.value?.results.compare?.revision}` : ""),
  path: () => `/api/results/compare?model=${modelBefore.peek()!.id}`,
  onProblem: reporting("The model before"),
});

// ---- the errors

function lengthOf(error: Vector3 | null | undefined): number | null {
  return error ? Math.hypot(...error) : null;
}

function ofDiagnosis(document: DiagnoseDocument, index: number): ReadingErrors {
  const compared = compare.value.document;
  const known = new Map(
    compared?.model === document.model ? compared.readings.map((reading) => [reading.id, reading]) : [],
  );
  const before = document.readings.map((reading) => known.get(reading.id)?.sigmas_after);
  return {
    ...errorsOfExplanation(document, index),
    sigmas: [
      before,
      document.readings.map((reading, i) =>
        scaledSigmas(before[i], sizeBefore(reading), sizeExplained(reading, index)),
      ),
    ],
    sizes: [document.readings.map(sizeBefore), document.readings.map((reading) => sizeExplained(reading, index))],
    sizeUnits: document.readings.map((reading) => reading.size_unit ?? document.units.length),
  };
}

function sizeBefore(reading: DiagnosedReading): number | null {
  return reading.size_before === undefined ? lengthOf(reading.before) : reading.size_before;
}

function sizeExplained(reading: DiagnosedReading, index: number): number | null {
  return reading.size_explained === undefined
    ? lengthOf(reading.explained[index])
    : (reading.size_explained[index] ?? null);
}

/**
 * Returns the error in sigmas, scaled by the ratio of sizes `to` / `from`. This is accurate enough because sigma
 * depends little on the error's direction. Undefined if unknown.
 */
function scaledSigmas(sigmas: number | undefined, from: number | null, to: number | null): number | undefined {
  return sigmas === undefined || to === null || !(from! > 0) ? undefined : (sigmas * to) / from!;
}

/**
 * Returns sigmas, sizes and units of the readings in a comparison: before from another comparison, after from its own
 * refit.
 */
function comparedErrors(
  {readings}: CompareDocument,
  before: (Pick<ComparedReading, "size_after" | "sigmas_after"> | undefined)[],
): Pick<ReadingErrors, "sigmas" | "sizes" | "sizeUnits"> {
  return {
    sigmas: [before.map((reading) => reading?.sigmas_after), readings.map((reading) => reading.sigmas_after)],
    sizes: [before.map((reading) => reading?.size_after ?? null), readings.map((reading) => reading.size_after)],
    sizeUnits: readings.map((reading) => reading.size_unit),
  };
}

function placesOf({readings}: CompareDocument): (Vector3 | null)[] {
  return readings.map((reading) => reading.position_after ?? reading.measured ?? null);
}

function ofTwoModels(before: CompareDocument, now: CompareDocument, model: Model, earlier: Model): ReadingErrors {
  const known = new Map(before.readings.map((reading) => [reading.id, reading])),
    earlierOnes = now.readings.map(({id}) => known.get(id));
  const had = new Set(earlier.effects.map(causeKey));
  const seriesOf = (name: string, mark: ErrorPair["series"][number]["mark"], readings: typeof earlierOnes) => {
    return {name, mark, errors: readings.map((reading) => reading?.error_after ?? null)};
  };
  return {
    readings: now.readings,
    places: placesOf(now),
    series: [
      seriesOf(`before: ${earlier.label}, refitted`, BEFORE, earlierOnes),
      seriesOf(`after: ${model.label}`, AFTER, now.readings),
    ],
    joints: jointsOf(now),
    judged: 0,
    tested: 1,
    causes: model.effects.filter((own) => !had.has(causeKey(own))),
    ...comparedErrors(now, earlierOnes),
  };
}

function ofComparison(document: CompareDocument): ReadingErrors {
  const {readings} = document;
  return {
    ...errorsOfRefit(
      readings,
      placesOf(document),
      jointsOf(document),
      readings.map((reading) => reading.error_before),
      readings.map((reading) => reading.error_after),
      document.model === currentModel.value?.id ? "" : ", of the model before",
    ),
    ...comparedErrors(
      document,
      readings.map(({size_before, sigmas_before}) => ({size_after: size_before, sigmas_after: sigmas_before})),
    ),
  };
}

// ---- second explanation, drawn next to the main explanation

function drawnIndex(document: DiagnoseDocument): number {
  return Math.min(chosenExplanation.value, document.explanations.length - 1);
}

export const drawnExplanation = computed(() =>
  currentDiagnosis.value ? Math.max(0, drawnIndex(currentDiagnosis.value)) : 0,
);

/** Index of the explanation chosen manually: -1 for none; null to follow the verdict. */
const chosenSecond = signal<number | null>(null);
effect(() => {
  void currentDiagnosis.value?.revision;
  chosenSecond.value = null;
});

/**
 * Index of the explanation next to the drawn one: the chosen one, otherwise the next if the verdict is ambiguous; -1
 * for none.
 */
export const secondExplanation = computed(() => {
  const document = currentDiagnosis.value;
  if (!document || document.explanations.length < 2) return -1;
  const drawn = drawnIndex(document),
    wanted = chosenSecond.value ?? (document.verdict === "ambiguous" ? (drawn === 0 ? 1 : 0) : -1);
  return wanted === drawn || wanted >= document.explanations.length ? -1 : wanted;
});

export function chooseSecond(index: number): void {
  chosenSecond.value = index;
}

export const secondErrors = computed<ReadingErrors | null>(() => {
  const document = currentDiagnosis.value;
  return document && secondExplanation.value >= 0 ? ofDiagnosis(document, secondExplanation.value) : null;
});

function jointsOf(document: CompareDocument): string[] {
  return document.joint_columns.map((name) => name.replace(/_[^_]*$/, ""));
}

export const readingErrors = computed<ReadingErrors | null>(() => {
  const diagnosed = currentDiagnosis.value;
  if (diagnosed && diagnosed.readings.length > 0) return ofDiagnosis(diagnosed, drawnIndex(diagnosed));
  const compared = compare.value.document;
  if (!compared) return null;
  const earlier = modelBefore.value,
    before = comparisonBefore.value.document,
    model = currentModel.value;
  if (earlier && before && model && compared.model === model.id) return ofTwoModels(before, compared, model, earlier);
  return ofComparison(compared);
});
