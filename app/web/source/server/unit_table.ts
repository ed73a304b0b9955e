// Conversion of numbers by the program's table of units.

/** Units that can be chosen; `factor` is the size of a unit in metres or radians. */
export interface UnitTable {
  length: {name: string; factor: number}[];
  angle: {name: string; factor: number}[];
}
export type UnitKind = keyof UnitTable;

/** Returns a value in another unit of the same kind; the value itself if a unit is unknown. */
export function inUnit(value: number, from: string, to: string, table: UnitTable): number {
  const factorOf = (unit: string) => [...table.length, ...table.angle].find(({name}) => name === unit)?.factor ?? NaN;
  const factor = from === to ? 1 : factorOf(from) / factorOf(to);
  return Number.isFinite(factor) ? Number((value * factor).toPrecision(12)) : value;
}
