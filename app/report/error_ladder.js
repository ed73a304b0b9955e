// The error of each model in turn, fitted and held-out side by side, over the noise floor.
import {errorUnit} from "../drawing/error_budget.js";
import {axisEnd, barOf, errorOf, floorText, LADDER_WORDS, comparedModels, timesFloor} from "../drawing/ladder.js";
import {short} from "../drawing/numbers.js";
import {append, el, figure, label, notRecorded, svg} from "./elements.js";
import {list, object} from "./values.js";

/// The models of a diagnosis, a comparison or a ladder.
function reportModels(report) {
  const given = list(report.ladder).length > 0 ? list(report.ladder) : list(report.models);
  return comparedModels(given);
}

export function noiseFloorOf(report) { return errorOf(report.noise_floor ?? object(report.rms)?.noise_floor); }

/// "0.0123 in" of an error of the report.
export function errorText(value, report) { return `${short(value)}\u00a0${errorUnit(report)}`; }

export function ladderSection(report) {
  const models = reportModels(report);
  if (models.length === 0) return [notRecorded("The errors of the models")];
  const floor = noiseFloorOf(report);
  const picture = figure("Error of each model", (width) => drawLadder(report, models, floor, width));
  return [
    el("p", {class: "lead"},
       "Root mean square, over the readings in use, of the length of measured less predicted. An overfitted model does well on the readings " +
           "that it was fitted to and badly on those held out."),
    el("div", {class: "card"}, hatching(), picture.element,
       el("ul", {class: "legend"}, el("li", {}, ladderIcon("error-fitted"), LADDER_WORDS.fitted),
          el("li", {}, ladderIcon("error-heldout"), LADDER_WORDS.heldout),
          floor === null ? null : el("li", {}, floorIcon(), LADDER_WORDS.floor)))
  ];
}

function ladderIcon(kind) {
  return svg(
      "svg", {width: 22, height: 14, class: "icon", "aria-hidden": "true"},
      svg("rect", {x: 1, y: 2, width: 20, height: 10, class: kind}));
}

function floorIcon() {
  return svg(
      "svg", {width: 22, height: 14, class: "icon", "aria-hidden": "true"},
      svg("line", {x1: 11, x2: 11, y1: 0, y2: 14, class: "required"}));
}

/// The pattern of held-out bars, once for the page, in a picture without a size.
function hatching() {
  const pattern = svg(
      "pattern", {id: "hatching", width: 7, height: 7, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)"},
      svg("rect", {width: 7, height: 7, class: "hatch-ground"}),
      svg("line", {x1: 0, x2: 0, y1: 0, y2: 7, class: "hatch-line"}));
  return svg("svg", {width: 0, height: 0, class: "patterns", "aria-hidden": "true"}, pattern);
}

function drawLadder(report, models, floor, width) {
  const tall = 17, head = 22, gap = 16, top = 20, left = 2, room = 190;
  const end = axisEnd(models, floor), scale = (width - room) / end;
  const bars = (model) => [["error-fitted", model.fitted], ["error-heldout", model.heldout]].filter(([, v]) => v !== null);
  const height = top + models.reduce((sum, model) => sum + head + bars(model).length * (tall + 3) + gap, 0);
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, width, height, class: "chart"});
  const texts = [];
  let y = top;
  for (const model of models) {
    texts.push(label(left, y + 15, model.name, {class: "part"}));
    y += head;
    for (const [kind, value] of bars(model)) {
      append(drawing, ladderBar(kind, value, {left, y, tall, end, scale}));
      texts.push(ladderText(report, value, floor, {left, y, tall, end, scale}));
      y += tall + 3;
    }
    y += gap;
  }
  if (floor !== null) append(drawing, floorLine(report, floor, left + floor * scale, height, width));
  return append(drawing, texts);
}

/// A bar too long for the axis is cut before its end.
function ladderBar(kind, value, {left, y, tall, end, scale}) {
  const {share, isCut} = barOf(value, end), long = Math.max(1.5, share * end * scale);
  const x = left + long;
  return [
    svg("rect", {x: left, y, width: long, height: tall, rx: 1.5, class: kind}),
    isCut ? svg("path", {d: `M${x - 22} ${y - 2}l8 ${tall + 4}h7l-8 ${- tall - 4}z`, class: "cut"}) : null
  ];
}

function ladderText(report, value, floor, {left, y, tall, end, scale}) {
  const times = timesFloor(value, floor);
  const stop = left + Math.min(value, end) * scale, line = left + (floor ?? 0) * scale;
  return label(
      (stop < line && line < stop + 170 ? line : stop) + 8, y + tall - 4,
      times ? `${errorText(value, report)} (${times})` : errorText(value, report),
      {class: "strong"});
}

function floorLine(report, floor, x, height, width) {
  return [
    svg("line", {x1: x, x2: x, y1: 15, y2: height - 8, class: "required"}),
    label(
        x + 5, 12, floorText(floor, errorUnit(report)),
        {class: "required-text", "text-anchor": x > width - 180 ? "end" : "start"})
  ];
}
