// The centring errors as arrows on the sheet, with the scale that they are drawn at.
import {exact, isNumber, plural, short, whole} from "../drawing/numbers.js";
import {roundDown125} from "../drawing/scales.js";
import {modeName, modesOf, scoredCase} from "./cases.js";
import {errorsOf, largestError} from "./centring_errors.js";
import {colour, el, figure, notRecorded} from "./elements.js";
import {landingTarget} from "./landing_targets.js";
import {drawMarks} from "./mark_drawing.js";
import {drawArrowTo, drawSheet} from "./sheet_drawing.js";
import {holeDescriber} from "./sheet_maps.js";
import {hoverHoles} from "./tooltip.js";
import {lengthUnit, list} from "./values.js";

/// The place that an arrow is about.
const PLACE = {shape: "disc", colour: "muted"};
const ARROW_SHARE = 0.06;  // the longest arrow's length, in parts of the sheet's width

/// The factor by which errors are drawn larger than the sheet, so that the longest arrow has a fair length.
function magnificationFor(errors, sheet) {
  const largest = largestError(errors);
  return largest > 0 ? roundDown125(ARROW_SHARE * sheet.width / largest) : 1;
}

export function errorArrowsSection(report, sheet) {
  const modes = modesOf(report).filter((mode) => errorsOf(report, mode.key).length > 0);
  if (!sheet || modes.length === 0) {
    return [notRecorded("Centring errors against a true arm"), predictedErrorNote(report)];
  }
  const before = errorsOf(report, "none");
  const shared = before.length > 0 ? magnificationFor(before, sheet) : null;
  const after = modes.some((mode) => mode.key === "via_point") ? "via_point" : modes[modes.length - 1].key;
  const shown = before.length > 0 && after !== "none" ? ["none", after] : [after];
  return [
    el("p", {class: "lead"},
       "From each hole's centre to the true position of the tip. Each picture states how much larger than the " +
           "sheet its arrows are drawn. Below, the same errors as landing points within one hole."),
    el("div", {class: "pair"}, shown.map((key) => arrowMap(report, sheet, key, shared))),
    el("div", {class: "pair"}, shown.map((key) => landingTarget(report, key))),
  ];
}

function predictedErrorNote(report) {
  const errors = list(report.tubes).map((tube) => tube.predicted_error).filter(isNumber);
  if (errors.length === 0) return null;
  return el(
      "p", {},
      `By the plan's own model the tip is at most ${short(Math.max(...errors))} ${lengthUnit(report)} from a ` +
          `hole's centre over ${plural(errors.length, "tube")}.`);
}

/// One map of arrows; it shares the scale of the map before unless its arrows would then be too short to see.
function arrowMap(report, sheet, key, shared) {
  const errors = errorsOf(report, key);
  const own = magnificationFor(errors, sheet);
  const factor = shared !== null && own < 3 * shared ? shared : own;
  const unit = lengthUnit(report);
  const picture = figure(`Centring-error arrows, ${modeName(report, key)}`, (width) => {
    const {canvas, context, frame} = drawSheet(sheet, width, {faint: true});
    const fine = errors.length > 400 ? 0.5 : 1;
    for (const {tube, dx, dy} of errors) {
      const from = frame.place([tube.x, tube.y]);
      const to = frame.place([tube.x + factor * dx, tube.y + factor * dy]);
      drawMarks(context, PLACE, [from], 1.4 * fine);
      drawArrowTo(context, from, to, colour(key === "none" ? "case0" : "accent"), 1.6 * fine);
    }
    drawScale(context, sheet, frame, factor, unit);
    hoverHoles(canvas, frame, holeDescriber(report, sheet, mapModeOf(report, key)));
    return canvas;
  });
  const note = shared !== null && factor !== shared ? ` (${exact(factor / shared)} times the scale before)` : "";
  const mean = errors.reduce((sum, entry) => sum + entry.error, 0) / errors.length;
  return el(
      "div", {class: "card"}, el("h3", {}, `${key === "none" ? "Before" : "After"}: ${modeName(report, key)}`),
      picture.element,
      el("p", {class: "note"}, el("b", {}, `Arrows magnified ${whole(factor)} times${note}.`),
         ` Mean error ${short(mean)} ${unit}, largest ${short(largestError(errors))} ${unit}.`));
}

export function mapModeOf(report, key) {
  return {key, name: modeName(report, key), caseOf: (tube) => scoredCase(tube, key, report.steps)};
}

/// The arrow of a round length in the corner that the round sheet leaves free: what length on the picture is what
/// error.
export function drawScale(context, sheet, frame, factor, unit) {
  const length = roundDown125(ARROW_SHARE * sheet.width / factor);
  const y = frame.isAbove ? frame.height - 14 : 14;
  drawArrowTo(context, [6, y], [6 + length * factor * frame.scale, y], colour("ink"), 2);
  context.fillStyle = colour("ink");
  context.textAlign = "left";
  context.textBaseline = y < 30 ? "top" : "bottom";
  context.fillText(`${exact(length)} ${unit}`, 6, y < 30 ? y + 7 : y - 7);
}
