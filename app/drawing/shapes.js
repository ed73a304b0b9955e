// Outlines of marks as SVG paths, which a canvas draws through Path2D. The shapes are distinct without colour, so that
// they also work in monochrome print and for colour-blind readers.

/**
 * @typedef {"ring" | "double-ring" | "target" | "dot" | "disc" | "half" | "square" | "diamond" | "triangle" | "cross" |
 *    "bar" | "hatched" | "plus" | "hollow-triangle" | "hollow-square" | "hollow-diamond" | "split-square" | "split-diamond" |
 *    "crossed-square" | "crossed-diamond" | "crossed-ring" | "none"} Shape
 */

/** Paths of the filled area and of the stroke of a shape; `width`: stroke width as a fraction of the shape's radius.
 *  @typedef {{fill: string, line: string, width: number}} Outline */

/** @param {number} x @param {number} y @param {number} r */
export function circlePath(x, y, r) {
  return `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
}

/** @typedef {(x: number, y: number, r: number) => string} PathOf */

/** @type {PathOf} */
const square = (x, y, r) => `M${x - 0.85 * r} ${y - 0.85 * r}h${1.7 * r}v${1.7 * r}h${-1.7 * r}Z`;
/** @type {PathOf} */
const diamond = (x, y, r) => `M${x} ${y - 1.05 * r}L${x + 1.05 * r} ${y}L${x} ${y + 1.05 * r}L${x - 1.05 * r} ${y}Z`;
/** @type {PathOf} */
const triangle = (x, y, r) => `M${x} ${y - 1.1 * r}L${x + 1.05 * r} ${y + 0.8 * r}L${x - 1.05 * r} ${y + 0.8 * r}Z`;
/** @type {PathOf} */
const leftHalf = (x, y, r) => `M${x} ${y - r}A${r} ${r} 0 0 0 ${x} ${y + r}Z`;
/** @type {PathOf} */
const cross = (x, y, r) => {
  const s = 0.8 * r;
  return `M${x - s} ${y - s}L${x + s} ${y + s}M${x - s} ${y + s}L${x + s} ${y - s}`;
};
/** @type {PathOf} */
const plus = (x, y, r) => `M${x - 0.95 * r} ${y}h${1.9 * r}M${x} ${y - 0.95 * r}v${1.9 * r}`;
/** @type {PathOf} */
const upright = (x, y, r) => `M${x} ${y - 0.8 * r}v${1.6 * r}`;
/** @type {PathOf} */
const hatches = (x, y, r) => {
  const middle = 0.707 * r,
    near = 0.258 * r,
    far = 0.966 * r;
  return (
    `M${x - middle} ${y + middle}L${x + middle} ${y - middle}` +
    `M${x - near} ${y + far}L${x + far} ${y - near}M${x - far} ${y + near}L${x + near} ${y - far}`
  );
};

/** @type {Record<Shape, {fill?: PathOf, line?: PathOf, width?: number}>} */
const SHAPES = {
  none: {},
  disc: {fill: circlePath},
  dot: {fill: (x, y, r) => circlePath(x, y, 0.5 * r)},
  square: {fill: square},
  diamond: {fill: diamond},
  triangle: {fill: triangle},
  half: {fill: (x, y, r) => leftHalf(x, y, 0.88 * r), line: (x, y, r) => circlePath(x, y, 0.88 * r), width: 0.22},
  target: {fill: (x, y, r) => circlePath(x, y, 0.36 * r), line: (x, y, r) => circlePath(x, y, 0.9 * r), width: 0.24},
  ring: {line: (x, y, r) => circlePath(x, y, 0.86 * r), width: 0.24},
  "double-ring": {line: (x, y, r) => circlePath(x, y, 0.88 * r) + circlePath(x, y, 0.44 * r), width: 0.22},
  bar: {line: (x, y, r) => circlePath(x, y, 0.86 * r) + `M${x - 0.86 * r} ${y}h${1.72 * r}`, width: 0.26},
  cross: {line: cross, width: 0.42},
  plus: {line: plus, width: 0.3},
  "hollow-diamond": {line: (x, y, r) => diamond(x, y, 0.9 * r), width: 0.26},
  "split-square": {line: (x, y, r) => square(x, y, 0.95 * r) + upright(x, y, r), width: 0.22},
  "split-diamond": {line: (x, y, r) => diamond(x, y, 0.95 * r) + upright(x, y, r), width: 0.22},
  "crossed-square": {line: (x, y, r) => square(x, y, 0.95 * r) + plus(x, y, 0.85 * r), width: 0.2},
  "crossed-diamond": {line: (x, y, r) => diamond(x, y, 0.95 * r) + plus(x, y, r), width: 0.2},
  "hollow-triangle": {line: (x, y, r) => triangle(x, y, 0.9 * r), width: 0.26},
  "hollow-square": {line: (x, y, r) => square(x, y, 0.95 * r), width: 0.26},
  "crossed-ring": {line: (x, y, r) => circlePath(x, y, 0.88 * r) + plus(x, y, 0.9 * r), width: 0.2},
  hatched: {line: (x, y, r) => circlePath(x, y, 0.92 * r) + hatches(x, y, 0.92 * r), width: 0.18},
};

/** Returns the paths of a shape of radius r centred at (x, y).
 *  @param {Shape} shape @param {number} x @param {number} y @param {number} r @returns {Outline} */
export function outlineOf(shape, x, y, r) {
  const {fill, line, width = 0} = SHAPES[shape];
  return {fill: fill ? fill(x, y, r) : "", line: line ? line(x, y, r) : "", width};
}

/**
 * Returns the path of a shape drawn hollow, in which the filled area is stroked instead.
 * @param {Shape} shape @param {number} x @param {number} y @param {number} r
 */
export function hollowPath(shape, x, y, r) {
  const {fill, line} = outlineOf(shape, x, y, r);
  return fill + line;
}
