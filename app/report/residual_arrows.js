// The error at every reading's place as an arrow, seen from above and from the side.
import {arrowPath, usualLargest} from "../drawing/arrows.js";
import {extentOf, fit, heightFor, nearestPlace, toPixel} from "../drawing/frames.js";
import {exact, short} from "../drawing/numbers.js";
import {inPlane, PLANES} from "../drawing/planes.js";
import {rangeOf, roundDown125} from "../drawing/scales.js";
import {circlePath} from "../drawing/shapes.js";
import {isInShare, MOST_ARROWS, shareText} from "../drawing/shares.js";
import {append, el, figure, label, notRecorded, svg} from "./elements.js";
import {conditionsText, placedReadings, readingName, rootMeanSquare, seriesOf, sizeOf} from "./error_series.js";
import {hoverPicture} from "./tooltip.js";
import {lengthText, lengthUnit, numbers} from "./values.js";

/// Of the planes, what a page has room for: seen from above and from one side.
const VIEWS = PLANES.slice(0, 2);
const RESIDUAL_SHARE = 0.11;  // the longest arrow's length, in parts of the picture's width

export function residualMapsSection(report) {
  const readings = placedReadings(report).filter((reading) => numbers(reading.before, 3));
  if (readings.length === 0) return [notRecorded("The errors at the readings")];
  const series = seriesOf(report);
  return [
    el("p", {class: "lead"},
       "From where the model puts the tip towards where it was measured, at every reading's place in the world. " +
           "Arrows that point the same way, or turn with the position, are a pattern; noise is random."),
    ...residualRows(series).map(
        (row) =>
            el("div", {class: "pair maps"}, row.map(([view, entry]) => residualMap(report, readings, view, entry))))
  ];
}

/// Before and after side by side, view by view; with nothing after, the views side by side.
function residualRows(series) {
  const rows = VIEWS.map((view) => series.map((entry) => [view, entry]));
  return series.length === 1 ? [rows.flat()] : rows;
}

function residualMap(report, readings, view, series) {
  const shown = readings.filter((reading) => numbers(reading[series.key], 3));
  const picture = figure(
      `Errors seen ${view.words}, ${series.name}`,
      (width) => drawResiduals(report, readings, shown, view, series, width));
  const sizes = shown.map((reading) => sizeOf(reading[series.key])), share = shareText(shown.length, MOST_ARROWS);
  const title = series.key === "before" ? "Before" : "After";
  return el(
      "div", {class: "card"}, el("h3", {}, `${title}: ${series.name}, seen ${view.words}`), picture.element,
      el("p", {class: "note"},
         `Root mean square ${lengthText(rootMeanSquare(sizes), report)}, largest ${
             lengthText(rangeOf(sizes)[1], report)}.${share && ` ${share}.`}`));
}

/// The frame of a view: equal scales, all readings inside with room for their arrows.
function viewFrame(readings, view, width) {
  const extent = extentOf(readings.map((reading) => inPlane(view, reading.position)));
  const pad = RESIDUAL_SHARE * width + 6, margin = {left: pad, right: pad, top: pad, bottom: pad + 30};
  const height = Math.min(heightFor(extent, width, margin), 0.78 * width + 2 * pad + 30), size = {width, height};
  const camera = fit(extent, size, margin);
  return {height, scale: camera.scale, place: (point) => toPixel(camera, size, ...inPlane(view, point))};
}

/// Both series and both views share the arrows' scale in pixels per length.
function drawResiduals(report, readings, shown, view, series, width) {
  const frame = viewFrame(readings, view, width);
  const pixels = RESIDUAL_SHARE * width / (usualLargest(readings.map((reading) => sizeOf(reading.before))) || 1);
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${frame.height}`, width, height: frame.height, class: "chart"});
  const arrowOf = (reading) => {
    const [dx, dy] = inPlane(view, reading[series.key]);
    return arrowPath(...frame.place(reading.position), pixels * dx, -pixels * dy);
  };
  const drawn = shown.filter((_, index) => isInShare(index, shown.length, MOST_ARROWS));
  append(drawing, [
    svg("path",
        {d: drawn.map((reading) => circlePath(...frame.place(reading.position), 1.3)).join(""), class: "place"}),
    svg("path", {d: drawn.map(arrowOf).join(""), class: `arrow-${series.key}`}),
    scaleBars(report, frame, pixels, width), viewAxes(view, frame, width)
  ]);
  hoverPicture(drawing, width, (px, py) => {
    const near = shown[nearestPlace(shown.map((reading) => frame.place(reading.position)), px, py, 12)];
    return near ? residualTip(report, near) : null;
  });
  return drawing;
}

function scaleBars(report, frame, pixels, width) {
  const y = frame.height - 12, unit = lengthUnit(report);
  const error = roundDown125(RESIDUAL_SHARE * width / pixels), place = roundDown125(0.22 * width / frame.scale);
  const right = 190, end = right + place * frame.scale;
  return [
    svg("path", {d: arrowPath(6, y, error * pixels, 0), class: "arrow-scale"}),
    label(6, y - 9, `arrows: ${exact(error)} ${unit}`),
    svg("path", {d: `M${right} ${y - 4}v8m0 -4H${end}m0 -4v8`, class: "ruler"}),
    label(right, y - 9, `scale of places: ${exact(place)} ${unit}`)
  ];
}

function viewAxes(view, frame, width) {
  const x = width - 52, y = frame.height - 12;
  return [
    svg("path", {d: arrowPath(x, y, 30, 0) + arrowPath(x, y, 0, -30), class: "arrow-scale"}),
    label(x + 33, y + 4, view.key[0]), label(x - 3, y - 34, view.key[1])
  ];
}

function residualTip(report, reading) {
  const unit = lengthUnit(report);
  const errors = (key) => numbers(reading[key], 3) ?
      `${key} ${short(sizeOf(reading[key]))} ${unit}: ${reading[key].map(short).join(", ")}` :
      null;
  return [readingName(reading), errors("before"), errors("after"), conditionsText(report, reading)];
}
