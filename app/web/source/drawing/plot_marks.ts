// Series of uPlot as marks of their own shape instead of lines.
import uPlot from "uplot";
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
      const path = new Path2D();
      const r = (look.isMany ? 1.6 : isFull ? 2.6 : 3.2) * uPlot.pxRatio;
      const xs = plot.data[0],
        ys = plot.data[series];
      for (let i = from; i <= to; ++i) {
        const value = ys[i];
        if (value === null || value === undefined) continue;
        addMark(path, mark, plot.valToPos(xs[i], "x", true), plot.valToPos(value, "y", true), r);
      }
      return {stroke: path, fill: isFull ? path : undefined};
    },
  };
}

function addMark(path: Path2D, mark: Mark, x: number, y: number, r: number): void {
  if (mark.shape === "triangle") {
    path.moveTo(x, y - 1.2 * r);
    path.lineTo(x + 1.1 * r, y + 0.9 * r);
    path.lineTo(x - 1.1 * r, y + 0.9 * r);
    path.closePath();
  } else {
    path.moveTo(x + r, y);
    path.arc(x, y, r, 0, 2 * Math.PI);
  }
}
