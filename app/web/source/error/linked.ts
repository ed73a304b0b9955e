// What the pictures of the error view share: the reading pointed at, and those selected to be set aside.
import {effect, signal} from "@preact/signals";
import {readingErrors} from "./residuals";

/** What a loop in a picture selects; with Shift, beside what is selected already. */
export function selectReadings(ids: Iterable<string>, isMore: boolean): void {
  selectedReadings.value = new Set(isMore ? [...selectedReadings.peek(), ...ids] : ids);
}

/** Ids; "" where none is pointed at. */
export const pointed = signal("");
export const selectedReadings = signal<ReadonlySet<string>>(new Set());

// Errors that are drawn anew have other places; what was selected of those before stays selected, where it is still here.
effect(() => {
  const here = new Set((readingErrors.value?.readings ?? []).map(({id}) => id));
  const picked = selectedReadings.peek(),
    kept = [...picked].filter((id) => here.has(id));
  pointed.value = "";
  if (kept.length < picked.size) selectedReadings.value = new Set(kept);
});

/** Of the ring about a reading that is selected, in the page's pixels. */
export const SELECTED_RADIUS = 5;
