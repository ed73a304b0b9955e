// Subset of readings to draw, because the marks of thousands would hide one another. The choice depends only on the
// index, so that plots before and after a change show the same readings. Choosing every n-th reading is unsuitable,
// because all of these may have the same load.
import {whole} from "./numbers.js";

/** Largest numbers of readings drawn individually: arrows or marks in a picture, points in a joint's small panel. */
export const MOST_ARROWS = 400;
export const MOST_MARKS = 1000;
export const MOST_POINTS = 300;

const GOLDEN = 0.6180339887498949;

/**
 * Returns true if a reading is drawn. Fractional parts of multiples of the golden ratio are evenly distributed.
 * @param {number} index @param {number} count number of readings @param {number} most approximate number drawn
 */
export function isInShare(index, count, most) {
  return count <= most || (index * GOLDEN) % 1 < most / count;
}

/**
 * Returns the legend's text on the number of readings drawn; empty if all are drawn.
 * @param {number} count @param {number} most
 */
export function shareText(count, most) {
  if (count <= most) return "";
  let drawn = 0;
  for (let index = 0; index < count; ++index) drawn += Number(isInShare(index, count, most));
  return `${whole(drawn)} of ${whole(count)} readings drawn`;
}
