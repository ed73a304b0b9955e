// Tube sheet as flat arrays for drawing: u to the right and v upwards, so that u is -x in the view from below. It also
// has the outline of the plate, a search for the hole nearest to a point, and the positions of rows and columns.
import {extentOf} from "./frames.js";

/** @typedef {import("./frames.js").Extent} Extent */
/** @typedef {{value: number, place: number}} Tick */
/** Arrays with one entry per hole. `state` holds indices into `states` (names) and into `state_words` (phrases).
 *  @typedef {{row: number[], column: number[], u: number[], v: number[], x: number[], y: number[], z: number[],
 *    state: number[], states: string[], state_words: string[]}} HoleArrays */
/** (u, v): direction of the manway from the centre of the sheet; `center`: position in the world frame, if known.
 *  @typedef {{u: number, v: number, center?: [number, number, number], diameter?: number}} Manway */
/** @typedef {{name: string, pitch: number, hole_diameter: number, leg: string, leg_words: string, viewing_side: string,
 *    view_words: string, manway: Manway | null, holes: HoleArrays}} SheetSource */
/** @typedef {ReturnType<typeof makeSheetModel>} SheetModel */

/** Width of the plate beyond the outermost hole, in pitches. */
const RIM = 1.4;

/** @param {SheetSource} source */
export function makeSheetModel(source) {
  const {holes} = source;
  const u = Float64Array.from(holes.u),
    v = Float64Array.from(holes.v);
  const count = u.length;
  const extent = count > 0 ? extentOf(Array.from(u, (_, i) => [u[i], v[i]])) : {left: -1, right: 1, bottom: -1, top: 1};
  const world = new Float64Array(3 * count);
  for (let i = 0; i < count; ++i) world.set([holes.x[i], holes.y[i], holes.z[i]], 3 * i);
  const pitch = source.pitch > 0 ? source.pitch : (extent.right - extent.left) / Math.sqrt(Math.max(1, count));
  const radius = u.reduce((most, _, i) => Math.max(most, Math.hypot(u[i], v[i])), 0) + RIM * pitch;
  return {
    name: source.name,
    leg: source.leg,
    legWords: source.leg_words,
    viewingSide: source.viewing_side,
    viewWords: source.view_words,
    pitch,
    holeRadius: source.hole_diameter > 0 ? source.hole_diameter / 2 : 0.35 * pitch,
    count,
    row: Int32Array.from(holes.row),
    column: Int32Array.from(holes.column),
    u,
    v,
    world,
    state: Uint8Array.from(holes.state),
    states: holes.states,
    stateWords: holes.state_words,
    extent,
    ...plateOf(extent, radius),
    manway: source.manway,
    rowTicks: ticksOf(holes.row, v, pitch),
    columnTicks: ticksOf(holes.column, u, pitch),
    nearest: finderOf(u, v, pitch, extent),
    find: namesOf(holes),
  };
}

/**
 * Returns the outline of the plate: a disc or, for a sheet of a single leg, the half disc on that leg's side of the
 * divider.
 * @param {Extent} extent @param {number} radius
 */
function plateOf(extent, radius) {
  const isOneLeg = extent.bottom > -0.25 * extent.top || extent.top < -0.25 * extent.bottom;
  const isLower = extent.top <= 0.25 * Math.abs(extent.bottom);
  return {
    radius,
    isOneLeg,
    /** True if the holes of a sheet of one leg are drawn below the divider. */
    isLower,
    /** @type {Extent} */
    plate: {
      left: -radius,
      right: radius,
      bottom: isOneLeg && !isLower ? 0 : -radius,
      top: isOneLeg && isLower ? 0 : radius,
    },
  };
}

/**
 * Returns each row or column number with its position; empty if a number has several positions, as when tubes are
 * numbered within each row.
 * @param {ArrayLike<number>} numbers @param {ArrayLike<number>} places @param {number} pitch @returns {Tick[]}
 */
export function ticksOf(numbers, places, pitch) {
  /** @type {Map<number, number>} */
  const known = new Map();
  for (let i = 0; i < numbers.length; ++i) {
    const place = known.get(numbers[i]);
    if (place === undefined) known.set(numbers[i], places[i]);
    else if (Math.abs(place - places[i]) > 0.1 * pitch) return [];
  }
  return [...known].map(([value, place]) => ({value, place})).sort((a, b) => a.value - b.value);
}

/**
 * Returns the ticks at multiples of 1, 2, 5, 10, ..., chosen so that labels are at least 34 pixels apart.
 * @param {readonly Tick[]} ticks @param {number} scale pixels per unit of length
 */
export function spacedTicks(ticks, scale) {
  if (ticks.length < 2) return [...ticks];
  const first = ticks[0],
    last = ticks[ticks.length - 1];
  const each = Math.abs((last.place - first.place) / (last.value - first.value)) * scale;
  const every = [1, 2, 5, 10, 20, 50, 100].find((step) => step * each >= 34) ?? 200;
  return ticks.filter(({value}) => value % every === 0 || (every === 2 && value === first.value));
}

/**
 * Returns a function that finds the index of the hole nearest to a point, or -1 if none is within `reach` (at most two
 * pitches). Holes are stored in a grid of cells two pitches wide; nine cells are searched.
 * @param {Float64Array} u @param {Float64Array} v @param {number} pitch @param {Extent} extent
 */
function finderOf(u, v, pitch, extent) {
  const size = 2 * pitch;
  const across = Math.max(1, Math.ceil((extent.right - extent.left) / size) + 1);
  /** @type {Map<number, number[]>} */
  const buckets = new Map();
  const bucketOf = (/** @type {number} */ x, /** @type {number} */ y) =>
    Math.floor((y - extent.bottom) / size) * across + Math.floor((x - extent.left) / size);
  for (let i = 0; i < u.length; ++i) {
    const key = bucketOf(u[i], v[i]);
    const bucket = buckets.get(key);
    if (bucket) bucket.push(i);
    else buckets.set(key, [i]);
  }
  return (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ reach) => {
    let best = -1,
      least = reach * reach;
    for (let dy = -1; dy <= 1; ++dy) {
      for (let dx = -1; dx <= 1; ++dx) {
        for (const i of buckets.get(bucketOf(x + dx * size, y + dy * size)) ?? []) {
          const square = (u[i] - x) ** 2 + (v[i] - y) ** 2;
          if (square < least) [best, least] = [i, square];
        }
      }
    }
    return best;
  };
}

/**
 * Returns a function from row and column to the index of the hole, or -1 if there is none.
 * @param {{row: number[], column: number[]}} holes
 */
function namesOf({row, column}) {
  const byName = new Map(row.map((value, i) => [value * 4096 + column[i], i]));
  return (/** @type {number} */ r, /** @type {number} */ c) => byName.get(r * 4096 + c) ?? -1;
}

/** Returns a tube's name for display, such as "R12 C7". @param {unknown} row @param {unknown} column */
export function tubeTitle(row, column) {
  return `R${row}\u00a0C${column}`;
}

/** Returns leg and view, such as "hot leg, seen from below". @param {{legWords: string, viewWords: string}} sheet */
export function sheetWords({legWords, viewWords}) {
  return [legWords, viewWords].filter((text) => text).join(", ");
}
