// The calibration loop as requests to the program: compare, diagnose, add, and the page's automatic steps between them.
import {computed, effect} from "@preact/signals";
import type {
  CompareDocument,
  DiagnoseDocument,
  EffectAt,
  IdentifyDocument,
  LadderDocument,
  WorkbenchState,
} from "../server/documents";
import {ServerProblem} from "../server/requests";
import {attempt, report, result, runJob, runningJobs, startJob, state, stopJobs, takeState} from "../server/workbench";

export const compare = result<CompareDocument>("compare");
export const diagnose = result<DiagnoseDocument>("diagnose");
export const identify = result<IdentifyDocument>("identify");
export const ladder = result<LadderDocument>("ladder");

/** Diagnosis of the present model; those of other models are kept but not shown. */
export const currentDiagnosis = computed(() => {
  const document = diagnose.value.document;
  return document && document.model === state.value?.model ? document : null;
});
export const currentComparison = computed(() => {
  const document = compare.value.document;
  return document && document.model === state.value?.model ? document : null;
});

/** Compares; includes the ladder if it does not yet end at this model. */
export async function startCompare(): Promise<void> {
  const hasLadder = state.value?.results.ladder?.model === state.value?.model;
  await runJob("Compare", "/api/compare", {ladder: !hasLadder});
}

// Readings given at the program's start are compared when the view is first opened.
let isFirst = true;
effect(() => {
  const now = state.value;
  if (!now || !isFirst) return;
  isFirst = false;
  const isBusy = now.jobs.some((job) => job.status === "running");
  if (now.measurements && !now.results.compare && !isBusy) queueMicrotask(() => void compareAtOnce());
});

async function compareAtOnce(): Promise<void> {
  try {
    await startJob("/api/compare", {ladder: true});
  } catch (error) {
    const isBegun = error instanceof ServerProblem && error.status === 409; // another browser was faster
    if (!isBegun) report("Compare", error);
  }
}

/**
 * A running comparison is stopped by a change of the readings; other jobs on them are not stopped without a request.
 */
export const areChangeable = computed(() => runningJobs.value.every((job) => job.kind === "compare"));

/**
 * Marks the readings or reads them otherwise. The answer is the state after the change, and later requests refer to it.
 */
export async function changeReadings(title: string, change: () => Promise<WorkbenchState>): Promise<boolean> {
  await stopJobs("compare");
  return attempt(title, async () => takeState(await change()));
}

/** Kinds of jobs whose answer depends on the readings. */
export const WORK_ON_READINGS = ["compare", "ladder", "diagnose", "identify", "add", "remove"];

/** Stops jobs on the former readings after a change of the readings. */
export function stopWorkOnReadings(): Promise<void> {
  return stopJobs(...WORK_ON_READINGS);
}

export function startDiagnose(): Promise<boolean> {
  return runJob("Diagnose", "/api/diagnose", {effects: 3, next: 6});
}

/** Adds effects, refits, and compares the result. */
export async function addEffects(effects: EffectAt[]): Promise<void> {
  const causes = effects.map(({effect, at, add}) => add ?? `${effect}@${at}`);
  if (await runJob("Add", "/api/add", {causes})) await startCompare();
}

/** Removes effects from the model, or holds numbers (free@NAME) that were fitted; refits, and compares the result. */
export async function removeCauses(causes: string[]): Promise<void> {
  if (await runJob("Switch off", "/api/remove", {causes})) await startCompare();
}

export async function addFormula(formula: string): Promise<boolean> {
  const isAdded = await runJob("Try the formula", "/api/add", {formula});
  if (isAdded) await startCompare();
  return isAdded;
}
