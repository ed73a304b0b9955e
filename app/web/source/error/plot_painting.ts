// Elements painted in the error plot: the law with its band behind the points, bin means in front of them.
import uPlot from "uplot";
import {strokeLine} from "../drawing/canvas";
import type {Palette} from "../drawing/colours";
import type {Bin} from "../../../drawing/binned.js";

/**
 * Paints the law as a line through the displacements predicted for the cause, with their spread as a band. For a
 * variable with levels, each level is a short line.
 */
export function paintLaw(plot: uPlot, law: readonly Bin[], isLevel: boolean, colours: Palette): void {
  if (law.length === 0) return;
  const at = placing(plot);
  paintWithin(plot, (context) => {
    context.lineJoin = "round";
    context.strokeStyle = context.fillStyle = colours.violet;
    if (isLevel || law.length === 1) {
      for (const bin of law) paintLevel(context, at, bin, isLevel ? 0.3 : 0);
      return;
    }
    context.globalAlpha = 0.2;
    context.beginPath();
    law.forEach((bin) => context.lineTo(at.x(bin.x), at.y(bin.mean + bin.spread)));
    [...law].reverse().forEach((bin) => context.lineTo(at.x(bin.x), at.y(bin.mean - bin.spread)));
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 2.2 * uPlot.pxRatio;
    strokeLine(context, ...law.map((bin) => [at.x(bin.x), at.y(bin.mean)]));
  });
}

interface Placing {
  x: (value: number) => number;
  y: (value: number) => number;
}

function placing(plot: uPlot): Placing {
  return {x: (value) => plot.valToPos(value, "x", true), y: (value) => plot.valToPos(value, "y", true)};
}

function paintLevel(context: CanvasRenderingContext2D, at: Placing, bin: Bin, half: number): void {
  const [left, right] = [at.x(bin.from - half), at.x(bin.to + half)];
  context.globalAlpha = 0.2;
  context.fillRect(
    left,
    at.y(bin.mean + bin.spread),
    right - left,
    at.y(bin.mean - bin.spread) - at.y(bin.mean + bin.spread),
  );
  context.globalAlpha = 1;
  context.lineWidth = 2.2 * uPlot.pxRatio;
  strokeLine(context, [left, at.y(bin.mean)], [right, at.y(bin.mean)]);
}

export function paintMeans(plot: uPlot, means: readonly Bin[], colours: Palette): void {
  const at = placing(plot),
    half = 4 * uPlot.pxRatio;
  paintWithin(plot, (context) => {
    context.strokeStyle = colours.ink;
    context.fillStyle = colours.panel;
    context.lineWidth = 1.6 * uPlot.pxRatio;
    for (const bin of means) {
      const x = at.x(bin.x),
        [low, high] = [at.y(bin.mean - 2 * bin.error), at.y(bin.mean + 2 * bin.error)];
      strokeLine(context, [x, low], [x, high]);
      for (const y of [low, high]) strokeLine(context, [x - half, y], [x + half, y]);
      context.beginPath();
      context.rect(x - 0.8 * half, at.y(bin.mean) - 0.8 * half, 1.6 * half, 1.6 * half);
      context.fill();
      context.stroke();
    }
  });
}

/** Paints with clipping to the area of the plot. */
export function paintWithin(plot: uPlot, paint: (context: CanvasRenderingContext2D) => void): void {
  const {ctx: context, bbox} = plot;
  context.save();
  context.beginPath();
  context.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  context.clip();
  paint(context);
  context.restore();
}
