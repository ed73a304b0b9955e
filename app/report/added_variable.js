// What an effect would do beside what is left to explain, coordinate by coordinate.
import {effectTitle, isEnough, keptText, sizeText} from "../drawing/explanations.js";
import {nearestPlace} from "../drawing/frames.js";
import {fixed, isNumber, short} from "../drawing/numbers.js";
import {roundTicks} from "../drawing/scales.js";
import {circlePath} from "../drawing/shapes.js";
import {chartFrame, evenAxis} from "./axes.js";
import {append, el, figure, svg} from "./elements.js";
import {readingName, reportExplanations} from "./error_series.js";
import {hoverPicture} from "./tooltip.js";
import {list} from "./values.js";

export function addedVariableSection(report) {
  const plots = plotsOf(report);
  if (plots.length === 0) return [el("p", {class: "missing"}, emptyAddedText(report))];
  return [
    el("p", {class: "lead"},
       "Each point is one coordinate of one reading. Across: its change by the effect, at the size that was found. Up: " +
           "the residual of the model without the effect. The part that the fitted parameters can absorb is removed " +
           "from both. Points along the line mean that the effect is missing; a round cloud means that it is not."),
    el("div", {class: "pair"}, plots.map((plot) => addedVariableCard(report, plot)))
  ];
}

/// Those of every explanation that is enough; of those that are not, only the closest's.
function plotsOf(report) {
  const isShown = (plot) => !(plot.explanation > 0) || isEnough(reportExplanations(report)[plot.explanation] ?? {});
  return list(report.added_variable)
      .filter((plot) => Array.isArray(plot.points) && plot.points.length > 0 && isShown(plot));
}

function emptyAddedText(report) {
  return report.verdict === "adequate" ? "Nothing is left to explain, so no effect is drawn against it." :
                                         "No effect was fitted, so none is drawn against what is left.";
}

/// The effect that a plot is about, with its numbers.
function effectOfPlot(report, plot) {
  const explanation = reportExplanations(report)[plot.explanation];
  const found = explanation?.effects.find((effect) => effect.effect === plot.effect && effect.at === plot.at);
  return {explanation, effect: found ?? plot};
}

function addedVariableCard(report, plot) {
  const {explanation, effect} = effectOfPlot(report, plot);
  const picture =
      figure(`Added-variable plot of ${effectTitle(plot)}`, (width) => drawAddedVariable(report, plot, effect, width));
  const beside = explanation && explanation.effects.length > 1 ?
      ` beside ${explanation.effects.filter((other) => other !== effect).map(effectTitle).join(", ")}` :
      "";
  return el(
      "div", {class: "card"}, el("h3", {}, `${effectTitle(plot)}${beside}`), picture.element,
      el("p", {class: "note"}, el("b", {}, `Slope ${fixed(plot.slope, 2)}`),
         `, where 1 is the size found: ${sizeText(effect)}.`,
         isNumber(plot.length) ? ` Its effect on all these readings together is ${short(plot.length)} sigmas` : "",
         isNumber(plot.kept_fraction) ? `; ${keptText(plot.kept_fraction)}.` : ""));
}

function drawAddedVariable(report, plot, effect, width) {
  const points = plot.points.filter((point) => isNumber(point[1]) && isNumber(point[2]));
  const height = Math.max(260, Math.min(380, 0.7 * width));
  const x = evenAxis(points.map((point) => point[1])), y = evenAxis(points.map((point) => point[2]));
  const {drawing, at} = chartFrame(
      width, height,
      {...x, ticks: roundTicks(x.from, x.to, width / 80), title: "what the effect would do, noise sigmas"},
      {...y, ticks: roundTicks(y.from, y.to, 6), title: "left to explain, noise sigmas"});
  const radius = points.length > 600 ? 1.7 : 2.4;
  append(drawing, [
    zeroLine(at, x, y),
    svg("path", {d: points.map((point) => circlePath(...at(point[1], point[2]), radius)).join(""), class: "points"}),
    slopeLine(at, plot.slope, x, y)
  ]);
  hoverPicture(drawing, width, (px, py) => addedTip(report, points, at, px, py));
  return drawing;
}

export function zeroLine(at, x, y) {
  const [left, middle] = at(x.from, 0), [right] = at(x.to, 0), [centre, bottom] = at(0, y.from), [, top] = at(0, y.to);
  return svg("path", {d: `M${left} ${middle}H${right}M${centre} ${bottom}V${top}`, class: "zero", fill: "none"});
}

/// The line through the origin, cut to the frame.
function slopeLine(at, slope, x, y) {
  if (!isNumber(slope)) return null;
  const reach = slope === 0 ? x.to : Math.min(x.to, y.to / Math.abs(slope));
  const [x1, y1] = at(-reach, -slope * reach), [x2, y2] = at(reach, slope * reach);
  return svg("line", {x1, y1, x2, y2, class: "slope"});
}

function addedTip(report, points, at, px, py) {
  const near = points[nearestPlace(points.map((point) => at(point[1], point[2])), px, py, 10)];
  if (!near) return null;
  return [
    readingName(list(report.readings)[near[0]]), `the effect would do ${fixed(near[1], 1)} sigmas`,
    `left to explain ${fixed(near[2], 1)} sigmas`
  ];
}
