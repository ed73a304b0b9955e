// Series of uPlot as marks of their own shape instead of lines.
import uPlot from "uplot";
import {hollowPath} from "../../../drawing/shapes.js";
import type {Mark} from "./marks";

export interface MarkLook {
  isHollow?: boolean;
  /** Thousands: smaller and without an outline of their own where they are full. */
  isMany?: boolean;
}

export function markPaths(mark: Mark, colour: string, look: MarkLook = {}): uPlot.Series {
  const isFull = !look.isHollow && mark.shape === "disc";
  return {
    stroke: colour,
    fill: isFull ? colour : undefined,
    width: look.isMany ? 0.8 : 1.2,
    points: {show: false},
    paths: (plot, series, from, to) => {
      const r = (look.isMany ? 1.6 : isFull ? 2.6 : 3.2) * uPlot.pxRatio;
      const one = new Path2D(hollowPath(mark.shape, 0, 0, r)),
        path = new Path2D(); // text for each of ten thousand marks would take twice as long and more
      const xs = plot.data[0],
        ys = plot.data[series];
      for (let i = from; i <= to; ++i) {
        const value = ys[i];
        if (value === null || value === undefined) continue;
        path.addPath(one, {e: plot.valToPos(xs[i], "x", true), f: plot.valToPos(value, "y", true)});
      }
      return {stroke: path, fill: isFull ? path : undefined};
    },
  };
}
