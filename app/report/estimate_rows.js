// Estimates with their 95 % bands, one below the other.
import {exact, isNumber} from "../drawing/numbers.js";
import {roundTicks} from "../drawing/scales.js";
import {append, figure, label, notRecorded, svg} from "./elements.js";
import {svgMark} from "./mark_drawing.js";

/// How several settings are told apart: colour, dash and mark of each.
export const SERIES = [
  {colour: "accent", dash: "", shape: "disc"},
  {colour: "case0", dash: "7 4", shape: "square"},
  {colour: "case3", dash: "2 3", shape: "triangle"},
  {colour: "rose", dash: "9 3 2 3", shape: "diamond"},
  {colour: "case1", dash: "4 2", shape: "cross"},
  {colour: "violet", dash: "1 4", shape: "ring"},
];

export function settingLook(index) { return SERIES[index % SERIES.length]; }

/// rows: [{name, value, low, high, mark}]; the axis runs from `from` to `to`.
export function estimateRows(description, rows, {from, to, title, write}) {
  const shown = rows.filter((row) => isNumber(row.value));
  if (shown.length === 0) return notRecorded(description);
  return figure(description, (width) => drawEstimates(shown, width, {from, to, title, write})).element;
}

function drawEstimates(rows, width, {from, to, title, write}) {
  const tall = 30, top = 6, bottom = 40, left = 6, right = 14;
  const height = top + rows.length * tall * 1.4 + bottom;
  const x = (value) => left + (width - left - right) * (value - from) / (to - from || 1);
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, width, height, class: "chart"});
  for (const tick of roundTicks(from, to, width > 420 ? 6 : 4)) {
    append(drawing, [
      svg("line", {x1: x(tick), x2: x(tick), y1: top, y2: height - bottom, class: "grid"}),
      label(x(tick), height - bottom + 16, exact(tick), {"text-anchor": "middle"})
    ]);
  }
  append(drawing, [label((left + width) / 2, height - 6, title, {"text-anchor": "middle"})]);
  rows.forEach((row, i) => {
    const y = top + (i + 0.72) * tall * 1.4;
    append(drawing, [
      label(
          left, y - 12,
          `${row.name}: ${write(row.value)}${isNumber(row.low) ? ` (${write(row.low)} to ${write(row.high)})` : ""}`),
      isNumber(row.low) ? svg("line", {x1: x(row.low), x2: x(row.high), y1: y, y2: y, class: "axis"}) : null,
      svgMark(row.mark, x(row.value), y, 5)
    ]);
  });
  return drawing;
}
