// The errors as what a cause makes of them: against the variable that its law depends on, the law drawn through them.
import {partsOf} from "../drawing/error_parts.js";
import {explanationTitle, isEnough} from "../drawing/explanations.js";
import {nearestPlace} from "../drawing/frames.js";
import {exact, isNumber, plainUnit, short} from "../drawing/numbers.js";
import {
  commonMost,
  errorsOfExplanation,
  errorsOfRefit,
  letterOf,
  levelRange,
  levelTicks,
  partRange,
  plotted,
  spreadAtLevel,
  viewOfPair,
  viewOfPatterns,
  viewOfRemainder
} from "../drawing/reading_errors.js";
import {rangeOf, roundTicks, widened} from "../drawing/scales.js";
import {hollowPath} from "../drawing/shapes.js";
import {isInShare, MOST_MARKS, shareText} from "../drawing/shares.js";
import {variablesOf, variableTitle} from "../drawing/variables.js";
import {chartFrame} from "./axes.js";
import {append, el, figure, svg} from "./elements.js";
import {conditionsText, readingName, reportExplanations} from "./error_series.js";
import {markIcon} from "./mark_drawing.js";
import {hoverPicture} from "./tooltip.js";
import {list, numbers, object, textOf} from "./values.js";

const MOST_SIDE_BY_SIDE = 4;

/// The errors before and after: of each explanation that is left, best first; of a comparison those of its refit.
export function errorPairsOf(report) {
  const readings = list(report.readings).filter((reading) => numbers(reading.before, 3));
  const places = readings.map((reading) => numbers(reading.position, 3));
  const joints = list(report.joints);
  if (report.page !== "diagnosis") {
    const after = readings.map((reading) => numbers(reading.after, 3));
    return [errorsOfRefit(readings, places, joints.map(({name}) => name), readings.map(({before}) => before), after)];
  }
  const explanations = reportExplanations(report).filter((entry) => Array.isArray(entry.effects));
  const whole = readings.map(
      (reading) => ({...reading, explained: reading.explained ?? [], position: numbers(reading.position, 3)}));
  const count = report.verdict === "ambiguous" ? Math.min(MOST_SIDE_BY_SIDE, explanations.filter(isEnough).length) : 1;
  const indices = Array.from({length: Math.max(1, count)}, (_, index) => index);
  return indices.map((index) => errorsOfExplanation({readings: whole, joints, explanations}, index));
}

/// What the errors can be drawn against, and as which parts.
export function errorAxesOf(report, {readings, places}) {
  const unit = object(report.units) ?? {};
  const joints = list(report.joints);
  return {
    variables: variablesOf({readings, joints, places}, unit, object(report.moments)),
    parts: partsOf({ids: readings.map(({id}) => id), places, unit, leverage: object(report.leverage)})
  };
}

/// Where an explanation's law lives; of what is unexplained where it follows something, else what the search found.
function lawViewOf(report, pair, {variables, parts}) {
  return viewOfPair(pair, variables, parts) ?? viewOfRemainder(report, pair, variables, parts) ??
      viewOfPatterns(foundPatterns(report), variables, parts);
}

/// The findings of the pattern search, the most significant first.
function foundPatterns(report) {
  const findings = list(report.tested).filter(({finding}) => finding === true);
  return list(report.patterns).length > 0 ? list(report.patterns) : findings.sort((a, b) => a.p_value - b.p_value);
}

export function errorLawSection(report) {
  const pairs = errorPairsOf(report), axes = errorAxesOf(report, pairs[0]);
  const plots = pairs.flatMap((pair) => {
    const view = pair.readings.length > 0 ? lawViewOf(report, pair, axes) : null;
    return view ? [[pair, view]] : [];
  });
  if (plots.length === 0) return [el("p", {class: "lead"}, "The errors follow no variable of the readings.")];
  const most = plots.length > 1 ? commonMost(...plots) : null;
  const cards =
      plots.map(([pair, view], index) => lawCard(report, pair, view, most, plots.length > 1 ? letterOf(index) : ""));
  return [
    el("p", {class: "lead"}, leadOf(plots)), lawLegend(plots[0][0], plots.some(([pair]) => pair.causes.length > 0)),
    el("div", {class: cards.length > 1 ? "pair" : "alone"}, cards)
  ];
}

function leadOf(plots) {
  const isLaw = plots.some(([pair]) => pair.causes.length > 0);
  const cause = plots.length > 1 ? "Each explanation" : "The cause";
  return isLaw ?
      `${cause} is drawn against the variable that its law depends on, and as the error that it would explain. ` +
          "The line is the law, its band the spread of what it does there. Where the law is right the means before lie on it, " +
          "and those after lie at zero." :
      "The errors against what they follow most, with means of bins.";
}

/// What the marks of a pair are, how many are drawn, and what else stands in the picture: [sign of the style sheet, words].
export function pairLegend(pair, signs, most) {
  const items =
      pair.series.map((series, k) => [markIcon(series.mark, 14, {isHollow: k === 0}), series.name.split(":")[0]]);
  const others = signs.map(([name, words]) => [el("i", {class: name, "aria-hidden": "true"}), words]);
  const share = shareText(pair.readings.length, most);
  return el("ul", {class: "legend"}, [...items, ...others, ...(share ? [share] : [])].map((item) => el("li", {}, item)));
}

function lawLegend(pair, hasLaw) {
  const means = ["mean-sign", `means ${pair.judged === 0 ? "before" : "after"}, two standard errors to both sides`];
  return pairLegend(pair, hasLaw ? [means, ["law-sign", "law and its spread"]] : [means], MOST_MARKS);
}

function lawCard(report, pair, view, most, letter) {
  const title = pair.causes.length > 0 ? explanationTitle({effects: pair.causes}) : "";
  const heading = [letter, title].filter((text) => text !== "").join(": ");
  const words = `${view.part.title} against ${view.variable.name}`;
  const picture =
      figure(`${heading === "" ? "" : `${heading}: `}${words}`, (width) => drawLaw(report, pair, view, most, width));
  return el("div", {class: "card"}, heading === "" ? null : el("h3", {}, heading), picture.element);
}

function drawLaw(report, pair, view, most, width) {
  const {variable, part} = view, figures = plotted(pair, view), {isLevel, xs, values, means, law} = figures;
  const known = xs.filter(isNumber);
  const [low, high] = rangeOf(known);
  const [from, to] = isLevel ? levelRange(variable) : widened(low, high);
  const [bottom, top] = partRange(part, ...rangeOf(values.flat().filter(isNumber)), most);
  const height = Math.max(260, Math.min(420, 0.55 * width));
  const levels = isLevel ? {text: (tick) => variable.levels?.[tick] ?? exact(tick)} : {};
  const x =
      {from, to, ticks: isLevel ? levelTicks(variable) : roundTicks(low, high, Math.max(2, width / 80)), ...levels};
  const y = {from: bottom, to: top, room: 66, ticks: roundTicks(bottom, top, 5)};
  const {drawing, at} = chartFrame(
      width, height, {...x, title: variableTitle(variable)}, {...y, title: `${part.title}, ${plainUnit(part.unit)}`});
  if (part.isSigned) append(drawing, [noErrorLine(at, x)]);
  append(drawing, lawMarks(law, isLevel, at));
  const places = values.map((column) => column.map((value, index) => {
    const x = xs[index];
    return isNumber(x) && isNumber(value) ? at(spreadAtLevel(isLevel, x, index), value) : null;
  }));
  const isShown = (place, index) => place !== null && isInShare(index, pair.readings.length, MOST_MARKS);
  append(drawing, places.map((series, k) => pointMarks(pair.series[k].mark.shape, series.filter(isShown), k)));
  append(drawing, means.map((bin) => meanMark(bin, at)));
  hoverPicture(drawing, width, (px, py) => lawTip(report, pair, view, places, px, py));
  return drawing;
}

function noErrorLine(at, {from, to}) {
  const [left, middle] = at(from, 0), [right] = at(to, 0);
  return svg("path", {d: `M${left} ${middle}H${right}`, class: "zero", fill: "none"});
}

export function pointMarks(shape, places, k) {
  const radius = places.length > 600 ? 1.7 : k === 0 ? 3 : 2.4;
  const d = places.map(([x, y]) => hollowPath(shape, x, y, radius)).join("");
  return svg("path", {d, class: k === 0 ? "points-before" : "points-after"});
}

/// The law as a line with its band; of levels a short line each.
function lawMarks(law, isLevel, at) {
  if (law.length === 0) return [];
  if (isLevel || law.length === 1) return law.flatMap((bin) => levelMarks(bin, isLevel ? 0.3 : 0, at));
  const line = (of) => law.map((bin) => at(bin.x, of(bin)));
  const path = (places) => places.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L");
  const band = [...line((bin) => bin.mean + bin.spread), ...line((bin) => bin.mean - bin.spread).reverse()];
  return [
    svg("path", {d: `M${path(band)}Z`, class: "law-band"}),
    svg("path", {d: `M${path(line((bin) => bin.mean))}`, class: "law-line"})
  ];
}

function levelMarks({from, to, mean, spread}, half, at) {
  const [left, middle] = at(from - half, mean), [right] = at(to + half, mean);
  const [, high] = at(from, mean + spread), [, low] = at(from, mean - spread);
  return [
    svg("rect", {x: left, y: high, width: right - left, height: low - high, class: "law-band"}),
    svg("line", {x1: left, x2: right, y1: middle, y2: middle, class: "law-line"})
  ];
}

function meanMark({x, mean, error}, at) {
  const [px, py] = at(x, mean), [, high] = at(x, mean + 2 * error), [, low] = at(x, mean - 2 * error);
  return svg(
      "g", {class: "mean"}, svg("path", {d: `M${px} ${high}V${low}M${px - 4} ${high}h8M${px - 4} ${low}h8`}),
      svg("rect", {x: px - 3, y: py - 3, width: 6, height: 6}));
}

function lawTip(report, pair, {variable, part}, places, px, py) {
  const near = places.map((series) => nearestPlace(series, px, py, 10)), k = near.findIndex((index) => index >= 0);
  if (k < 0) return null;
  const reading = pair.readings[near[k]];
  const errors = pair.series.map(({name, errors: of}) => {
    const error = of[near[k]], value = error ? part.of(error, near[k]) : null;
    return `${name.split(":")[0]} ${short(value)} ${plainUnit(part.unit)}`;
  });
  const x = variable.of(reading, near[k]);
  const at = `${variable.name} ${variable.levels?.[x] ?? short(x)} ${plainUnit(variable.unit)}`;
  return [readingName(reading), at.trim(), ...errors, conditionsText(report, reading)].filter(
      (text) => textOf(text, "") !== "");
}
