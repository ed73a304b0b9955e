// Parts of an error at the tip: its size, along axes of the world, of the base or of the tool, or as the error of one
// joint that it would be.
import type {LeverageDocument, Vector3} from "../server/documents";

export interface Part {
  key: string;
  /** As the list says it, and as an axis does. */
  name: string;
  title: string;
  unit: string;
  isSigned: boolean;
  /** Of an error at the reading of that place in the list; null where it says nothing there. */
  of: (error: Vector3, index: number) => number | null;
}

export interface PartSource {
  ids: string[];
  places: (Vector3 | null)[];
  unit: {length: string; angle: string};
  leverage: LeverageDocument | null;
}

/** A joint through whose axis the tip nearly lies moves it too little to be asked: as a share of the longest lever. */
const LEAST_LEVER = 0.05;

export function dot(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector3, b: Vector3): Vector3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function scaled(a: Vector3, by: number): Vector3 {
  return [a[0] * by, a[1] * by, a[2] * by];
}

/** Away from the base's axis, around it, up. */
function radialAxes(place: Vector3, base: Vector3, up: Vector3): Vector3[] | null {
  const from: Vector3 = [place[0] - base[0], place[1] - base[1], place[2] - base[2]];
  const level = scaled(up, dot(from, up));
  const out: Vector3 = [from[0] - level[0], from[1] - level[1], from[2] - level[2]];
  const long = Math.hypot(...out);
  if (!(long > 0)) return null;
  const radial = scaled(out, 1 / long);
  return [radial, cross(up, radial), up];
}

export function partsOf(source: PartSource): Part[] {
  const {length} = source.unit;
  const along = (key: string, title: string, axis: (index: number) => ArrayLike<number> | null | undefined): Part => ({
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
  const parts: Part[] = [
    {key: "size", name: "size", title: "error", unit: length, isSigned: false, of: (error) => Math.hypot(...error)},
    ...["x", "y", "z"].map((name, k) => along(name, `error along ${name}`, () => UNITS[k])),
  ];
  const {leverage} = source;
  if (!leverage) return parts;
  const radials = source.places.map((place) => (place ? radialAxes(place, leverage.base, leverage.up) : null));
  const tools = source.ids.map((id) => leverage.tool[id]);
  return [
    ...parts,
    ...RADIAL.map(([name, words], k) => along(name, words, (index) => radials[index]?.[k])),
    ...["x", "y", "z"].map((name, k) =>
      along(`tool ${name}`, `error along the tool's ${name}`, (index) => tools[index]?.slice(3 * k, 3 * k + 3)),
    ),
    ...leverage.names.map((name, k) => jointPart(name, k, source, leverage)),
  ];
}

const UNITS: Vector3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const RADIAL = [
  ["radial", "radial error"],
  ["tangential", "tangential error"],
  ["up", "error upwards"],
] as const;

export function jointKey(name: string): string {
  return `as ${name}`;
}

/** The error as that of one joint: what it would have to be off by, in least squares. */
function jointPart(name: string, k: number, source: PartSource, leverage: LeverageDocument): Part {
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
  };
}

/** The part that a pattern of the comparison speaks of: its frame and component. */
export function findPart(
  frame: string | undefined,
  component: string | undefined,
  parts: readonly Part[],
): Part | null {
  if (!component) return null;
  const key = frame === "tool" ? `tool ${component}` : component;
  return parts.find((part) => part.key === key) ?? null;
}
