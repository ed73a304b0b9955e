// Playing a plan: a clock that runs along the path, and the joints at any time of it.
import {computed, effect, signal} from "@preact/signals";
import type {PathClearances, PathDocument, PlanDocument} from "../server/documents";
import {answerTo} from "../server/answers";
import {get, isMissing} from "../server/requests";
import {report, result, state} from "../server/workbench";
import {poseRequest} from "../arm/pose_link";
import {jointsAt, sampleAt} from "./sampling";

export const plan = result<PlanDocument>("plan");
/** The distance to what is nearest at the path's samples, as far as it has been asked for; null where nothing is near. */
export const clearances = signal<(number | null)[]>([]);
export const time = signal(0);
export const speed = signal(1);
export const isPlaying = signal(false);
/** Set while a view shows the plan, so that the sliders of the arm are left alone otherwise. */
export const isFollowed = signal(false);

// ---- the path belongs to the plan: fetched when the plan is

const planMark = computed(() => state.value?.results.plan?.revision ?? -1);
const found = answerTo<PathDocument>({
  key: () => (!isFollowed.value ? null : planMark.value < 0 ? "" : String(planMark.value)),
  path: () => "/api/plan/path",
  keeps: true,
  onProblem: (error) => report("The path of the plan", error),
});
const foundPath = computed(() => found.value.document);
export const path = computed(() => (foundPath.value ? perSample(foundPath.value) : null));

// Another path is played from its beginning.
effect(() => {
  const document = path.value;
  isPlaying.value = false;
  clearances.value = [];
  time.value = 0;
  if (document) void askClearances(planMark.peek(), document.time.length);
});

const AT_ONCE = 500;

/** A batch at a time: each takes about a tenth of a second, and poses are asked in between. */
async function askClearances(mark: number, samples: number): Promise<void> {
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

/** Clearance is proved of whole segments: each sample has that of its own. */
function perSample(document: PathDocument): PathDocument {
  const {clearance, segment, time: times} = document;
  if (!clearance || clearance.length === times.length) return document;
  return {...document, clearance: segment.map((index) => clearance[index] ?? null)};
}

export const endTime = computed(() => path.value?.time.at(-1) ?? 0);

// ---- where in the path a time is

/** The visit that a sample belongs to: from the path, else counted by its approaches. */
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

/** The time at which each tube is reached: the end of its approach. */
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

function tick(now: number): void {
  if (!isPlaying.value) return;
  const next = time.value + Math.min(0.1, (now - last) / 1000) * speed.value;
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

// The arm follows the clock; the pose is solved by the program, one at a time.
effect(() => {
  const document = path.value;
  const at = time.value;
  if (document && document.time.length > 0 && isFollowed.value) poseRequest.joints.value = jointsAt(document, at);
});
