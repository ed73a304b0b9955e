// The clearance over the motion's time, with the required line.
import {exact, isNumber, short} from "../drawing/numbers.js";
import {rootTicks, roundTicks} from "../drawing/scales.js";
import {outlineOf} from "../drawing/shapes.js";
import {requiredText} from "../drawing/visits.js";
import {chartFrame} from "./axes.js";
import {append, el, figure, label, notRecorded, svg} from "./elements.js";
import {lengthUnit, points, textOf} from "./values.js";

export function clearanceSection(report) {
  const curve = points(report.clearance_along);
  const sentence = clearanceSentence(report);
  if (curve.length < 2) return [sentence, notRecorded("The clearance along the tour")];
  const picture = figure("Clearance along the tour", (width) => drawClearance(report, curve, width));
  return [
    sentence,
    el("div", {class: "card"}, picture.element,
       el("p", {class: "note"},
          "The curve is sampled along the motion; the figure above is the least of the whole check. " +
              "The scale is a square root, to show what is small."))
  ];
}

function clearanceSentence(report) {
  const unit = lengthUnit(report);
  if (!isNumber(report.min_clearance)) return notRecorded("The least clearance");
  const required = report.clearance_required;
  const kept = isNumber(required) ? report.min_clearance >= required : null;
  return el(
      "p", {class: "lead"},
      el("b", {class: kept === false ? "bad" : "good"},
         `${kept === false ? "\u25b2 " : ""}Least clearance ${short(report.min_clearance)} ${unit}`),
      isNumber(required) ? ` (${exact(required)} ${unit} required)` : " (no requirement recorded)",
      textOf(report.tightest, "") ? `, ${textOf(report.tightest)}.` : ".");
}

/// The least value in each of `count` stretches of time, so that no narrow dip is lost in drawing.
function leastPerStretch(curve, count) {
  if (curve.length <= 2 * count) return curve;
  const from = curve[0][0], span = curve.at(-1)[0] - from || 1;
  const least = new Map();
  for (const point of curve) {
    const stretch = Math.min(count - 1, Math.floor(count * (point[0] - from) / span));
    if (!least.has(stretch) || point[1] < least.get(stretch)[1]) least.set(stretch, point);
  }
  return [...least.values()];
}

function drawClearance(report, curve, width) {
  const thinned = leastPerStretch(curve, Math.floor(width / 1.5));
  const required = isNumber(report.clearance_required) ? report.clearance_required : null;
  const most = thinned.reduce((top, point) => Math.max(top, point[1]), required ?? 0) || 1;
  const least = thinned.reduce((low, point) => (point[1] < low[1] ? point : low));
  const {drawing, at} = chartFrame(
      width, 260, {
        from: curve[0][0],
        to: curve.at(-1)[0],
        ticks: roundTicks(curve[0][0], curve.at(-1)[0], width / 90),
        title: "time, s"
      },
      {
        from: 0,
        to: most * 1.05,
        ticks: rootTicks(most * 1.05),
        title: `clearance, ${lengthUnit(report)}`,
        scale: (value) => Math.sqrt(Math.max(0, value))
      });
  const line = thinned.map(([t, value]) => at(t, value).join(",")).join(" ");
  append(drawing, [svg("polyline", {points: line, class: "curve"})]);
  if (required !== null) append(drawing, requiredLine(at, curve, required, lengthUnit(report)));
  append(drawing, leastMark(at(...least), least[1], width, lengthUnit(report)));
  return drawing;
}

function requiredLine(at, curve, required, unit) {
  const [x1, y] = at(curve[0][0], required), [x2] = at(curve.at(-1)[0], required);
  return [
    svg("line", {x1, x2, y1: y, y2: y, class: "required"}),
    label(x2 - 4, y + 14, requiredText(required, unit), {"text-anchor": "end", class: "required-text"})
  ];
}

function leastMark([x, y], value, width, unit) {
  const nearEnd = x > width - 130;
  return [
    svg("path", {d: outlineOf("triangle", x, y + 8, 5).fill, class: "least"}),
    label(
        nearEnd ? x - 9 : x + 9, y + 17, `${short(value)} ${unit}`,
        {"text-anchor": nearEnd ? "end" : "start", class: "strong"})
  ];
}
