// Variables that an error may be drawn against: anything that differs between the readings, by its name in formulas and
// in the program's findings.
import {isNumber, plainUnit} from "./numbers.js";
import {rangeOf} from "./scales.js";

/** @typedef {"joint" | "sense" | "load" | "moment" | "position" | "set-up" | "point" |
 *    "order" | ConditionName} VariableKind */
/** A condition that readings state under its name, as the program serves it with its unit.
 *  @typedef {string & {}} ConditionName */
/** @typedef {{name: ConditionName, unit: string}} ConditionColumn */
/** Units of lengths, angles and forces, and the conditions there are.
 *  @typedef {{length?: string, angle?: string, force?: string, conditions?: readonly ConditionColumn[]}} VariableUnits */
/** Conditions are among the numbers of a reading: `conditionOf`.
 *  @typedef {{id: string, joints?: number[], senses?: number[], load?: number, setup?: string, point?: string}}
 *    VariedReading */
/** `levels` are names where values are only that: 0 for the first.
 *  @typedef {{key: string, name: string, unit: string, kind: VariableKind, levels?: string[],
 *    of: (reading: VariedReading, index: number) => number | undefined}} Variable */
/** @typedef {{readings: readonly VariedReading[], joints: readonly {name: string, unit?: string}[],
 *    places: readonly (ArrayLike<number> | null)[]}} VariableSource */
/** Moments about the arm's rows by the id of the reading.
 *  @typedef {{unit: string, names: string[], readings: Record<string, number[]>}} Moments */

/** A moment that differs by less, as a share of the largest, is what rounding leaves of none. */
const LEAST_MOMENT = 1e-6;

/**
 * Returns the moments that differ between the readings.
 * @param {VariableSource} source @param {Moments | null} found
 */
function momentVariables(source, found) {
  if (!found) return [];
  const {names, readings, unit} = found;
  const ofReading = (/** @type {VariedReading} */ reading, /** @type {number} */ k) => readings[reading.id]?.[k];
  const spans = names.map((_, k) => {
    const [low, high] = rangeOf(source.readings.map((reading) => ofReading(reading, k)).filter(isNumber));
    return high - low;
  });
  const least = LEAST_MOMENT * Math.max(0, ...spans);
  return names.flatMap((name, k) =>
    spans[k] > least
      ? [
          variable("moment", name, momentName(name), unit, (/** @type {VariedReading} */ reading) =>
            ofReading(reading, k),
          ),
        ]
      : [],
  );
}

/** "moment about base link y" of the symbol that formulas have for it. @param {string} symbol */
function momentName(symbol) {
  return symbol.replace(/^moment_/, "moment about ").replaceAll("_", " ");
}

/**
 * @param {VariableKind} kind @param {string} key @param {string} name @param {string | undefined} unit
 * @param {Variable["of"]} of @param {string[]} [levels] @returns {Variable}
 */
function variable(kind, key, name, unit, of, levels) {
  return {kind, key, name, unit: unit ?? "", of, ...(levels ? {levels} : {})};
}

/**
 * Names as levels, where some but not all readings share one.
 * @param {VariableSource} source @param {"set-up" | "point"} kind
 * @param {(reading: VariedReading) => string | undefined} of
 */
function groupVariable(source, kind, of) {
  const levels = [...new Set(source.readings.map((reading) => of(reading) ?? ""))];
  if (levels.length < 2 || levels.length > source.readings.length / 2) return [];
  const at = new Map(levels.map((level, k) => [level, k]));
  return [variable(kind, kind, kind, "", (reading) => at.get(of(reading) ?? ""), levels)];
}

/** Returns a reading's value of a condition. @param {VariedReading} reading @param {ConditionName} name */
function conditionOf(reading, name) {
  const numbers = /** @type {Record<string, number | undefined>} */ (/** @type {unknown} */ (reading));
  return numbers[name];
}

/**
 * Only what differs between the readings.
 * @param {VariableSource} source @param {VariableUnits} unit @param {Moments | null} [found]
 * @returns {Variable[]}
 */
export function variablesOf(source, unit, found = null) {
  const {joints, places} = source;
  const all = [
    ...joints.map(({name, unit: own = unit.angle}, i) =>
      variable("joint", name, name, own, (reading) => reading.joints?.[i]),
    ),
    ...joints.map(({name}, i) =>
      variable("sense", `${name}_dir`, `direction of ${name}`, "", (reading) => reading.senses?.[i]),
    ),
    variable("load", "load", "load", unit.force, (reading) => reading.load),
    ...momentVariables(source, found),
    ...(unit.conditions ?? []).map(({name, unit: own}) =>
      variable(name, name, name, own, (reading) => conditionOf(reading, name)),
    ),
    ...["x", "y", "z"].map((axis, k) =>
      variable("position", `position_${axis}`, `position ${axis}`, unit.length, (_, index) => places[index]?.[k]),
    ),
    ...groupVariable(source, "set-up", (reading) => reading.setup),
    ...groupVariable(source, "point", (reading) => reading.point),
    variable("order", "order", "order of the readings", "", (_, index) => index + 1),
  ];
  return all.filter(({of}) => new Set(source.readings.map(of).filter(isNumber)).size > 1);
}

/** "load, lbf" of an axis. @param {Variable} variable */
export function variableTitle({name, unit}) {
  return `${name}${unit ? `, ${plainUnit(unit)}` : ""}`;
}

/**
 * By the program's own names: "moment forearm.z", "sense of theta4", "direction of theta4", "cycles of theta1", "theta1 and theta2".
 * @param {string | undefined} name @param {readonly Variable[]} variables @returns {Variable | null}
 */
export function findVariable(name, variables) {
  if (!name) return null;
  const first = name.split(" and ")[0].replace(/^cycles of /, "");
  const sense = /^(?:sense|direction) of (.+)$/.exec(first);
  const key = sense ? `${sense[1]}_dir` : first.startsWith("moment ") ? first.replace(/\W/g, "_") : first;
  return variables.find((entry) => entry.key === key || entry.name === key) ?? null;
}

/**
 * Beside its level, so that all readings at one are seen: from -0.5 to 0.5 by the reading's index.
 * @param {number} index
 */
export function besideLevel(index) {
  return ((index * 0.618034) % 1) - 0.5;
}
