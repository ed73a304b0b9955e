// The readings as table rows: their data, the search, and the order.
import {isNumber} from "../../../drawing/numbers.js";
import type {MeasurementRow, Units, Vector3} from "../server/documents";
import type {ReadingErrors} from "./residuals";

export interface ReadingRow {
  id: string;
  name: string;
  load: number | null;
  joints: number[];
  senses: number[];
  before: number | null;
  after: number | null;
  /** Unit of the errors before and after: the unit of angles if the reading measures only orientation. */
  sizeUnit: string;
  sigmas: number | null;
  isAside: boolean;
  isHeldOut: boolean;
}

export interface Column {
  key: string;
  words: string;
  unit: string;
  /** Width of the table column, in CSS. */
  width: string;
  of: (row: ReadingRow) => number | string | null;
}

function sizeOf(error: Vector3 | null | undefined): number | null {
  return error ? Math.hypot(...error) : null;
}

/** Returns a row for each reading; readings set aside have the error relative to the given model. */
export function rowsOf(
  measured: readonly MeasurementRow[],
  errors: ReadingErrors | null,
  lengthUnit: string,
): ReadingRow[] {
  const at = new Map(errors?.readings.map((reading, index) => [reading.id, index]));
  return measured.map((row) => {
    const index = row.set_aside ? undefined : at.get(row.id);
    const last = (errors?.series.length ?? 1) - 1;
    const own = index === undefined || !errors ? null : errors;
    const stands = row.position && row.tip ? (row.position.map((value, k) => value - row.tip![k]) as Vector3) : null;
    return {
      id: row.id,
      name: [row.point, row.setup].filter((text) => text).join(" "),
      load: row.load ?? null,
      joints: row.joints,
      senses: row.senses ?? [],
      before: own ? own.sizes[0][index!] : sizeOf(stands),
      after: own && last > 0 ? own.sizes[last][index!] : null,
      sizeUnit: own?.sizeUnits[index!] ?? lengthUnit,
      sigmas: own ? (own.sigmas[last]?.[index!] ?? own.sigmas[0]?.[index!] ?? null) : null,
      isAside: row.set_aside,
      isHeldOut: row.held_out === true,
    };
  });
}

/**
 * Returns the common unit of all errors; empty if lengths and angles are mixed, so that every row must state its unit.
 */
export function sizeUnitOf(rows: readonly ReadingRow[], lengthUnit: string): string {
  const units = new Set(rows.filter((row) => row.before !== null || row.after !== null).map((row) => row.sizeUnit));
  return units.size > 1 ? "" : ([...units][0] ?? lengthUnit);
}

export function columnsOf(
  joints: readonly {name: string; unit: string}[],
  {length, force}: Units,
  sizeUnit = length,
): Column[] {
  const width = (plain: string) => (sizeUnit === "" ? "84px" : plain);
  const id = (row: ReadingRow) => (isNumber(Number(row.id)) ? Number(row.id) : row.id);
  return [
    {key: "id", words: "id", unit: "", width: "44px", of: id},
    {key: "sigma", words: "σ", unit: "", width: "60px", of: (row) => row.sigmas},
    {key: "before", words: "before", unit: sizeUnit, width: width("66px"), of: (row) => row.before},
    {key: "after", words: "after", unit: sizeUnit, width: width("58px"), of: (row) => row.after},
    {key: "name", words: "point", unit: "", width: "minmax(56px,1fr)", of: (row) => row.name},
    {key: "load", words: "load", unit: force, width: "56px", of: (row) => row.load},
    ...joints.map(({name, unit}, k) => ({
      key: name,
      words: name,
      unit,
      width: "70px",
      of: (row: ReadingRow) => row.joints[k],
    })),
  ];
}

/** Returns the rows sorted by a column; missing values come last in both directions. */
export function sorted(rows: readonly ReadingRow[], column: Column, isDown: boolean): ReadingRow[] {
  const missing = (value: number | string | null) => value === null || value === undefined;
  return [...rows].sort((a, b) => {
    const [x, y] = [column.of(a), column.of(b)];
    if (missing(x) || missing(y)) return Number(missing(x)) - Number(missing(y));
    const order =
      typeof x === "number" && typeof y === "number"
        ? x - y
        : String(x).localeCompare(String(y), "en", {numeric: true});
    return isDown ? -order : order;
  });
}

/**
 * Returns the rows that satisfy all words of the text. A plain word is searched for in id and point; "sigma>3",
 * "theta3<=40", "aside" and "held-out" are conditions.
 */
export function filtered(rows: readonly ReadingRow[], text: string, columns: readonly Column[]): ReadingRow[] {
  const tests = text
    .trim()
    .split(/\s+/)
    .filter((word) => word !== "")
    .map((word) => testOf(word, columns));
  return rows.filter((row) => tests.every((test) => test(row)));
}

/** Returns the first word with <, > or = whose column or number is invalid; null if there is none. */
export function wrongWord(text: string, columns: readonly Column[]): string | null {
  return text.split(/\s+/).find((word) => /[<>=]/.test(word) && !questionOf(word, columns)) ?? null;
}

function questionOf(word: string, columns: readonly Column[]) {
  const found = /^([^<>=]+)(<=|>=|<|>|=)(-?[\d.]+)$/.exec(word);
  const column = found && columns.find(({key, words}) => key === found[1] || words === found[1]);
  const limit = Number(found?.[3]);
  return column && Number.isFinite(limit) ? {column, sign: found[2], limit} : null;
}

function testOf(word: string, columns: readonly Column[]): (row: ReadingRow) => boolean {
  if (word === "aside") return (row) => row.isAside;
  if (word === "held-out") return (row) => row.isHeldOut;
  const question = questionOf(word, columns);
  if (!question) return (row) => `${row.id} ${row.name}`.toLowerCase().includes(word.toLowerCase());
  const {column, sign, limit} = question;
  const holds: Record<string, (value: number) => boolean> = {
    "<": (value) => value < limit,
    "<=": (value) => value <= limit,
    ">": (value) => value > limit,
    ">=": (value) => value >= limit,
    "=": (value) => value === limit,
  };
  return (row) => {
    const value = column.of(row);
    return typeof value === "number" && holds[sign](value);
  };
}
