// The tip's trace in the order of visiting, and a walk along it.
import {distance} from "../drawing/frames.js";
import {isNumber, plural} from "../drawing/numbers.js";
import {colour, el, figure, notRecorded} from "./elements.js";
import {mapModeOf} from "./error_arrows.js";
import {drawMarks} from "./mark_drawing.js";
import {drawArrowTo, drawSheet, FONT} from "./sheet_drawing.js";
import {markRadius} from "./sheet_frame.js";
import {holeDescriber, visitOf} from "./sheet_maps.js";
import {hoverHoles} from "./tooltip.js";
import {list, points, tubeName} from "./values.js";

/// The tour with the length run at each point and the point at which each tube is reached.
function readTour(report, pitch) {
  const trace = points(report.tour);
  const lengths = [0];
  for (let i = 1; i < trace.length; ++i) lengths.push(lengths[i - 1] + distance(trace[i - 1], trace[i]));
  const tubes = list(report.tubes).filter((tube) => isNumber(tube.x) && isNumber(tube.y));
  const stops = [];
  let next = 0;
  for (const tube of tubes) {
    const reached = firstPointAt(trace, next, [tube.x, tube.y], 0.1 * pitch);
    if (reached < 0) continue;
    stops.push({tube, index: reached});
    next = reached;
  }
  return {trace, lengths, stops, total: lengths[lengths.length - 1]};
}

/// The first point of the trace from `start` on that is within `reach` of a place, or -1.
function firstPointAt(trace, start, place, reach) {
  for (let i = start; i < trace.length; ++i)
    if (distance(trace[i], place) < reach) return i;
  return -1;
}

export function tourSection(report, sheet) {
  if (!sheet || points(report.tour).length < 2) return [notRecorded("The tour")];
  const tour = readTour(report, sheet.model.pitch);
  const marker = el("div", {class: "walker", hidden: true});
  const says = el("output", {class: "note"}, "Press Play or move the slider to walk along the tour.");
  let frame = null;
  const picture = figure("The tour of the tip over the sheet", (width) => {
    const drawn = drawSheet(sheet, width, {faint: true});
    frame = drawn.frame;
    drawTour(drawn.context, frame, tour, report);
    hoverHoles(drawn.canvas, frame, holeDescriber(report, sheet, mapModeOf(report, "via_point")));
    return drawn.canvas;
  });
  const show = (part) => {
    const {place, reached} = placeAlong(tour, part);
    const [x, y] = frame.place(place);
    marker.hidden = false;
    marker.style.left = `${100 * x / frame.width}%`;
    marker.style.top = `${100 * y / frame.height}%`;
    says.textContent = reached ?
        `Last reached: ${tubeName(reached.tube)} (${visitOf(report, reached.tube)})` :
        "Before the first tube";
  };
  return [
    el("p", {class: "lead"},
       `${plural(list(report.tubes).length, "tube")} in visiting order; the trace runs from blue (start) to ` +
           "orange (end), arrows give the direction, numbers the order."),
    el("div", {class: "card"}, el("div", {class: "layered"}, picture.element, marker), walkControls(show), says)
  ];
}

/// A slider along the tour and a button that moves it.
function walkControls(show) {
  const slider = el("input", {
    type: "range",
    min: 0,
    max: 1000,
    value: 0,
    "aria-label": "Place along the tour",
    input: () => show(slider.value / 1000)
  });
  let timer = null;
  const stop = () => {
    clearInterval(timer);
    timer = null;
    button.textContent = "Play";
  };
  const button =
      el("button", {
        type: "button",
        click: () => {
          if (timer !== null) return stop();
          if (slider.value >= 1000) slider.value = 0;
          button.textContent = "Pause";
          timer = setInterval(() => {
            slider.value = Number(slider.value) + 2;
            show(slider.value / 1000);
            if (slider.value >= 1000) stop();
          }, 40);
        }
      },
         "Play");
  return el("div", {class: "walk"}, button, slider);
}

/// The place at a part (0 to 1) of the tour's length and the last stop reached there.
function placeAlong(tour, part) {
  const run = part * tour.total;
  let i = 1;
  while (i < tour.trace.length - 1 && tour.lengths[i] < run) ++i;
  const span = tour.lengths[i] - tour.lengths[i - 1];
  const share = span > 0 ? Math.min(1, (run - tour.lengths[i - 1]) / span) : 1;
  const place = [0, 1].map((k) => tour.trace[i - 1][k] + share * (tour.trace[i][k] - tour.trace[i - 1][k]));
  const reached = tour.stops.filter((stop) => tour.lengths[stop.index] <= run + 1e-9 * tour.total);
  return {place, reached: reached[reached.length - 1] ?? null};
}

function drawTour(context, frame, tour, report) {
  const places = tour.trace.map((point) => frame.place(point));
  context.lineWidth = 1.6;
  context.lineCap = "round";
  for (let i = 1; i < places.length; ++i) {
    context.strokeStyle = tourColour(tour.lengths[i] / (tour.total || 1));
    context.beginPath();
    context.moveTo(...places[i - 1]);
    context.lineTo(...places[i]);
    context.stroke();
  }
  drawDirections(context, frame, tour, places);
  drawStops(context, frame, tour, report);
}

/// Blue to orange by way of a light or dark grey-violet: distinct for colour-blind eyes at both ends.
function tourColour(part) {
  const stops = [[0, 114, 178], [150, 105, 150], [213, 94, 0]];
  const k = part < 0.5 ? 0 : 1, share = 2 * part - k;
  return `rgb(${stops[k].map((value, i) => Math.round(value + share * (stops[k + 1][i] - value))).join(",")})`;
}

/// An arrow head on the trace every so many pixels.
function drawDirections(context, frame, tour, places) {
  const every = 70 / frame.scale;
  let due = every / 2;
  for (let i = 1; i < places.length; ++i) {
    if (tour.lengths[i] < due) continue;
    const share = 0.5, from = places[i - 1], to = places[i];
    const tip = [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
    const length = distance(from, to);
    if (length > 0.5) {
      const back = [tip[0] - 7 * (to[0] - from[0]) / length, tip[1] - 7 * (to[1] - from[1]) / length];
      drawArrowTo(context, back, tip, tourColour(tour.lengths[i] / (tour.total || 1)), 1.8);
    }
    due = tour.lengths[i] + every;
  }
}

/// A dot at each tube; order numbers at the first, the last and every few between.
function drawStops(context, frame, tour, report) {
  const tubes = list(report.tubes).filter((tube) => isNumber(tube.x) && isNumber(tube.y));
  const every = tubes.length <= 80 ? 5 : Math.ceil(tubes.length / 16 / 10) * 10;
  const radius = 0.5 * markRadius(tubes.map((tube) => frame.place([tube.x, tube.y])), 5.2);
  tubes.forEach((tube, i) => {
    const [x, y] = frame.place([tube.x, tube.y]);
    const end = i === 0 || i === tubes.length - 1;
    drawMarks(context, {shape: end ? "square" : "disc", colour: end ? "ink" : "paper"}, [[x, y]], end ? 4.5 : radius);
    const order = i + 1;
    if (end)
      drawTag(context, frame, i === 0 ? `${order} start` : `${order} end`, x, y, true);
    else if (order % every === 0)
      drawTag(context, frame, String(order), x, y, false);
  });
}

export function drawTag(context, frame, text, x, y, strong) {
  context.font = strong ? `bold ${FONT}` : FONT;
  const wide = context.measureText(text).width;
  const left = x + 7 + wide > frame.width - 2 ? x - 7 - wide : x + 7;
  context.fillStyle = colour("tag");
  context.fillRect(left - 2, y - 15, wide + 4, 13);
  context.fillStyle = colour("ink");
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(text, left, y - 8);
  context.font = FONT;
}
