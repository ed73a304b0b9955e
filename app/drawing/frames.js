// Conversion between lengths in a plane and pixels, with a camera fitted to an extent and margins.

/** `u` (to the right) and `v` (upwards): centre of the picture; `scale`: pixels per unit of length.
 *  @typedef {{u: number, v: number, scale: number}} Camera */
/** @typedef {{width: number, height: number}} Size */
/** @typedef {{left: number, right: number, bottom: number, top: number}} Extent */

/** @param {Iterable<ArrayLike<number>>} places @returns {Extent} */
export function extentOf(places) {
  const extent = {left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
  for (const place of places) {
    extent.left = Math.min(extent.left, place[0]);
    extent.right = Math.max(extent.right, place[0]);
    extent.bottom = Math.min(extent.bottom, place[1]);
    extent.top = Math.max(extent.top, place[1]);
  }
  return extent;
}

/**
 * Returns the camera that shows an extent as large as possible within the margins [px].
 * @param {Extent} extent @param {Size} size @param {Extent} margin @returns {Camera}
 */
export function fit(extent, size, margin) {
  const width = Math.max(40, size.width - margin.left - margin.right);
  const height = Math.max(40, size.height - margin.top - margin.bottom);
  const scale = Math.min(width / (extent.right - extent.left || 1), height / (extent.top - extent.bottom || 1));
  return {
    u: (extent.left + extent.right) / 2 - (margin.left - margin.right) / 2 / scale,
    v: (extent.bottom + extent.top) / 2 + (margin.top - margin.bottom) / 2 / scale,
    scale,
  };
}

/** @param {Camera} camera @param {Size} size @param {number} u @param {number} v @returns {[number, number]} */
export function toPixel(camera, size, u, v) {
  return [size.width / 2 + (u - camera.u) * camera.scale, size.height / 2 - (v - camera.v) * camera.scale];
}

/** @param {Camera} camera @param {Size} size @param {number} x @param {number} y @returns {[number, number]} */
export function fromPixel(camera, size, x, y) {
  return [camera.u + (x - size.width / 2) / camera.scale, camera.v - (y - size.height / 2) / camera.scale];
}

/**
 * Returns the index of the entry of `places` [px] nearest to (x, y), or -1 if none is closer than `reach`.
 * @param {readonly (ArrayLike<number> | null)[]} places @param {number} x @param {number} y @param {number} reach
 */
export function nearestPlace(places, x, y, reach) {
  let best = -1,
    least = reach * reach;
  places.forEach((place, i) => {
    const square = place ? (place[0] - x) ** 2 + (place[1] - y) ** 2 : Infinity;
    if (square < least) [best, least] = [i, square];
  });
  return best;
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}
