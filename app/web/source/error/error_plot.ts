// The plot of the errors against a variable: points, scales, axes and series.
import type uPlot from "uplot";
import type {Bin} from "../../../drawing/binned.js";
import {exact, isNumber, plainUnit, plural, tickTexts} from "../../../drawing/numbers.js";
import type {View} from "../../../drawing/own_variable.js";
import {
  type ErrorPair,
  partRange,
  levelRange,
  levelTicks,
  plotted,
  spreadAtLevel,
} from "../../../drawing/reading_errors.js";
import {roundTicks, widened} from "../../../drawing/scales.js";
import {isInShare, MOST_MARKS} from "../../../drawing/shares.js";
import {variableTitle} from "../../../drawing/variables.js";
import type {Palette} from "../drawing/colours";
import {axis, type PlotOptions} from "../drawing/plot";
import {markPaths} from "../drawing/plot_marks";
import {paintLaw, paintMeans} from "./plot_painting";

export interface PlotRow {
  x: number;
  index: number;
  id: string;
}

interface MadePlot {
  options: PlotOptions;
  data: uPlot.AlignedData;
  rows: PlotRow[];
  law: Bin[];
  words: string;
}

/**
 * Style of the plot: `most` is the upper end of an error scale shared with another plot; `isBrief` shortens the axis
 * title, for plots side by side.
 */
interface PlotLook {
  colours: Palette;
  most: number | null;
  isBrief: boolean;
}

export function makePlot(errors: ErrorPair, view: View, look: PlotLook): MadePlot {
  const {isLevel, xs, values, means, law} = plotted(errors, view);
  const rows = plotRows(errors, isLevel, xs);
  const {colours} = look;
  const names = errors.series.map((series) => series.name).join("; ");
  return {
    rows,
    law,
    words: `${errorTitle(view)} against ${variableTitle(view.variable)}, of ${plural(rows.length, "reading")}: ${names}`,
    data: [rows.map((row) => row.x), ...values.map((column) => rows.map((row) => column[row.index]))],
    options: {
      scales: scalesOf(view, isLevel, look.most),
      axes: axesOf(view, isLevel, look),
      hooks: {
        drawAxes: [(plot) => paintLaw(plot, law, isLevel, colours)],
        draw: [(plot) => paintMeans(plot, means, colours)],
      },
      series: [
        {},
        ...errors.series.map(({mark}, k) =>
          markPaths(mark, colours[mark.colour], {
            isHollow: k === 0,
            isDrawn: (row) => isInShare(rows[row].index, errors.readings.length, MOST_MARKS),
          }),
        ),
      ],
    },
  };
}

/** Returns the readings for which the variable is known, from left to right. */
function plotRows(errors: ErrorPair, isLevel: boolean, xs: readonly (number | undefined)[]): PlotRow[] {
  return xs
    .flatMap((x, index) =>
      isNumber(x) ? [{x: spreadAtLevel(isLevel, x, index), index, id: errors.readings[index].id}] : [],
    )
    .sort((a, b) => a.x - b.x);
}

function errorTitle({part}: View): string {
  return `${part.title}, ${plainUnit(part.unit)}`;
}

function scalesOf({variable, part}: View, isLevel: boolean, most: number | null): uPlot.Scales {
  return {
    x: {
      time: false,
      range: (_, low, high) => (isLevel ? levelRange(variable) : widened(low, high)),
    },
    y: {
      range: (_, low, high) => partRange(part, low, high, most),
    },
  };
}

function axesOf(view: View, isLevel: boolean, {colours, isBrief}: PlotLook): uPlot.Axis[] {
  const {variable, part} = view;
  return [
    axis(colours, variableTitle(variable), {
      splits: isLevel ? () => levelTicks(variable) : undefined,
      values: (_plot: uPlot, splits: number[]) => splits.map((value) => variable.levels?.[value] ?? exact(value)),
    }),
    axis(colours, isBrief ? `${part.key}, ${plainUnit(part.unit)}` : errorTitle(view), {
      side: 3,
      splits: (_plot: uPlot, _axis: number, low: number, high: number) => roundTicks(low, high, 5),
      values: (_plot: uPlot, splits: number[]) => tickTexts(splits),
    }),
  ];
}
