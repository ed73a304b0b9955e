// The arm's posture in this browser, and the program's answer to it. Only one request is pending at a time, and the
// latest posture is always requested, so that sliders never wait for a queue.
import {batch, computed, effect, signal} from "@preact/signals";
import type {Mark} from "../drawing/marks";
import type {InverseDocument, PoseDocument, Vector3} from "../server/documents";
import {post} from "../server/requests";
import {attempt, cell, forget, report, state} from "../server/workbench";

const joints = signal<number[]>([]);
const load = signal(0);
const hole = signal(-1);
const answer = signal<PoseDocument | null>(null);
const inverse = signal<InverseDocument | null>(null);
const latency = signal(0);
const reading = signal<ShownReading | null>(null);

/**
 * Reading whose posture the arm shows: the predicted position of the tip, and the errors of the reading before and
 * after.
 */
export interface ShownReading {
  id: string;
  place: Vector3 | null;
  errors: {mark: Mark; error: Vector3 | null}[];
  words: string[];
}

export const poseRequest = {joints, load, hole, answer, inverse, latency, reading};

// Identity of the cell; when it changes, the arm moves to its park posture, otherwise to its home posture.
const cellKey = computed(() => `${state.value?.folder ?? ""} ${cell.value?.file ?? ""} ${cell.value?.name ?? ""}`);
effect(() => {
  void cellKey.value;
  const info = cell.peek();
  if (!info) return;
  batch(() => {
    answer.value = null;
    bringArm(info.park ?? info.joints.map((joint) => joint.home));
  });
});

/** Moves the arm to a posture that is not assigned to a hole, with a load and, optionally, the reading taken there. */
export function bringArm(posture: number[], loaded = 0, shown: ShownReading | null = null): void {
  batch(() => {
    hole.value = -1;
    inverse.value = null;
    reading.value = shown;
    load.value = loaded;
    joints.value = posture;
  });
}

const POSE = "The pose cannot be solved";
let isRequesting = false;
let isWanted = false;

async function requestPose(): Promise<void> {
  isWanted = true;
  if (isRequesting) return;
  isRequesting = true;
  try {
    while (isWanted) {
      isWanted = false;
      const start = performance.now();
      answer.value = await post<PoseDocument>("/api/pose", {
        joints: joints.peek(),
        load: load.peek(),
        ...(hole.peek() >= 0 ? {hole: hole.peek()} : {}),
      });
      latency.value = performance.now() - start;
    }
    forget(POSE);
  } catch (error) {
    report(POSE, error);
  } finally {
    isRequesting = false;
  }
}

// A change of joints, load, hole or model requests the pose again.
const model = computed(() => `${state.value?.model ?? -1} ${state.value?.models.length ?? 0}`);
effect(() => {
  void joints.value;
  void load.value;
  void hole.value;
  void model.value;
  if (joints.peek().length > 0) void requestPose();
});

export function setJoint(index: number, value: number): void {
  const next = [...joints.peek()];
  next[index] = value;
  reading.value = null;
  joints.value = next;
}

/** Returns the reason why the arm cannot reach the hole; empty if it can. */
export function whyNot(found: InverseDocument): string {
  if (found.status === "found") return "";
  return found.branches.map((branch) => branch.reason).find((reason) => reason !== "") ?? "out of reach";
}

/**
 * Moves the arm under a hole, in the posture of the given branch, otherwise in that with the largest clearance margin.
 */
export async function showHole(index: number, branch?: number): Promise<void> {
  inverse.value = null;
  reading.value = null;
  hole.value = index;
  await attempt("No posture", async () => {
    const found = await post<InverseDocument>("/api/inverse", {hole: index, ...(branch === undefined ? {} : {branch})});
    if (hole.peek() !== index) return;
    inverse.value = found;
    if (found.status === "found" && found.joints) joints.value = found.joints;
  });
}
