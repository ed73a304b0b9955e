// Undo and redo of the last change of the model, of the readings and their marks, or of the touches.
import {computed} from "@preact/signals";
import {startCompare} from "../error/loop";
import type {WorkbenchState} from "../server/documents";
import {post} from "../server/requests";
import {attempt, state, stopJobs, takeState} from "../server/workbench";

export const canUndo = computed(() => state.value?.can_undo ?? false);
export const canRedo = computed(() => state.value?.can_redo ?? false);

export function undo(): Promise<void> {
  return step("Undo", "/api/undo");
}

export function redo(): Promise<void> {
  return step("Redo", "/api/redo");
}

async function step(title: string, path: string): Promise<void> {
  await stopJobs("compare");
  await changeAndCompare(title, () => post<WorkbenchState>(path));
}

/**
 * Sends a change that returns the state, and compares the readings with the model if not yet compared.
 */
export async function changeAndCompare(title: string, change: () => Promise<WorkbenchState>): Promise<void> {
  if (await attempt(title, async () => takeState(await change()))) await compareIfNeeded();
}

async function compareIfNeeded(): Promise<void> {
  const now = state.peek();
  if (now?.measurements && !now.results.compare?.models.includes(now.model)) await startCompare();
}
