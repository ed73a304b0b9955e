// Suspicions about touches: a touch that disagrees with the others, or a wrong joint reading.
import {short} from "../../../drawing/numbers.js";
import type {CalibrateDocument, SuspectReading} from "../server/documents";

export interface Suspicion {
  /** True if the other touches fit without this one; false if a wrong joint reading would explain the misfit. */
  isOutlier: boolean;
  words: string;
}

/** Returns a question such as "theta1 read 0.4 deg too large?" */
export function readingWords({joint, off, unit}: SuspectReading): string {
  return `${joint} read ${short(Math.abs(off))} ${unit} too ${off > 0 ? "large" : "small"}?`;
}

/** Returns the suspicion about a touch of the calibration; null if there is none. */
export function suspicionOf(document: CalibrateDocument | null, touch: string): Suspicion | null {
  if (!document) return null;
  const isOutlier = document.odd_touch === touch;
  const readings = (document.suspect_readings ?? []).filter((reading) => reading.touch === touch).map(readingWords);
  if (!isOutlier && readings.length === 0) return null;
  return {isOutlier, words: [...(isOutlier ? ["does not agree with the others"] : []), ...readings].join("; ")};
}
