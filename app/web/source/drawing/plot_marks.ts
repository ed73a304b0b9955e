// Drawing of uPlot series as marks of a chosen shape instead of lines.
import uPlot from "uplot";
import {marksPath, type Mark} from "./marks";

export interface MarkLook {
  isHollow?: boolean;
  /** Returns true if the mark of a row is drawn; if missing, all marks are drawn. */
  isDrawn?: (row: number) => boolean;
}

export function markPaths(mark: Mark, colour: string, look: MarkLook = {}): uPlot.Series {
  const isFull = !look.isHollow && mark.shape === "disc";
  return {
    stroke: colour,
    fill: isFull ? colour : undefined,
    width: 1.2,
    points: {show: false},
    paths: (plot, series, from, to) => {
      const r = (isFull ? 2.6 : 3.2) * uPlot.pxRatio;
      const path = marksPath(mark.shape, placesOf(plot, series, from, to, look.isDrawn), r);
      return {stroke: path, fill: isFull ? path : undefined};
    },
  };
}

/** Yields the positions of the values of a series, in canvas pixels. */
function* placesOf(
  plot: uPlot,
  series: number,
  from: number,
  to: number,
  isDrawn: (row: number) => boolean = () => true,
): Generator<[number, number]> {
  const xs = plot.data[0],
    ys = plot.data[series];
  for (let i = from; i <= to; ++i) {
    const value = ys[i];
    if (value !== null && value !== undefined && isDrawn(i))
      yield [plot.valToPos(xs[i], "x", true), plot.valToPos(value, "y", true)];
  }
}
