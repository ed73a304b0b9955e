// The touched holes, their residuals and the distances between them.
import {chance, fixed, isNumber, MISSING, plural, short, whole} from "../drawing/numbers.js";
import {roundDown125} from "../drawing/scales.js";
import {MARKED, sigmasText, TOUCH_SIGMAS} from "../drawing/sigma_text.js";
import {colour, el, figure, notRecorded, table} from "./elements.js";
import {drawScale, mapModeOf} from "./error_arrows.js";
import {drawMarks} from "./mark_drawing.js";
import {drawArrowTo, drawSheet} from "./sheet_drawing.js";
import {holeDescriber} from "./sheet_maps.js";
import {hoverHoles} from "./tooltip.js";
import {drawTag} from "./tour_view.js";
import {angleUnit, lengthUnit, list, numbers, object, textOf, tubeName} from "./values.js";

export function touchesSection(report, sheet) {
  const touches = list(report.touches), distances = list(report.distances), calibration = object(report.calibration);
  if (touches.length === 0 && distances.length === 0 && !calibration) return [notRecorded("The calibration touches")];
  const placed = touches.filter((touch) => isNumber(touch.x) && isNumber(touch.y));
  return [
    el("p", {class: "lead"},
       "Holes touched to calibrate the base, and the residual of each touch. " +
           `A residual beyond ${TOUCH_SIGMAS} sigmas is marked: check that touch first.`),
    el("div", {class: "pair"},
       sheet && placed.length > 0 ? touchMap(report, sheet, placed) :
                                    el("div", {class: "card"}, notRecorded("The touches' places")),
       el("div", {class: "card"}, el("h3", {}, "The fitted base"),
          calibration ? calibrationTable(report, calibration) : notRecorded("The fit"))),
    el("div", {class: "pair"},
       el("div", {class: "card"}, el("h3", {}, "Residual at each touch"),
          touches.length > 0 ? residualTable(report, touches) : notRecorded("Residuals")),
       el("div", {class: "card"}, el("h3", {}, "Distances between the holes"),
          distances.length > 0 ? distanceTable(report, distances) : notRecorded("Distance checks"))),
  ];
}

function touchMap(report, sheet, touches) {
  const residuals =
      touches.map((touch) => ({touch, residual: numbers(touch.residual, 3)})).filter((entry) => entry.residual);
  const largest = residuals.reduce((most, {residual}) => Math.max(most, Math.hypot(residual[0], residual[1])), 0);
  const factor = largest > 0 ? roundDown125(0.12 * sheet.width / largest) : 1;
  const picture = figure("The touched holes with their residuals", (width) => {
    const {canvas, context, frame} = drawSheet(sheet, width, {faint: true});
    const places = touches.map((touch) => frame.place([touch.x, touch.y]));
    if (new Set(touches.map((touch) => `${touch.x} ${touch.y}`)).size === 3) drawTriangle(context, places);
    drawMarks(context, {shape: "ring", colour: "accent"}, places, 7);
    touches.forEach((touch, i) => drawTag(context, frame, touchName(touch), places[i][0], places[i][1], true));
    for (const {touch, residual} of residuals) {
      drawArrowTo(
          context, frame.place([touch.x, touch.y]),
          frame.place([touch.x + factor * residual[0], touch.y + factor * residual[1]]), colour("case0"), 2);
    }
    if (residuals.length > 0) drawScale(context, sheet, frame, factor, lengthUnit(report));
    hoverHoles(canvas, frame, holeDescriber(report, sheet, mapModeOf(report, "via_point")));
    return canvas;
  });
  return el(
      "div", {class: "card"}, el("h3", {}, "Touched holes"), picture.element,
      el("p", {class: "note"},
         residuals.length === 0 ? "Residuals are not recorded." :
                                  `Arrows: residuals in the sheet's plane, magnified ${whole(factor)} times.`));
}

function touchName(touch) { return isNumber(touch.row) ? tubeName(touch) : textOf(touch.hole, textOf(touch.id)); }

function drawTriangle(context, places) {
  context.beginPath();
  places.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  context.closePath();
  context.strokeStyle = colour("accent");
  context.setLineDash([5, 4]);
  context.lineWidth = 1.2;
  context.stroke();
  context.setLineDash([]);
}

/// A residual over its sigma as text, marked where it is many.
function inSigmas(value, sigma) {
  if (!isNumber(value) || !isNumber(sigma) || sigma <= 0) return MISSING;
  const {text, isMany} = sigmasText(Math.abs(value) / sigma, TOUCH_SIGMAS);
  return isMany ? el("b", {class: "bad"}, text) : text;
}

function residualTable(report, touches) {
  const unit = lengthUnit(report);
  const rows = touches.map((touch) => {
    const residual = numbers(touch.residual, 3), sigma = numbers(touch.sigma, 3);
    const worst = residual && sigma ? worstAxis(residual, sigma) : null;
    return [
      textOf(touch.id), touchName(touch), ...(residual ?? [null, null, null]).map(short),
      sigma ? sigmaText(sigma) : null, worst === null ? null : inSigmas(residual[worst], sigma[worst])
    ];
  });
  return table(
      ["touch", "hole", `dx, ${unit}`, `dy, ${unit}`, `dz, ${unit}`, `sigma, ${unit}`, "/\u00a0sigma"], rows,
      {text: [0, 1]});
}

/// The axis (0, 1, 2) whose residual is largest against its sigma.
function worstAxis(residual, sigma) {
  const ratios = residual.map((value, axis) => Math.abs(value) / sigma[axis]);
  return ratios.indexOf(Math.max(...ratios));
}

function sigmaText(sigma) {
  return sigma.every((value) => value === sigma[0]) ? short(sigma[0]) : sigma.map(short).join(", ");
}

function distanceTable(report, distances) {
  const unit = lengthUnit(report);
  const rows = distances.map((entry) => {
    const difference = isNumber(entry.by_arm) && isNumber(entry.on_sheet) ? entry.by_arm - entry.on_sheet : null;
    return [
      `${textOf(entry.from)} \u2013 ${textOf(entry.to)}`, fixed(entry.by_arm, 4), fixed(entry.on_sheet, 4),
      short(difference), short(entry.sigma), inSigmas(difference, entry.sigma)
    ];
  });
  return table(["between", `by arm, ${unit}`, `on sheet, ${unit}`, "difference", "sigma", "/\u00a0sigma"], rows);
}

function calibrationTable(report, calibration) {
  const unit = lengthUnit(report), angle = angleUnit(report);
  const base = object(calibration.base) ?? {}, sigma = object(calibration.base_sigma) ?? {};
  const values = (names, given, sigmas, digits, u) => names.map((name, i) => {
    const value = numbers(given, 3), spread = numbers(sigmas, 3);
    return [
      `base ${name}`, value ? `${fixed(value[i], digits)} ${u}` : MISSING,
      spread ? `\u00b1 ${short(spread[i])} ${u}` : MISSING
    ];
  });
  const rows = [
    ...values(["x", "y", "z"], base.position, sigma.position, 4, unit),
    ...values(["roll", "pitch", "yaw"], base.rpy, sigma.rotation, 4, angle)
  ];
  return [
    table(["", "value", "one sigma"], rows),
    el("p", {class: "note"},
       `Residuals: rms ${short(calibration.rms)} ${unit}; ` +
           `chi-square ${short(calibration.chi2)} on ${plural(calibration.degrees_of_freedom, "degree")} of freedom` +
           `${isNumber(calibration.p_value) ? `, ${chance(calibration.p_value)}` : ""}.`,
       verdictOfFit(calibration))
  ];
}

/// What the program says of how the touches fit.
function verdictOfFit(calibration) {
  const words = textOf(calibration.verdict_words, "");
  if (words === "") return null;
  return calibration.verdict === "adequate" ? ` ${words}.` : el("b", {class: "bad"}, ` ${MARKED}${words}.`);
}
