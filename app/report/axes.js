// Axes of the line charts.
import {exact} from "../drawing/numbers.js";
import {symmetric} from "../drawing/scales.js";
import {append, label, svg} from "./elements.js";

/// A chart's frame with ticks and grid. `x` and `y` are {from, to, ticks, title, scale?, text?}, `text` what a tick says
/// where that is not its number, `y` also {room?} of pixels for its numbers; returns {drawing, at}.
export function chartFrame(width, height, x, y) {
  const margin = {left: y.room ?? 52, right: 14, top: 12, bottom: 40};
  const bend = y.scale ?? ((value) => value);
  const at = (vx, vy) =>
      [margin.left + (width - margin.left - margin.right) * (vx - x.from) / (x.to - x.from || 1),
       height - margin.bottom -
           (height - margin.top - margin.bottom) * (bend(vy) - bend(y.from)) / (bend(y.to) - bend(y.from) || 1)];
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, width, height, class: "chart"});
  for (const tick of y.ticks) {
    const [, py] = at(x.from, tick);
    append(drawing, [
      svg("line", {x1: margin.left, x2: width - margin.right, y1: py, y2: py, class: "grid"}),
      label(margin.left - 6, py + 4, exact(tick), {"text-anchor": "end"})
    ]);
  }
  for (const tick of x.ticks) {
    const [px] = at(tick, y.from);
    append(drawing, [
      svg("line", {x1: px, x2: px, y1: height - margin.bottom, y2: height - margin.bottom + 4, class: "axis"}),
      label(px, height - margin.bottom + 17, (x.text ?? exact)(tick), {"text-anchor": "middle"})
    ]);
  }
  append(drawing, [
    svg("line", {
      x1: margin.left,
      x2: width - margin.right,
      y1: height - margin.bottom,
      y2: height - margin.bottom,
      class: "axis"
    }),
    label((margin.left + width) / 2, height - 5, x.title, {"text-anchor": "middle"}),
    label(-height / 2 + 10, 13, y.title, {"text-anchor": "middle", transform: "rotate(-90)"})
  ]);
  return {drawing, at};
}

/// An axis that reaches as far to both sides of zero.
export function evenAxis(values) {
  const [from, to] = symmetric(...rangeOf(values.length > 0 ? values : [0]));
  return {from, to};
}
