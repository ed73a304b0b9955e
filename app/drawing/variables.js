// Variables that an error may be plotted against: every quantity that differs between readings, under its name in
// formulas and in the pattern search.
import {isNumber, plainUnit} from "./numbers.js";
import {rangeOf} from "./scales.js";

/** @typedef {"joint" | "sense" | "load" | "moment" | "position" | "set-up" | "point" |
 *    "order" | ConditionName} VariableKind */
/** Name of a condition, such as a temperature, that the readings state in a column of their own.
 *  @typedef {string & {}} ConditionName */
/** @typedef {{name: ConditionName, unit: string}} ConditionColumn */
/** Units of lengths, angles and forces, and the conditions that the readings state.
 *  @typedef {{length?: string, angle?: string, force?: string, conditions?: readonly ConditionColumn[]}} VariableUnits */
/** A reading; its conditions are further properties, which conditionOf() returns.
 *  @typedef {{id: string, joints?: number[], senses?: number[], load?: number, setup?: string, point?: string}}
 *    VariedReading */
/** `levels`: names of the values of a categorical variable, whose value is an index into `levels`.
 *  @typedef {{key: string, name: string, unit: string, kind: VariableKind, levels?: string[],
 *    of: (reading: VariedReading, index: number) => number | undefined}} Variable */
/** @typedef {{readings: readonly VariedReading[], joints: readonly {name: string, unit?: string}[],
 *    places: readonly (ArrayLike<number> | null)[]}} VariableSource */
/** Moments about the axes of the arm's rows, keyed by reading id, one value per entry of `names`.
 *  @typedef {{unit: string, names: string[], readings: Record<string, number[]>}} Moments */

/** Smallest relevant range of a moment, as a fraction of the largest range. Smaller ranges are rounding errors. */
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

/** Returns the name of a moment, such as "moment about base link y" for moment_base_link_y. @param {string} symbol */
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
 * Returns a categorical variable with the set-ups or points as levels; empty if there are fewer than two levels or on
 * average fewer than two readings per level.
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
 * Returns the variables that differ between the readings.
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

/** Returns the title of a plot axis, such as "load, lbf". @param {Variable} variable */
export function variableTitle({name, unit}) {
  return `${name}${unit ? `, ${plainUnit(unit)}` : ""}`;
}

/**
 * Returns the variable with a name used by the program, or null: "moment forearm.z", "sense of theta4",
 * "direction of theta4", "cycles of theta1", "theta1 and theta2" (the first of the two).
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
 * Returns an offset from -0.5 to 0.5 that depends on the reading's index, so that all points of one level are visible.
 * @param {number} index
 */
export function levelOffset(index) {
  return ((index * 0.618034) % 1) - 0.5;
}
