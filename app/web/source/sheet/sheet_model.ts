// A tube sheet as flat arrays, with its extent, the hole nearest to a place, and the ticks of its rows and columns.
import type {SheetDocument} from "../server/documents";

export interface Tick {
  value: number;
  place: number;
}

export interface SheetModel {
  name: string;
  leg: string;
  viewingSide: string;
  unit: string;
  pitch: number;
  holeRadius: number;
  count: number;
  row: Int32Array;
  column: Int32Array;
  legs: string[];
  u: Float64Array;
  v: Float64Array;
  world: Float64Array;
  state: Uint8Array;
  states: string[];
  extent: {left: number; right: number; bottom: number; top: number};
  radius: number;
  /** A sheet of one leg ends at the divider plate. */
  isOneLeg: boolean;
  manway: SheetDocument["manway"];
  rowTicks: Tick[];
  columnTicks: Tick[];
  nearest: (u: number, v: number, reach: number) => number;
  find: (row: number, column: number) => number;
}

export function makeSheetModel(document: SheetDocument): SheetModel {
  const {holes} = document;
  const u = Float64Array.from(holes.u),
    v = Float64Array.from(holes.v);
  const count = u.length;
  const extent = extentOf(u, v);
  const row = Int32Array.from(holes.row),
    column = Int32Array.from(holes.column);
  const world = new Float64Array(3 * count);
  for (let i = 0; i < count; ++i) world.set([holes.x[i], holes.y[i], holes.z[i]], 3 * i);
  const isOneLeg = extent.bottom > -0.25 * extent.top || extent.top < -0.25 * extent.bottom;
  const pitch = document.pitch > 0 ? document.pitch : (extent.right - extent.left) / Math.sqrt(Math.max(1, count));
  const names = new Map<number, number>();
  for (let i = 0; i < count; ++i) names.set(row[i] * 4096 + column[i], i);
  return {
    name: document.name,
    leg: document.leg,
    viewingSide: document.viewing_side,
    unit: typeof document.units === "string" ? document.units : (document.units?.length ?? ""),
    pitch,
    holeRadius: document.hole_diameter > 0 ? document.hole_diameter / 2 : 0.35 * pitch,
    count,
    row,
    column,
    legs: Array.from({length: count}, (_, i) =>
      typeof holes.leg?.[i] === "string" ? String(holes.leg[i]) : document.leg,
    ),
    u,
    v,
    world,
    state: Uint8Array.from(holes.state),
    states: holes.states,
    extent,
    radius: radiusOf(u, v) + 1.4 * pitch,
    isOneLeg,
    manway: document.manway,
    rowTicks: ticksOf(row, v, pitch),
    columnTicks: ticksOf(column, u, pitch),
    nearest: finderOf(u, v, pitch, extent),
    find: (r, c) => names.get(r * 4096 + c) ?? -1,
  };
}

function extentOf(u: Float64Array, v: Float64Array) {
  const extent = {left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
  for (let i = 0; i < u.length; ++i) {
    extent.left = Math.min(extent.left, u[i]);
    extent.right = Math.max(extent.right, u[i]);
    extent.bottom = Math.min(extent.bottom, v[i]);
    extent.top = Math.max(extent.top, v[i]);
  }
  return u.length > 0 ? extent : {left: -1, right: 1, bottom: -1, top: 1};
}

function radiusOf(u: Float64Array, v: Float64Array): number {
  let radius = 0;
  for (let i = 0; i < u.length; ++i) radius = Math.max(radius, Math.hypot(u[i], v[i]));
  return radius;
}

/** Every tenth number with its place; none where one number is not one place (tubes numbered within each row). */
export function ticksOf(numbers: Int32Array, places: Float64Array, pitch: number): Tick[] {
  const known = new Map<number, number>();
  for (let i = 0; i < numbers.length; ++i) {
    const place = known.get(numbers[i]);
    if (place === undefined) known.set(numbers[i], places[i]);
    else if (Math.abs(place - places[i]) > 0.1 * pitch) return [];
  }
  return [...known].map(([value, place]) => ({value, place})).sort((a, b) => a.value - b.value);
}

/** Buckets of two pitches: a look into nine of them finds the nearest hole. */
function finderOf(u: Float64Array, v: Float64Array, pitch: number, extent: SheetModel["extent"]) {
  const size = 2 * pitch;
  const across = Math.max(1, Math.ceil((extent.right - extent.left) / size) + 1);
  const buckets = new Map<number, number[]>();
  const bucketOf = (x: number, y: number) =>
    Math.floor((y - extent.bottom) / size) * across + Math.floor((x - extent.left) / size);
  for (let i = 0; i < u.length; ++i) {
    const key = bucketOf(u[i], v[i]);
    const bucket = buckets.get(key);
    if (bucket) bucket.push(i);
    else buckets.set(key, [i]);
  }
  return (x: number, y: number, reach: number): number => {
    let best = -1,
      least = reach * reach;
    for (let dy = -1; dy <= 1; ++dy) {
      for (let dx = -1; dx <= 1; ++dx) {
        for (const i of buckets.get(bucketOf(x + dx * size, y + dy * size)) ?? []) {
          const distance = (u[i] - x) ** 2 + (v[i] - y) ** 2;
          if (distance < least) [best, least] = [i, distance];
        }
      }
    }
    return best;
  };
}

export function holeName(sheet: SheetModel, hole: number): string {
  return `R${sheet.row[hole]} C${sheet.column[hole]}`;
}

export function legWords(leg: string): string {
  const words: Record<string, string> = {hot: "hot leg", cold: "cold leg", full: "full sheet"};
  return words[leg] ?? leg;
}

/** The hole next to another in a direction of the picture, for the arrow keys. */
export function neighbour(sheet: SheetModel, from: number, du: number, dv: number): number {
  let best = from,
    least = Infinity;
  const size = Math.hypot(du, dv);
  for (let i = 0; i < sheet.count; ++i) {
    const x = sheet.u[i] - sheet.u[from],
      y = sheet.v[i] - sheet.v[from];
    const along = (x * du + y * dv) / size;
    if (along < 0.2 * sheet.pitch) continue;
    const beside = Math.abs(x * dv - y * du) / size;
    const cost = along + 3 * beside;
    if (cost < least) [best, least] = [i, cost];
  }
  return best;
}
