// State shared by the pictures of the error view: the pointed reading, and the readings selected to be set aside.
import {effect, signal} from "@preact/signals";
import {readingErrors} from "./residuals";

/** Selects the readings of a lasso; with Shift in addition to the present selection. */
export function selectReadings(ids: Iterable<string>, isMore: boolean): void {
  selectedReadings.value = new Set(isMore ? [...selectedReadings.peek(), ...ids] : ids);
}

/** Id of the pointed reading; "" for none. */
export const pointed = signal("");
export const selectedReadings = signal<ReadonlySet<string>>(new Set());

// New errors have other places; the former selection is kept for readings that still exist.
effect(() => {
  const here = new Set((readingErrors.value?.readings ?? []).map(({id}) => id));
  const picked = selectedReadings.peek(),
    kept = [...picked].filter((id) => here.has(id));
  pointed.value = "";
  if (kept.length < picked.size) selectedReadings.value = new Set(kept);
});

/** Radius of the ring about a selected reading, in the page's pixels. */
export const SELECTED_RADIUS = 5;
