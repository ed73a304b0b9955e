// Touches of holes among the readings of a file, and a further touch as a row of such a file.
import type {MeasurementRow} from "../server/documents";
import {lineOf} from "../error/run_sheet_table";

const HOLE = /^R\d+\s*C\d+$/;

/** Returns the readings in use that are touches of holes of a sheet. */
export function touchesAmong(rows: readonly MeasurementRow[]): MeasurementRow[] {
  return rows.filter(({kind, point, set_aside: isAside}) => kind === "touch" && HOLE.test(point) && !isAside);
}

/** Returns true if all readings are touches of holes, which calibrate a base. */
export function areTouches(rows: readonly MeasurementRow[]): boolean {
  return rows.length > 0 && rows.every(({kind, point}) => kind === "touch" && HOLE.test(point));
}

interface EnteredTouch {
  point: string;
  /** Joint values in the units of the joints. */
  values: readonly number[];
}

/** Returns a touch as a measurement table of one row, with a new id and the load of the other touches. */
export function touchTable(
  {point, values}: EnteredTouch,
  others: readonly MeasurementRow[],
  joints: readonly {name: string; unit: string}[],
  force: string,
): string {
  let count = others.length + 1;
  while (others.some(({id}) => id === `T${count}`)) ++count;
  const columns = ["id", "kind", "point", `load_${force}`, ...joints.map(({name, unit}) => `${name}_${unit}`)];
  const fields = [
    `T${count}`,
    "touch",
    point.replace(/\s/g, ""),
    String(others.at(-1)?.load ?? 0),
    ...values.map(String),
  ];
  return `${lineOf(columns)}\n${lineOf(fields)}\n`;
}
