// The errors against everything that a reading says of itself.
import {isNumber} from "../drawing/numbers.js";
import {rangeOf, roundTicks, widened} from "../drawing/scales.js";
import {hollowPath} from "../drawing/shapes.js";
import {isInShare, MOST_MARKS, shareText} from "../drawing/shares.js";
import {besideLevel, variablesOf, variableTitle} from "../drawing/variables.js";
import {zeroLine} from "./added_variable.js";
import {chartFrame, evenAxis} from "./axes.js";
import {append, choice, el, figure, notRecorded, svg} from "./elements.js";
import {jointNames, seriesLegend, seriesOf} from "./error_series.js";
import {lengthUnit, list, numbers, object} from "./values.js";

const ERROR_PARTS = [
  {key: "size", name: "size", of: (error) => Math.hypot(...error)},
  {key: "x", name: "x", of: (error) => error[0]},
  {key: "y", name: "y", of: (error) => error[1]},
  {key: "z", name: "z", of: (error) => error[2]},
];

/// What errors are drawn against here: what was set or measured, but for the places, which have maps of their own.
const DRAWN = new Set(["joint", "load", "temperature", "time", "sense"]);

function regressorsOf(report, readings) {
  const joints = readings.length > 0 ? jointNames(report, readings[0]) : [];
  const found = variablesOf({readings, joints, places: []}, object(report.units) ?? {});
  const titled = found.filter(({kind}) => DRAWN.has(kind)).map((entry) => ({...entry, title: variableTitle(entry)}));
  const isSense = ({kind}) => kind === "sense";
  return [...titled.filter((entry) => !isSense(entry)), ...titled.filter(isSense)];
}

export function residualChartsSection(report) {
  const readings = list(report.readings).filter((reading) => numbers(reading.before, 3));
  const regressors = regressorsOf(report, readings);
  if (regressors.length === 0) return [notRecorded("What the errors could be drawn against")];
  const shown = {part: ERROR_PARTS[0]}, share = shareText(readings.length, MOST_MARKS);
  const pictures = regressors.map(
      (regressor) => figure(
          `Error against ${regressor.title}`, (width) => drawErrors(report, readings, regressor, shown.part, width)));
  const parts = choice("Part of the error", ERROR_PARTS.map((part) => [part.key, part.name]), "size", (key) => {
    shown.part = ERROR_PARTS.find((part) => part.key === key);
    pictures.forEach((picture) => picture.redraw());
  });
  return [
    el("p", {class: "lead"},
       "Where the errors follow one of these, the missing effect depends on it. An effect with a direction shows in x, y " +
           "or z rather than in the size."),
    el("div", {class: "card-head"}, seriesLegend(report), parts),
    ...(share ? [el("p", {class: "note"}, `${share}.`)] : []),
    el("div", {class: "few"}, pictures.map((picture) => el("div", {class: "card"}, picture.element)))
  ];
}

function drawErrors(report, readings, regressor, part, width) {
  const entries = seriesOf(report).map(
      (series) => ({
        series,
        points: readings.filter((reading) => numbers(reading[series.key], 3) && isNumber(regressor.of(reading)))
                    .map((reading) => [regressor.of(reading), part.of(reading[series.key])])
      }));
  const all = entries.flatMap((entry) => entry.points);
  const values = all.map((point) => point[0]);
  const [low, high] = rangeOf(values);
  const [from, to] = widened(low, high);
  const even = evenAxis(all.map((point) => point[1]));
  const x = regressor.kind === "sense" ?
      {from: -1.6, to: 1.6, ticks: [-1, 0, 1]} :
      {from, to, ticks: roundTicks(low, high, Math.max(2, width / 75))};
  const y = part.key === "size" ? {from: 0, to: even.to} : even;
  const {drawing, at} = chartFrame(width, 200, {...x, title: regressor.title}, {
    ...y,
    room: 66,
    ticks: roundTicks(y.from, y.to, 4),
    title: `${part.key === "size" ? "size" : `along ${part.key}`}, ${lengthUnit(report)}`
  });
  if (part.key !== "size") append(drawing, [zeroLine(at, x, y)]);
  for (const {series, points} of entries) append(drawing, [errorMarks(series, points, regressor, at)]);
  return drawing;
}

/// The series' marks; those of a sense are spread a little, each series to its own side.
function errorMarks(series, points, regressor, at) {
  const side = series.key === "before" ? -1 : 1;
  const spread = (index) => (regressor.kind === "sense" ? side * (13.5 + 11 * besideLevel(index)) : 0);
  const isHollow = series.key === "before";
  const d = points.map(([vx, vy], index) => {
    if (!isInShare(index, points.length, MOST_MARKS)) return "";
    const [px, py] = at(vx, vy);
    return hollowPath(series.mark.shape, px + spread(index), py, isHollow ? 2.4 : 1.9);
  });
  return svg("path", {d: d.join(""), class: `points-${series.key}`});
}
