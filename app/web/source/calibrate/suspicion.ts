// What a calibration suspects of its touches: the one that does not agree with the others, joint readings that were read
// wrongly.
import {short} from "../../../drawing/numbers.js";
import type {CalibrateDocument, SuspectReading} from "../server/documents";

export interface Suspicion {
  /** Whether the others fit without it; else a joint reading of it would explain the misfit. */
  isOdd: boolean;
  words: string;
}

/** "theta1 read 0.4 deg too large?" */
export function readingWords({joint, off, unit}: SuspectReading): string {
  return `${joint} read ${short(Math.abs(off))} ${unit} too ${off > 0 ? "large" : "small"}?`;
}

/** What is suspected of a touch; null where nothing is. */
export function suspicionOf(document: CalibrateDocument | null, touch: string): Suspicion | null {
  if (!document) return null;
  const isOdd = document.odd_touch === touch;
  const readings = (document.suspect_readings ?? []).filter((reading) => reading.touch === touch).map(readingWords);
  if (!isOdd && readings.length === 0) return null;
  return {isOdd, words: [...(isOdd ? ["does not agree with the others"] : []), ...readings].join("; ")};
}
