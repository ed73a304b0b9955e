// Marks on readings: set aside and held out.
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

const ADDRESSES: Record<MarkKind, string> = {
  aside: "/api/measurements/set-aside",
  held_out: "/api/measurements/hold-out",
};

/** The last marking of this browser, with the number of the change of the readings that it was. */
const last = signal<(Marking & {change: number}) | null>(null);

/** The last marking; null if something else has changed since. */
export const lastMarking = computed<Marking | null>(() =>
  last.value && state.value?.measurements?.change === last.value.change ? last.value : null,
);

export function markingWords({kind, ids, isOn}: Marking): string {
  const done = kind === "aside" ? (isOn ? "set aside" : "taken back") : isOn ? "held out" : "taken into the fit";
  return `${plural(ids.length, "reading")} ${done}`;
}

function send({kind, ids, isOn}: Marking): Promise<boolean> {
  return changeReadings("Readings", () => post<WorkbenchState>(ADDRESSES[kind], {ids, [kind]: isOn}));
}

/** Sets the mark `kind` of readings to `isOn`, and compares again. */
export async function markReadings(kind: MarkKind, ids: string[], isOn: boolean): Promise<void> {
  const marking = {kind, ids, isOn};
  if (ids.length === 0 || !(await send(marking))) return;
  last.value = {...marking, change: state.peek()?.measurements?.change ?? -1};
  selectedReadings.value = new Set();
  await startCompare();
}
