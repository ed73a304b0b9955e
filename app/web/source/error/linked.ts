// What the pictures of the error view share: the reading pointed at, and those picked out to be set aside.
import {effect, signal} from "@preact/signals";
import {readingErrors} from "./residuals";

/** Ids; "" where none is pointed at. */
export const pointed = signal("");
export const pickedOut = signal<ReadonlySet<string>>(new Set());

effect(() => {
  void readingErrors.value;
  pointed.value = "";
  pickedOut.value = new Set();
});
