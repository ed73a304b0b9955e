// The readings of a report about errors, and the two series in which they are shown.
import {conditionsOf} from "../drawing/conditions.js";
import {AS_IT_STANDS, explanationsOf, REFITTED, withIt} from "../drawing/explanations.js";
import {AFTER, BEFORE} from "../drawing/kinds.js";
import {isNumber} from "../drawing/numbers.js";
import {el} from "./elements.js";
import {markIcon} from "./mark_drawing.js";
import {angleUnit, list, numbers, object, textOf} from "./values.js";

/// Its explanations with their effects as objects, best first.
export function reportExplanations(report) {
  const whole = (entry) => ({...entry, effects: list(entry.effects)});
  return explanationsOf({
    explanations: list(report.explanations).map(whole),
    alternatives: (Array.isArray(report.alternatives) ? report.alternatives : []).filter(Array.isArray).map(list)
  });
}

/// Readings with a place in the world.
export function placedReadings(report) {
  return list(report.readings).filter((reading) => numbers(reading.position, 3));
}

export function sizeOf(error) { return numbers(error, 3) ? Math.hypot(...error) : null; }

export function rootMeanSquare(values) {
  const known = values.filter(isNumber);
  return known.length === 0 ? null : Math.sqrt(known.reduce((sum, value) => sum + value * value, 0) / known.length);
}

/// The two series of every picture of errors; the second only where there is one.
export function seriesOf(report) {
  const [first] = reportExplanations(report);
  const before = {key: "before", name: report.page === "diagnosis" ? WITHOUT_IT : AS_IT_STANDS, mark: BEFORE};
  const after = {key: "after", name: first ? withIt(first) : REFITTED, mark: AFTER};
  const hasAfter = list(report.readings).some((reading) => numbers(reading.after, 3));
  return hasAfter ? [before, after] : [before];
}

export function seriesLegend(report) {
  const icon = ({key, mark}) => markIcon(mark, 14, {isHollow: key === "before"});
  return el("ul", {class: "legend"}, seriesOf(report).map((entry) => el("li", {}, icon(entry), entry.name)));
}

export function readingName(reading) { return `reading ${textOf(reading?.id)}`; }

/// "theta1 \u221253.1, theta2 75.7; load 20 lbf".
export function conditionsText(report, reading) {
  const joints = jointNames(report, reading), rows = conditionsOf(reading, joints, object(report.units) ?? {});
  const ofJoints = rows.slice(0, joints.length).map(({name, figure, sense}) => `${name} ${figure}${sense}`);
  const others = rows.slice(joints.length).map(({name, figure, unit}) => `${name}\u00a0${figure}\u00a0${unit}`);
  return [ofJoints.join(", "), ...others].filter((text) => text).join("; ");
}

/// [{name, unit}] of the joints, numbered where the page does not have their names.
export function jointNames(report, reading) {
  const given = list(report.joints);
  return (Array.isArray(reading.joints) ? reading.joints : []).map((_, i) => ({
                                                                     name: textOf(given[i]?.name, `joint ${i + 1}`),
                                                                     unit: textOf(given[i]?.unit, angleUnit(report))
                                                                   }));
}
