// The travel time beside its lower bound and the plain order by rows.
import {duration, isNumber, percent} from "../drawing/numbers.js";
import {append, el, figure, label, notRecorded, svg} from "./elements.js";
import {object} from "./values.js";

export function timingSection(report) {
  const times = object(report.times);
  const rows = [
    {name: "Lower bound (no order can be faster)", value: times?.lower_bound_s, kind: "bound"},
    {name: "This tour", value: times?.travel_time_s, kind: "tour"},
    {name: "Row by row, to and fro", value: times?.row_by_row_time_s, kind: "rows"},
  ].filter((row) => isNumber(row.value));
  if (rows.length === 0) return [notRecorded("Times")];
  const picture = figure("Travel time, lower bound and row by row", (width) => drawTimes(rows, width));
  return [el("p", {class: "lead"}, timingSentence(times)), el("div", {class: "card"}, picture.element)];
}

function timingSentence(times) {
  const parts = [`The travel between tubes takes ${duration(times.travel_time_s)}`];
  if (isNumber(times.total_time_s)) parts[0] += ` (${duration(times.total_time_s)} with approaches and retreats)`;
  if (isNumber(times.lower_bound_s)) {
    parts.push(`the lower bound is ${duration(times.lower_bound_s)}${
        isNumber(times.gap) ? ` (gap ${percent(times.gap, 1)})` : ""}`);
  }
  if (isNumber(times.row_by_row_time_s) && isNumber(times.travel_time_s) && times.row_by_row_time_s > 0) {
    const saved = 1 - times.travel_time_s / times.row_by_row_time_s;
    parts.push(`${percent(Math.abs(saved), 0)} ${saved >= 0 ? "less" : "more"} than row by row`);
  }
  return `${parts.join("; ")}.`;
}

function drawTimes(rows, width) {
  const tall = 22, gap = 30, left = 2;
  const most = Math.max(...rows.map((row) => row.value)) || 1;
  const height = rows.length * (tall + gap) + 2;
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, width, height, class: "chart"});
  rows.forEach(({name, value, kind}, i) => {
    const y = i * (tall + gap) + 18, long = Math.max(1, (width - 130) * value / most);
    append(drawing, [
      label(left, y - 5, name), svg("rect", {x: left, y, width: long, height: tall, rx: 2, class: `time-${kind}`}),
      label(left + long + 8, y + 16, duration(value), {class: "strong"})
    ]);
  });
  return drawing;
}
