// Playback of a plan: a clock that runs along the path, and the joint values at the clock's time.
import {computed, effect, signal} from "@preact/signals";
import type {PathClearances, PathDocument, PlanDocument} from "../server/documents";
import {answerTo} from "../server/answers";
import {get, isMissing} from "../server/requests";
import {report, reporting, result, state} from "../server/workbench";
import {poseRequest} from "../arm/pose_link";
import {jointsAt, sampleAt} from "./sampling";

export const plan = result<PlanDocument>("plan");
/** Distance to the nearest object at the samples of the path requested so far; null without a near object. */
export const clearances = signal<(number | null)[]>([]);
export const time = signal(0);
export const speed = signal(1);
export const isPlaying = signal(false);
/** True while a view shows the plan; otherwise playback does not move the sliders of the arm. */
export const isFollowed = signal(false);

// ---- the path of the plan, fetched with it

const planMark = computed(() => state.value?.results.plan?.revision ?? -1);
const found = answerTo<PathDocument>({
  key: () => (!isFollowed.value ? null : planMark.value < 0 ? "" : String(planMark.value)),
  path: () => "/api/plan/path",
  keeps: true,
  onProblem: reporting("The path of the plan"),
});
const foundPath = computed(() => found.value.document);
export const path = computed(() => (foundPath.value ? perSample(foundPath.value) : null));

// A new path starts at its beginning.
effect(() => {
  const document = path.value;
  isPlaying.value = false;
  clearances.value = [];
  time.value = 0;
  if (document) void requestClearances(planMark.peek(), document.time.length);
});

const AT_ONCE = 500;

/**
 * Requests the clearances in batches that take about a tenth of a second, so that requests for poses can run between
 * them.
 */
async function requestClearances(mark: number, samples: number): Promise<void> {
  try {
    while (clearances.peek().length < samples && planMark.peek() === mark) {
      const from = clearances.peek().length;
      const found = await get<PathClearances>(`/api/plan/clearance?from=${from}&count=${AT_ONCE}`);
      if (planMark.peek() !== mark || found.clearance.length === 0) return;
      clearances.value = [...clearances.peek(), ...found.clearance];
    }
  } catch (error) {
    if (!isMissing(error)) report("The clearance along the plan", error);
  }
}

/**
 * Returns the document with the clearance of the segment at each sample, because clearance is proved for whole
 * segments.
 */
function perSample(document: PathDocument): PathDocument {
  const {clearance, segment, time: times} = document;
  if (!clearance || clearance.length === times.length) return document;
  return {...document, clearance: segment.map((index) => clearance[index] ?? null)};
}

export const endTime = computed(() => path.value?.time.at(-1) ?? 0);

// ---- place of a time in the path

/** Index of the visit at each sample, as the path states it, otherwise counted by approach segments. */
export const visitOfSample = computed<Int32Array>(() => {
  const document = path.value;
  if (!document) return new Int32Array(0);
  if (document.tube) return Int32Array.from(document.tube);
  const visits = new Int32Array(document.time.length);
  let visit = -1,
    segment = NaN;
  document.time.forEach((_, i) => {
    if (document.segment[i] !== segment) {
      segment = document.segment[i];
      if (document.kind[i] === "approach") visit += 1;
    }
    visits[i] = Math.max(0, visit);
  });
  return visits;
});

export const currentVisit = computed(() => {
  const document = path.value;
  return document ? (visitOfSample.value[sampleAt(document.time, time.value)] ?? 0) : -1;
});

/** Time at which each tube is reached: the end of its approach. */
export const arrivals = computed<number[]>(() => {
  const document = path.value;
  const count = plan.value.document?.tubes.length ?? 0;
  const times = new Array<number>(count).fill(NaN);
  if (!document) return times;
  document.time.forEach((at, i) => {
    if (document.kind[i] === "approach") times[visitOfSample.value[i]] = at;
  });
  return times;
});

// ---- the clock

let last = 0;

// A hidden page draws nothing, so playback resumes where the page was hidden.
document.addEventListener("visibilitychange", () => (last = performance.now()));

/** Advances by the time that has passed, so that a slow display drops pictures and keeps the speed. */
function tick(now: number): void {
  if (!isPlaying.value) return;
  const next = time.value + (Math.max(0, now - last) / 1000) * speed.value;
  last = now;
  time.value = Math.min(endTime.value, next);
  if (time.value >= endTime.value) isPlaying.value = false;
  else requestAnimationFrame(tick);
}

export function play(): void {
  if (!path.value || isPlaying.value) return;
  if (time.value >= endTime.value) time.value = 0;
  isPlaying.value = true;
  last = performance.now();
  requestAnimationFrame(tick);
}

export function togglePlay(): void {
  if (isPlaying.value) isPlaying.value = false;
  else play();
}

export function goToVisit(visit: number): void {
  const at = arrivals.value[Math.max(0, Math.min(arrivals.value.length - 1, visit))];
  if (Number.isFinite(at)) time.value = at;
}

// The arm follows the clock; the program computes one pose at a time.
effect(() => {
  const document = path.value;
  const at = time.value;
  if (document && document.time.length > 0 && isFollowed.value) poseRequest.joints.value = jointsAt(document, at);
});
