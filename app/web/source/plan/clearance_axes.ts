// Common parts of plots of the clearance over the time of a motion: a square-root scale, because values near zero
// matter, and the required clearance as a line.
import uPlot from "uplot";
import {exact} from "../../../drawing/numbers.js";
import {rootTicks} from "../../../drawing/scales.js";
import {requiredText} from "../../../drawing/visits.js";
import {strokeLine, TYPEFACE} from "../drawing/canvas";
import type {Palette} from "../drawing/colours";
import {axis} from "../drawing/plot";

export const ROOT_SCALE: uPlot.Scale = {
  distr: 100,
  fwd: (value: number) => Math.sqrt(Math.max(0, value)),
  bwd: (value: number) => value * value,
  range: (_plot, _low, high) => [0, 1.08 * (high || 1)],
};

export function clearanceAxes(colours: Palette, unit: string): uPlot.Axis[] {
  return [
    axis(colours, "time, s"),
    axis(colours, `clearance, ${unit}`, {
      side: 3,
      values: (_plot: uPlot, splits: number[]) => splits.map((value) => (value === null ? "" : exact(value))),
      filter: (_plot: uPlot, splits: number[]) => splits,
      splits: (_plot: uPlot, _axis: number, _low: number, high: number) => rootTicks(high),
    }),
  ];
}

export function paintRequired(plot: uPlot, required: number | null, unit: string, colours: Palette): void {
  const {ctx, bbox} = plot;
  if (required === null || !Number.isFinite(required)) return;
  const y = plot.valToPos(required, "y", true);
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = colours.bad;
  ctx.setLineDash([7, 4]);
  strokeLine(ctx, [bbox.left, y], [bbox.left + bbox.width, y]);
  ctx.setLineDash([]);
  ctx.textAlign = "right";
  paintWords(plot, requiredText(required, unit), bbox.left + bbox.width - 4, y - 6, colours);
  ctx.restore();
}

/** Paints a label in the context's colour, with an outline that separates it from the lines. */
export function paintWords({ctx}: uPlot, words: string, x: number, y: number, colours: Palette): void {
  ctx.font = `${11 * uPlot.pxRatio}px ${TYPEFACE}`;
  ctx.strokeStyle = colours.panel;
  ctx.lineWidth = 4 * uPlot.pxRatio;
  ctx.lineJoin = "round";
  ctx.strokeText(words, x, y);
  ctx.fillText(words, x, y);
}
