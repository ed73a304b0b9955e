// What the pictures of the error view share: the reading pointed at, and those picked out to be set aside.
import {effect, signal} from "@preact/signals";
import {readingErrors} from "./residuals";

/** What a loop in a picture picks out; with Shift, beside what is picked already. */
export function pickOut(ids: Iterable<string>, isMore: boolean): void {
  pickedOut.value = new Set(isMore ? [...pickedOut.peek(), ...ids] : ids);
}

/** Ids; "" where none is pointed at. */
export const pointed = signal("");
export const pickedOut = signal<ReadonlySet<string>>(new Set());

// Errors that are drawn anew have other places; what was picked out of those before stays picked, where it is still here.
effect(() => {
  const here = new Set((readingErrors.value?.readings ?? []).map(({id}) => id));
  const picked = pickedOut.peek(),
    kept = [...picked].filter((id) => here.has(id));
  pointed.value = "";
  if (kept.length < picked.size) pickedOut.value = new Set(kept);
});

/** Of the ring about a reading that is picked out, in the page's pixels. */
export const PICKED_RADIUS = 5;
