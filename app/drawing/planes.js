// Viewing planes of positions and errors: two world axes, the first to the right and the second upwards.

/** @typedef {{key: string, axes: [number, number], words: string}} Plane */

/** @type {Plane[]} */
export const PLANES = [
  {key: "xy", axes: [0, 1], words: "from above"},
  {key: "xz", axes: [0, 2], words: "along y"},
  {key: "yz", axes: [1, 2], words: "along x"},
];

/** @param {Plane} plane @param {ArrayLike<number>} place @returns {[number, number]} */
export function inPlane({axes}, place) {
  return [place[axes[0]], place[axes[1]]];
}
