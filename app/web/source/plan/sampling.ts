// Lookup of a time in a path: the sample and the joint values.
import type {PathDocument} from "../server/documents";

/** Returns the index of the last sample at or before a time. */
export function sampleAt(times: readonly number[], at: number): number {
  let low = 0,
    high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= at) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Returns the joint values at a time, interpolated linearly between samples, as in the proof of the motion. */
export function jointsAt(document: PathDocument, at: number): number[] {
  const i = sampleAt(document.time, at),
    j = Math.min(i + 1, document.time.length - 1);
  const span = document.time[j] - document.time[i];
  const share = span > 0 ? Math.min(1, Math.max(0, (at - document.time[i]) / span)) : 0;
  return document.joints[i].map((value, k) => value + share * (document.joints[j][k] - value));
}
