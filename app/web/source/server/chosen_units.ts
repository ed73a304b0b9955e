// Units of length and angle in which this browser shows and takes figures, whatever the units of the cell's file. The
// choice is kept, and every request names it: the program converts.
import {keep, keptObject} from "../shell/kept";
import type {UnitKind} from "./unit_table";

const KEPT = "tubeplan.units";

function keptUnit(kind: UnitKind): string {
  const kept: unknown = keptObject(KEPT)[kind];
  return typeof kept === "string" ? kept : "";
}

/** The chosen units; an empty one is that of the cell's file. They stay the same until the page is reloaded. */
export const chosenUnits: Readonly<Record<UnitKind, string>> = {length: keptUnit("length"), angle: keptUnit("angle")};

/** Stores a choice and reloads the page, so that no figure in the former unit is left. */
export function chooseUnits(choice: Partial<Record<UnitKind, string>>): void {
  keep<string>(KEPT, {...chosenUnits, ...choice});
  location.reload();
}

/** Returns an address that asks for figures in the chosen units. */
export function inChosenUnits(address: string): string {
  const {length, angle} = chosenUnits;
  return length + angle === "" ? address : `${address}${address.includes("?") ? "&" : "?"}units=${length},${angle}`;
}
