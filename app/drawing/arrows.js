// Error arrows: their corners in pixels, and the error size that sets their scale.
import {isNumber} from "./numbers.js";

/** Length [px] below which no arrow is drawn. */
const SHORTEST = 0.7;

/**
 * Returns the end of the shaft and the two rear corners of the head, or null if the arrow is too short to be drawn. The
 * head takes at most 0.8 of the arrow's length.
 * @param {number} x @param {number} y @param {number} dx @param {number} dy @param {number} head
 * @returns {[number, number, number, number, number, number] | null}
 */
export function arrowCorners(x, y, dx, dy, head = 6) {
  const long = Math.hypot(dx, dy);
  if (!(long >= SHORTEST)) return null;
  const size = Math.min(head, 0.8 * long),
    ux = dx / long,
    uy = dy / long;
  const nx = x + dx - size * ux,
    ny = y + dy - size * uy,
    half = 0.42 * size;
  return [nx, ny, nx - half * uy, ny + half * ux, nx + half * uy, ny - half * ux];
}

/**
 * Draws an arrow on a canvas in the context's current stroke and fill styles.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x @param {number} y @param {number} dx @param {number} dy
 * @param {boolean} [isHollow] outlines the head instead of filling it @param {number} [head] length of the head [px]
 */
export function drawArrow(context, x, y, dx, dy, isHollow = false, head) {
  const corners = arrowCorners(x, y, dx, dy, head);
  if (!corners) return;
  const [nx, ny, ax, ay, bx, by] = corners;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(nx, ny);
  context.stroke();
  context.beginPath();
  context.moveTo(x + dx, y + dy);
  context.lineTo(ax, ay);
  context.lineTo(bx, by);
  context.closePath();
  if (isHollow) context.stroke();
  else context.fill();
}

/**
 * Returns the 98 % quantile of the sizes, to which arrows are scaled: with the maximum, a single outlier would shrink
 * all other arrows. Returns 0 if there are no sizes.
 * @param {readonly unknown[]} sizes
 */
export function usualLargest(sizes) {
  const known = sizes.filter(isNumber).sort((a, b) => a - b);
  return known[Math.floor(0.98 * (known.length - 1))] || 0;
}
