// Arrows of errors: their corners in pixels, and the scale at which a field of them is drawn.
import {isNumber} from "./numbers.js";

/** Shorter than this, in pixels, an arrow is its place alone. */
const SHORTEST = 0.7;

/**
 * The neck, where the shaft ends, and the two corners of the head, which never exceeds 0.8 of the arrow; null of what
 * is too short to be one.
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
 * Draws a shaft and a head on a canvas: thousands are drawn at once. They have the context's own stroke and fill.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x @param {number} y @param {number} dx @param {number} dy
 * @param {boolean} [isHollow] of the head @param {number} [head]
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
 * The size that a share of 98 % is not beyond, so that one wild reading does not make all others small.
 * @param {readonly unknown[]} sizes
 */
export function usualLargest(sizes) {
  const known = sizes.filter(isNumber).sort((a, b) => a - b);
  return known[Math.floor(0.98 * (known.length - 1))] || 0;
}
