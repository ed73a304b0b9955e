// Components of a tip error: its magnitude, its projections on axes of the world, the base or the tool, and the
// equivalent error of a single joint.

/** @typedef {[number, number, number]} Vector3 */
/** `name` is the label in a list, `title` the label of a plot axis. `of` returns the component of an error at the
 *  reading with that index, or null if the component is undefined at that reading. `lever`: displacement of the tip per
 *  unit of the component at a reading; missing if the component is a displacement.
 *  @typedef {{key: string, name: string, title: string, unit: string, isSigned: boolean,
 *    of: (error: Vector3, index: number) => number | null, lever?: (index: number) => number}} Part */
/** `readings`: tip displacement per unit motion of each joint or axis, keyed by reading id, three values for each entry
 *  of `names`. `base`: origin of the base; `up`: axis of the base; `tool`: axes of the tool, keyed by reading id.
 *  @typedef {{units: string[], names: string[], base: Vector3, up: Vector3, tool: Record<string, number[]>,
 *    readings: Record<string, number[]>}} Leverage */
/** @typedef {{ids: string[], places: (Vector3 | null)[], unit: {length: string, angle: string},
 *    leverage: Leverage | null}} PartSource */

/** Shortest lever for which a joint's equivalent error is defined, as a fraction of the joint's longest lever. */
const LEAST_LEVER = 0.05;

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** @param {Vector3} a @param {Vector3} b @returns {Vector3} */
function crossProduct(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** @param {Vector3} a @param {number} by @returns {Vector3} */
function scaledVector(a, by) {
  return [a[0] * by, a[1] * by, a[2] * by];
}

/**
 * Returns the unit vectors at a tip position away from the base axis, around the base axis, and along it; null if the
 * position lies on the axis.
 * @param {Vector3} place @param {Vector3} base @param {Vector3} up @returns {Vector3[] | null}
 */
function radialAxes(place, base, up) {
  /** @type {Vector3} */
  const from = [place[0] - base[0], place[1] - base[1], place[2] - base[2]];
  const level = scaledVector(up, dot(from, up));
  /** @type {Vector3} */
  const out = [from[0] - level[0], from[1] - level[1], from[2] - level[2]];
  const long = Math.hypot(...out);
  if (!(long > 0)) return null;
  const radial = scaledVector(out, 1 / long);
  return [radial, crossProduct(up, radial), up];
}

/** Returns all components that can be computed; without leverage, only the magnitude and those along the world axes.
 *  @param {PartSource} source @returns {Part[]} */
export function partsOf(source) {
  const {length} = source.unit;
  /**
   * @param {string} key @param {string} title
   * @param {(index: number) => ArrayLike<number> | null | undefined} axis @returns {Part}
   */
  const along = (key, title, axis) => ({
    key,
    name: key,
    title,
    unit: length,
    isSigned: true,
    of: (error, index) => {
      const direction = axis(index);
      return direction ? dot(error, direction) : null;
    },
  });
  /** @type {Part[]} */
  const parts = [
    {key: "size", name: "size", title: "error", unit: length, isSigned: false, of: (error) => Math.hypot(...error)},
    ...["x", "y", "z"].map((name, k) => along(name, `error along ${name}`, () => WORLD_AXES[k])),
  ];
  const {leverage} = source;
  if (!leverage) return parts;
  const radials = source.places.map((place) => (place ? radialAxes(place, leverage.base, leverage.up) : null));
  const tools = source.ids.map((id) => leverage.tool[id]);
  return [
    ...parts,
    ...RADIAL_PARTS.map(([name, words], k) => along(name, words, (index) => radials[index]?.[k])),
    ...["x", "y", "z"].map((name, k) =>
      along(`tool ${name}`, `error along the tool's ${name}`, (index) => tools[index]?.slice(3 * k, 3 * k + 3)),
    ),
    ...leverage.names.map((name, k) => jointPart(name, k, source, leverage)),
  ];
}

/** @type {Vector3[]} */
const WORLD_AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const RADIAL_PARTS = [
  ["radial", "radial error"],
  ["tangential", "tangential error"],
  ["up", "error upwards"],
];

/** @param {string} name */
export function jointKey(name) {
  return `as ${name}`;
}

/**
 * Returns the equivalent error of a joint: the error of the joint that fits the tip error best in the least-squares
 * sense.
 * @param {string} name @param {number} k @param {PartSource} source @param {Leverage} leverage @returns {Part}
 */
function jointPart(name, k, source, leverage) {
  const levers = source.ids.map((id) => leverage.readings[id]?.slice(3 * k, 3 * k + 3));
  const longest = levers.reduce((most, lever) => Math.max(most, lever ? dot(lever, lever) : 0), 0);
  return {
    key: jointKey(name),
    name: `as error of ${name}`,
    title: `error as that of ${name}`,
    unit: leverage.units?.[k] ?? source.unit.angle,
    isSigned: true,
    of: (error, index) => {
      const lever = levers[index];
      if (!lever) return null;
      const square = dot(lever, lever);
      return square > LEAST_LEVER ** 2 * longest ? dot(error, lever) / square : null;
    },
    lever: (index) => Math.hypot(...(levers[index] ?? [0])),
  };
}

/**
 * Returns the component that a pattern of the comparison refers to by frame and name; null if there is none.
 * @param {string | undefined} frame @param {string | undefined} component @param {readonly Part[]} parts
 */
export function findPart(frame, component, parts) {
  if (!component) return null;
  const key = frame === "tool" ? `tool ${component}` : component;
  return parts.find((part) => part.key === key) ?? null;
}
