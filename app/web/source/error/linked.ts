// State shared by the pictures of the error view: the reading pointed at, and the readings selected for marking.
import {effect, signal} from "@preact/signals";
import {readingErrors} from "./residuals";

/** Selects readings. `isMore` (Shift): adds them to the current selection instead of replacing it. */
export function selectReadings(ids: Iterable<string>, isMore: boolean): void {
  selectedReadings.value = new Set(isMore ? [...selectedReadings.peek(), ...ids] : ids);
}

/** Id of the reading pointed at; "" for none. */
export const pointed = signal("");
export const selectedReadings = signal<ReadonlySet<string>>(new Set());

// A change of the errors resets the pointed reading. Selected readings that still exist stay selected.
effect(() => {
  const here = new Set((readingErrors.value?.readings ?? []).map(({id}) => id));
  const picked = selectedReadings.peek(),
    kept = [...picked].filter((id) => here.has(id));
  pointed.value = "";
  if (kept.length < picked.size) selectedReadings.value = new Set(kept);
});

/** Radius of the ring around a selected reading [page pixels]. */
export const SELECTED_RADIUS = 5;
