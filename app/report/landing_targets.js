// Where the tips land about the centre of one hole, with the rings of the tool's steps.
import {UNSCORED} from "../drawing/kinds.js";
import {exact, isNumber, plural, short} from "../drawing/numbers.js";
import {stepCountOf, stepMark} from "../drawing/steps.js";
import {modeName, scoredCase} from "./cases.js";
import {errorsOf, largestError} from "./centring_errors.js";
import {append, el, figure, label, svg} from "./elements.js";
import {svgMark} from "./mark_drawing.js";
import {lengthUnit, list, object, points, tubeName} from "./values.js";

/// One target: the landing points of a mode, in the same view as the sheet; points past the rim sit on it.
export function landingTarget(report, key) {
  const errors = errorsOf(report, key);
  const tolerances = list(report.steps).map((step) => step.tolerance).filter((value) => isNumber(value) && value > 0);
  const mirror = object(report.sheet)?.viewed_from === "above" ? 1 : -1;
  const reach = targetReach(tolerances, largestError(errors));
  const outside = errors.filter((entry) => Math.hypot(entry.dx, entry.dy) > reach).length;
  const picture = figure(
      `Landing points about a hole's centre, ${modeName(report, key)}`,
      (width) => drawTarget({errors, tolerances, reach, mirror, report, key}, width));
  return el(
      "div", {class: "card"}, el("h3", {}, `Within one hole: ${modeName(report, key)}`), picture.element,
      el("p", {class: "note"},
         `A ring is the centring error up to which a step of the tool enters${ringText(report)}; the rim is at ` +
             `${short(reach)} ${lengthUnit(report)}. `,
         outside ? `${plural(outside, "tube")} beyond the rim ${outside === 1 ? "is" : "are"} drawn on it.` : null));
}

/// The error at the rim: all rings with room to spare, the errors where they are not far beyond the largest ring.
function targetReach(tolerances, largest) {
  if (tolerances.length === 0) return largest > 0 ? 1.1 * largest : 1;
  const ring = Math.max(...tolerances);
  return Math.max(1.25 * ring, Math.min(1.1 * largest, 3 * ring));
}

function ringText(report) {
  const steps = list(report.steps).filter((step) => isNumber(step.tolerance));
  if (steps.length === 0) return "";
  return ` (${steps.map((step, i) => `step ${i + 1}: ${exact(step.tolerance)}`).join(", ")} ${lengthUnit(report)})`;
}

function drawTarget({errors, tolerances, reach, mirror, report, key}, width) {
  const height = Math.min(width, 340), middle = [width / 2, height / 2], rim = height / 2 - 12;
  const scale = rim / reach;
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, width, height, class: "chart"});
  drawing.append(svg("circle", {cx: middle[0], cy: middle[1], r: rim, class: "rim"}));
  const ringNames = tolerances.map((tolerance, i) => {
    drawing.append(svg("circle", {cx: middle[0], cy: middle[1], r: scale * tolerance, class: "tolerance"}));
    const name =
        label(middle[0], middle[1] - scale * tolerance - 3, `${i + 1}`, {"text-anchor": "middle", class: "ring-name"});
    return scale * tolerance > 8 ? name : null;
  });
  for (const {tube, dx, dy} of errors)
    drawing.append(landingMark(tube, [mirror * dx, -dy], {reach, scale, middle, report, key}));
  append(
      drawing,
      [svg("path", {d: `M${middle[0] - 5} ${middle[1]}h10M${middle[0]} ${middle[1] - 5}v10`, class: "centre"}), ...ringNames]);
  return drawing;
}

function landingMark(tube, offset, {reach, scale, middle, report, key}) {
  const error = Math.hypot(...offset), within = Math.min(1, reach / (error || 1));
  const index = scoredCase(tube, key, report.steps);
  const mark = index === null ? UNSCORED : stepMark(index, stepCountOf(report), object(report.base));
  const place = middle.map((value, k) => value + scale * within * offset[k]);
  return svgMark(
      mark, ...place, 4.2, {}, svg("title", {}, `${tubeName(tube)}: ${short(error)} ${lengthUnit(report)}`));
}
