// Choice of the readings that are drawn out of thousands: more marks would hide one another. It depends on the places
// in the list, so that before and after show the same ones. It is not every n-th reading, which may all have one load.
import {whole} from "./numbers.js";

/** So many arrows, or marks, a picture shows one by one, and so many points a joint's small panel. */
export const MOST_ARROWS = 400;
export const MOST_MARKS = 1000;
export const MOST_POINTS = 300;

const GOLDEN = 0.6180339887498949;

/**
 * Returns true if a reading is drawn: multiples of the golden ratio lie evenly within a turn.
 * @param {number} index @param {number} count of readings @param {number} most that are drawn, about
 */
export function isInShare(index, count, most) {
  return count <= most || (index * GOLDEN) % 1 < most / count;
}

/**
 * Returns words for the legend on the number drawn; empty if all are.
 * @param {number} count @param {number} most
 */
export function shareText(count, most) {
  if (count <= most) return "";
  let drawn = 0;
  for (let index = 0; index < count; ++index) drawn += Number(isInShare(index, count, most));
  return `${whole(drawn)} of ${whole(count)} readings drawn`;
}
