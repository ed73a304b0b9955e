// Marks on readings (set aside, held out), as steps that can be undone until something else changes.
import {computed, signal} from "@preact/signals";
import {plural} from "../../../drawing/numbers.js";
import type {WorkbenchState} from "../server/documents";
import {post} from "../server/requests";
import {state} from "../server/workbench";
import {selectedReadings} from "./linked";
import {changeReadings, startCompare} from "./loop";

export type MarkKind = "aside" | "held_out";

interface Marking {
  kind: MarkKind;
  ids: string[];
  isOn: boolean;
}

/** Marking that was made, with the state before it. */
interface Step extends Marking {
  change: number;
  model: number;
}

const ADDRESSES: Record<MarkKind, string> = {
  aside: "/api/measurements/set-aside",
  held_out: "/api/measurements/hold-out",
};

const steps = signal<Step[]>([]);

/** The last marking; null if something else has changed since. */
export const lastMarking = computed<Step | null>(() => {
  const last = steps.value.at(-1),
    now = state.value;
  return last && now?.measurements?.change === last.change && now.model === last.model ? last : null;
});

export function markingWords({kind, ids, isOn}: Marking): string {
  const done = kind === "aside" ? (isOn ? "set aside" : "taken back") : isOn ? "held out" : "taken into the fit";
  return `${plural(ids.length, "reading")} ${done}`;
}

function send({kind, ids, isOn}: Marking): Promise<boolean> {
  return changeReadings("Readings", () => post<WorkbenchState>(ADDRESSES[kind], {ids, [kind]: isOn}));
}

/** Returns the expected number of the next change of the readings; another browser may take it first. */
function nextChange(): number {
  return (state.peek()?.measurements?.change ?? 0) + 1;
}

/**
 * Sets the mark `kind` of readings to `isOn`, and compares again. All these readings must have the opposite mark,
 * because undoing inverts it.
 */
export async function markReadings(kind: MarkKind, ids: string[], isOn: boolean): Promise<void> {
  const step = {kind, ids, isOn, change: nextChange(), model: state.peek()?.model ?? -1};
  if (ids.length === 0 || !(await send(step))) return;
  steps.value = [...steps.value, step];
  selectedReadings.value = new Set();
  await startCompare();
}

/** Undoes the last marking; then the marking before it can be undone. */
export async function undoMarking(): Promise<void> {
  const last = lastMarking.peek(),
    change = nextChange();
  if (!last || !(await send({...last, isOn: !last.isOn}))) return;
  const earlier = steps.peek().slice(0, -1);
  // The readings are now in the state after the previous marking, which therefore gets the new change number.
  steps.value = earlier.map((step, k) =>
    k === earlier.length - 1 && step.change === last.change - 1 ? {...step, change} : step,
  );
  await startCompare();
}
