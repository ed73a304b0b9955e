// What an error may be drawn against: anything that differs between the readings, by the name that formulas and the
// program's findings give it.
import {isNumber} from "../../../drawing/numbers.js";
import type {ErrorReading, MomentsDocument, Vector3} from "../server/documents";

export type VariableKind =
  "joint" | "sense" | "load" | "moment" | "temperature" | "time" | "position" | "set-up" | "point" | "order";

export interface Variable {
  key: string;
  name: string;
  unit: string;
  kind: VariableKind;
  /** Names of the levels where values are only that: 0 for the first. */
  levels?: string[];
  of: (reading: ErrorReading, index: number) => number | undefined;
}

export interface VariableSource {
  readings: ErrorReading[];
  joints: string[];
  places: (Vector3 | null)[];
}

/** A moment that differs by less, as a share of the largest, is what rounding leaves of none. */
const LEAST_MOMENT = 1e-6;

/** Of the moments those that differ between the readings. */
function momentVariables(source: VariableSource, found: MomentsDocument | null): Variable[] {
  if (!found) return [];
  const {names, readings, unit} = found;
  const ofReading = (reading: ErrorReading, k: number) => readings[reading.id]?.[k];
  const spans = names.map((_, k) => {
    const values = source.readings.map((reading) => ofReading(reading, k)).filter(isNumber);
    return (
      values.reduce((high, value) => Math.max(high, value), -Infinity) -
      values.reduce((low, value) => Math.min(low, value), Infinity)
    );
  });
  const least = LEAST_MOMENT * Math.max(0, ...spans);
  return names.flatMap((name, k) =>
    spans[k] > least
      ? [{key: name, name, unit, kind: "moment" as const, of: (reading: ErrorReading) => ofReading(reading, k)}]
      : [],
  );
}

/** Names as levels, where some but not all readings share one. */
function groupVariable(
  source: VariableSource,
  kind: "set-up" | "point",
  of: (reading: ErrorReading) => string | undefined,
): Variable[] {
  const levels = [...new Set(source.readings.map((reading) => of(reading) ?? ""))];
  if (levels.length < 2 || levels.length > source.readings.length / 2) return [];
  const at = new Map(levels.map((level, k) => [level, k]));
  return [{key: kind, name: kind, unit: "", kind, levels, of: (reading) => at.get(of(reading) ?? "")}];
}

/** Only what differs between the readings. */
export function variablesOf(
  source: VariableSource,
  unit: Record<string, string | undefined>,
  found: MomentsDocument | null = null,
): Variable[] {
  const all: Variable[] = [
    ...source.joints.map((name, i) => ({
      key: name,
      name,
      unit: unit.angle ?? "",
      kind: "joint" as const,
      of: (reading: ErrorReading) => reading.joints[i],
    })),
    ...source.joints.map((name, i) => ({
      key: `${name}_dir`,
      name: `direction of ${name}`,
      unit: "",
      kind: "sense" as const,
      of: (reading: ErrorReading) => reading.senses?.[i],
    })),
    {key: "load", name: "load", unit: unit.force ?? "", kind: "load", of: (reading) => reading.load},
    ...momentVariables(source, found),
    {
      key: "temperature",
      name: "temperature",
      unit: unit.temperature ?? "",
      kind: "temperature",
      of: (reading) => reading.temperature,
    },
    {key: "time", name: "time", unit: unit.time ?? "", kind: "time", of: (reading) => reading.time},
    ...["x", "y", "z"].map((axis, k) => ({
      key: `position_${axis}`,
      name: `position ${axis}`,
      unit: unit.length ?? "",
      kind: "position" as const,
      of: (_: ErrorReading, index: number) => source.places[index]?.[k],
    })),
    ...groupVariable(source, "set-up", (reading) => reading.setup),
    ...groupVariable(source, "point", (reading) => reading.point),
    {key: "order", name: "order of the readings", unit: "", kind: "order", of: (_, index) => index + 1},
  ];
  return all.filter(({of}) => new Set(source.readings.map(of).filter(isNumber)).size > 1);
}

/** The program's own names of variables: "moment forearm.z", "sense of theta4", "direction of theta4", "theta1 and theta2". */
export function findVariable(name: string | undefined, variables: readonly Variable[]): Variable | null {
  if (!name) return null;
  const first = name.split(" and ")[0];
  const sense = /^(?:sense|direction) of (.+)$/.exec(first);
  const key = sense ? `${sense[1]}_dir` : first.startsWith("moment ") ? first.replace(/\W/g, "_") : first;
  return variables.find((variable) => variable.key === key || variable.name === key) ?? null;
}
