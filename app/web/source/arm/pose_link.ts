// The arm's posture in this browser, and the program's answer to it. At most one question is under way and the last one
// is always asked, so that a slider never waits for a queue.
import {batch, computed, effect, signal} from "@preact/signals";
import type {Mark} from "../drawing/marks";
import type {InverseDocument, PoseDocument, Vector3} from "../server/documents";
import {post} from "../server/requests";
import {attempt, cell, report, state} from "../server/workbench";

const joints = signal<number[]>([]);
const load = signal(0);
const hole = signal(-1);
const answer = signal<PoseDocument | null>(null);
const inverse = signal<InverseDocument | null>(null);
const latency = signal(0);
const reading = signal<ShownReading | null>(null);

/** Reading at whose posture the arm is: the predicted place of its tip, and the errors there, before and after. */
export interface ShownReading {
  id: string;
  place: Vector3 | null;
  errors: {mark: Mark; error: Vector3 | null}[];
  words: string[];
}

export const poseRequest = {joints, load, hole, answer, inverse, latency, reading};

// Identity of the cell; a new cell places the arm at its home posture.
const cellKey = computed(() => `${state.value?.folder ?? ""} ${cell.value?.file ?? ""} ${cell.value?.name ?? ""}`);
effect(() => {
  void cellKey.value;
  const info = cell.peek();
  if (!info) return;
  batch(() => {
    answer.value = null;
    bringArm(info.joints.map((joint) => joint.home));
  });
});

/** Brings the arm to a posture that is under no hole, with a load and the reading taken there. */
export function bringArm(posture: number[], loaded = 0, shown: ShownReading | null = null): void {
  batch(() => {
    hole.value = -1;
    inverse.value = null;
    reading.value = shown;
    load.value = loaded;
    joints.value = posture;
  });
}

let isAsking = false;
let isWanted = false;

async function askPose(): Promise<void> {
  isWanted = true;
  if (isAsking) return;
  isAsking = true;
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
  } catch (error) {
    report("The pose cannot be solved", error);
  } finally {
    isAsking = false;
  }
}

// A change of joints, load, hole or model asks again.
const model = computed(() => `${state.value?.model ?? -1} ${state.value?.models.length ?? 0}`);
effect(() => {
  void joints.value;
  void load.value;
  void hole.value;
  void model.value;
  if (joints.peek().length > 0) void askPose();
});

export function setJoint(index: number, value: number): void {
  const next = [...joints.peek()];
  next[index] = value;
  reading.value = null;
  joints.value = next;
}

/** Returns the reason why no posture brings the arm under the hole; empty if one does. */
export function whyNot(found: InverseDocument): string {
  if (found.status === "found") return "";
  return found.branches.map((branch) => branch.reason).find((reason) => reason !== "") ?? "out of reach";
}

/** Brings the arm under a hole, by its first branch unless another is given. */
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
