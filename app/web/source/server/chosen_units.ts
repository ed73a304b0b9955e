// Units of length and angle in which this browser shows and takes figures, whatever the units of the cell's file. The
// choice is kept, and every request names it: the program converts.
import {keep, keptObject} from "../shell/kept";

const KEPT = "tubeplan.units";

/** Units that can be chosen; files may have others. Sizes of units in metres and radians. */
export const UNIT_CHOICES = {length: ["mm", "in"], angle: ["deg", "rad"]} as const;
export type UnitKind = keyof typeof UNIT_CHOICES;
const SIZES: Record<string, number> = {m: 1, cm: 0.01, mm: 0.001, in: 0.0254, ft: 0.3048, rad: 1, deg: Math.PI / 180};

function keptUnit(kind: UnitKind): string {
  const kept = keptObject<string>(KEPT)[kind];
  return UNIT_CHOICES[kind].find((unit) => unit === kept) ?? "";
}

/** The chosen units; an empty one is that of the cell's file. They stay the same until the page is loaded anew. */
export const chosenUnits: Readonly<Record<UnitKind, string>> = {length: keptUnit("length"), angle: keptUnit("angle")};

/** Keeps a choice and loads the page anew, so that no figure in the former unit is left. */
export function chooseUnit(kind: UnitKind, unit: string): void {
  keep<string>(KEPT, {...chosenUnits, [kind]: unit});
  location.reload();
}

/** Returns an address that asks for figures in the chosen units. */
export function inChosenUnits(address: string): string {
  const {length, angle} = chosenUnits;
  return length + angle === "" ? address : `${address}${address.includes("?") ? "&" : "?"}units=${length},${angle}`;
}

/** Returns a value in another unit of the same kind; the value itself if a unit is unknown. */
export function inUnit(value: number, from: string, to: string): number {
  const factor = from === to ? 1 : SIZES[from] / SIZES[to];
  return Number.isFinite(factor) ? Number((value * factor).toPrecision(12)) : value;
}
