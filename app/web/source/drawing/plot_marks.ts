// Series of uPlot as marks of their own shape instead of lines.
import uPlot from "uplot";
import type {Mark} from "./marks";

export function markPaths(mark: Mark, colour: string, radius = 2.6): uPlot.Series {
  return {
    stroke: colour,
    fill: mark.shape === "disc" ? colour : undefined,
    width: 1.2,
    points: {show: false},
    paths: (plot, series, from, to) => {
      const path = new Path2D();
      const r = radius * uPlot.pxRatio;
      const xs = plot.data[0],
        ys = plot.data[series];
      for (let i = from; i <= to; ++i) {
        const value = ys[i];
        if (value === null || value === undefined) continue;
        addMark(path, mark, plot.valToPos(xs[i], "x", true), plot.valToPos(value, "y", true), r);
      }
      return {stroke: path, fill: mark.shape === "disc" ? path : undefined};
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
