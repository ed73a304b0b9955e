// Display of a reading in the arm view: its posture and load, with its error as an arrow.
import {batch} from "@preact/signals";
import {bringArm} from "../arm/pose_link";
import {view} from "../shell/page_state";
import {readingErrors} from "./residuals";

export function showReading(id: string): void {
  const errors = readingErrors.peek();
  const index = errors?.readings.findIndex((reading) => reading.id === id) ?? -1;
  if (!errors || index < 0) return;
  const reading = errors.readings[index];
  batch(() => {
    bringArm([...reading.joints], reading.load, {
      id,
      place: errors.places[index],
      errors: errors.series.map((series) => ({mark: series.mark, error: series.errors[index] ?? null})),
      words: errors.series.map((series) => series.name),
    });
    view.value = "arm";
  });
}
