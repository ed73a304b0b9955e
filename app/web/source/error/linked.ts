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

effect(() => {
  void readingErrors.value;
  pointed.value = "";
  pickedOut.value = new Set();
});
