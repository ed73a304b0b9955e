// The calibration loop as requests to the program (compare, diagnose, add), and the page's automatic steps between
// them.
import {computed, effect} from "@preact/signals";
import {causeKey} from "../../../drawing/explanations.js";
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

/** Diagnosis of the current model. Diagnoses of other models are kept but not shown. */
export const currentDiagnosis = computed(() => {
  const document = diagnose.value.document;
  return document && document.model === state.value?.model ? document : null;
});
export const currentComparison = computed(() => {
  const document = compare.value.document;
  return document && document.model === state.value?.model ? document : null;
});

/** Starts a comparison, including the ladder if the ladder does not end at the current model yet. */
export async function startCompare(): Promise<void> {
  const hasLadder = state.value?.results.ladder?.model === state.value?.model;
  await runJob("Compare", "/api/compare", {ladder: !hasLadder});
}

// Readings given when the program was started are compared as soon as the page has received them.
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
    const isBegun = error instanceof ServerProblem && error.status === 409; // begun by another browser
    if (!isBegun) report("Compare", error);
  }
}

/** True if the readings can be changed. A change stops a running comparison, but must not stop any other job. */
export const areChangeable = computed(() => runningJobs.value.every((job) => job.kind === "compare"));

/**
 * Changes the readings by marks or by reading them under other assumptions. `change` returns the state after the
 * change, to which later requests refer. Returns true if it succeeded.
 */
export async function changeReadings(title: string, change: () => Promise<WorkbenchState>): Promise<boolean> {
  await stopJobs("compare");
  return attempt(title, async () => takeState(await change()));
}

/** Kinds of jobs whose results depend on the readings. */
export const WORK_ON_READINGS = ["compare", "ladder", "diagnose", "identify", "add", "remove"];

/** Stops jobs that work on the previous readings after the readings have changed. */
export function stopWorkOnReadings(): Promise<void> {
  return stopJobs(...WORK_ON_READINGS);
}

export function startDiagnose(): Promise<boolean> {
  return runJob("Diagnose", "/api/diagnose", {effects: 3, next: 6});
}

/** Adds effects, refits, and compares the result. */
export async function addEffects(effects: EffectAt[]): Promise<void> {
  const causes = effects.map((effect) => effect.add ?? causeKey(effect));
  if (await runJob("Add", "/api/add", {causes})) await startCompare();
}

/**
 * Removes effects from the model, or holds fitted parameters (free@NAME) fixed; then refits and compares the result.
 */
export async function removeCauses(causes: string[]): Promise<void> {
  if (await runJob("Switch off", "/api/remove", {causes})) await startCompare();
}

export async function addFormula(formula: string): Promise<boolean> {
  const isAdded = await runJob("Try the formula", "/api/add", {formula});
  if (isAdded) await startCompare();
  return isAdded;
}
