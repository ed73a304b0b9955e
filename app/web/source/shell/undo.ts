// Undo of the last step: a marking of readings, otherwise a step of the model.
import {computed} from "@preact/signals";
import {areChangeable} from "../error/loop";
import {lastMarking, undoMarking} from "../error/reading_marks";
import {order, state} from "../server/workbench";

export const canUndo = computed(() => (lastMarking.value ? areChangeable.value : (state.value?.can_undo ?? false)));

export async function undo(): Promise<void> {
  if (lastMarking.peek()) await undoMarking();
  else await order("Undo", "/api/undo");
}
