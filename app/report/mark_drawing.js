// Marks on a report's canvases and in its SVG: filled ones with a thin edge of ink, which keeps pale colours apart on
// paper.
import {hollowPath, outlineOf} from "../drawing/shapes.js";
import {colour, svg} from "./elements.js";

/// Draws marks of one kind at many places ([x, y] in pixels) on a canvas.
export function drawMarks(context, mark, places, radius) {
  const outlines = places.map(([x, y]) => outlineOf(mark.shape, x, y, radius));
  const fill = new Path2D(outlines.map((outline) => outline.fill).join(""));
  const line = new Path2D(outlines.map((outline) => outline.line).join(""));
  const width = outlines[0]?.width ?? 0;
  context.lineJoin = "round";
  context.fillStyle = colour(mark.colour);
  context.fill(fill);
  context.strokeStyle = colour(width > 0 ? mark.colour : "ink");
  context.lineWidth = width > 0 ? Math.max(1, width * radius) : Math.min(0.9, 0.16 * radius);
  context.stroke(width > 0 ? line : fill);
}

/// A mark about a place in an SVG picture; a hollow one has a line where it would be filled.
export function svgMark(mark, x, y, radius, {isHollow = false} = {}, ...children) {
  const {fill, line, width} = outlineOf(mark.shape, x, y, radius), paint = `var(--${mark.colour})`;
  const thick = Math.max(0.9, width * radius);
  if (isHollow) {
    const d = hollowPath(mark.shape, x, y, radius);
    return svg("path", {d, fill: "none", stroke: paint, "stroke-width": Math.max(1.1, thick)}, ...children);
  }
  const edge = width > 0 ? {} : {stroke: "var(--ink)", "stroke-width": 0.8};
  return svg(
      "g", {"stroke-linejoin": "round"}, fill ? svg("path", {d: fill, fill: paint, ...edge}) : null,
      line ? svg("path", {d: line, fill: "none", stroke: paint, "stroke-width": thick}) : null, ...children);
}

/// The mark as a small picture for legends and tables.
export function markIcon(mark, size = 14, options = {}) {
  return svg(
      "svg", {width: size, height: size, viewBox: `0 0 ${size} ${size}`, class: "icon", "aria-hidden": "true"},
      svgMark(mark, size / 2, size / 2, 0.38 * size, options));
}
