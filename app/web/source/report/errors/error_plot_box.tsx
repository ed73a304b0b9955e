// A plot in a report, drawn as in the workbench, with text about the point under the pointer next to it.
import {useMemo, useRef} from "preact/hooks";
import type uPlot from "uplot";
import {nearestPlace} from "../../../../drawing/frames.js";
import {isNumber, plainUnit, short} from "../../../../drawing/numbers.js";
import type {View} from "../../../../drawing/own_variable.js";
import type {ErrorPair} from "../../../../drawing/reading_errors.js";
import {palette} from "../../drawing/colours";
import {Plot, type PlotProps} from "../../drawing/plot";
import {makePlot} from "../../error/error_plot";
import {type Lines, Pointed} from "../pointed";
import type {Report} from "../values";
import {conditionsText, readingName} from "./pairs";

/** Maximum distance from the pointer to a point at which the point is selected [pixels]. */
const NEAR = 12;

/** Plot with text about the point under the pointer; `describe` returns its lines for a row of the data. */
export function PlotBox({
  describe,
  class: name = "",
  ...plot
}: PlotProps & {describe: (row: number) => Lines; class?: string}) {
  const held = useRef<uPlot | null>(null);
  const find = (event: PointerEvent) => {
    const made = held.current;
    if (!made || event.target !== made.over) return null;
    const [xs, ...columns] = made.data;
    for (const column of columns) {
      const places = [...column].map((value, row): [number, number] | null =>
        isNumber(value) ? [made.valToPos(xs[row], "x"), made.valToPos(value, "y")] : null,
      );
      const row = nearestPlace(places, event.offsetX, event.offsetY, NEAR);
      if (row >= 0) return describe(row);
    }
    return null;
  };
  return (
    <Pointed find={find} class={`chart ${name}`}>
      <Plot {...plot} onReady={(made) => (held.current = made)} />
    </Pointed>
  );
}

interface ErrorPlotBoxProps {
  report: Report;
  errors: ErrorPair;
  view: View;
  /** Upper end of an error scale shared by several plots; null for a separate scale. */
  most?: number | null;
  isSmall?: boolean;
}

export function ErrorPlotBox({report, errors, view, most = null, isSmall = false}: ErrorPlotBoxProps) {
  const plot = useMemo(
    () => makePlot(errors, view, {colours: palette.peek(), most, isBrief: isSmall}),
    [errors, view, most, palette.value],
  );
  const describe = (row: number) => describeReading(report, errors, view, plot.rows[row].index);
  return (
    <PlotBox
      options={plot.options}
      data={plot.data}
      label={plot.words}
      describe={describe}
      class={isSmall ? "small" : ""}
    />
  );
}

function describeReading(report: Report, errors: ErrorPair, {variable, part}: View, index: number): Lines {
  const reading = errors.readings[index] as Report & ErrorPair["readings"][number],
    x = variable.of(reading, index);
  return [
    readingName(reading),
    `${variable.name} ${variable.levels?.[x!] ?? short(x)} ${plainUnit(variable.unit)}`,
    ...errors.series.map(({name, errors: of}) => {
      const error = of[index];
      return `${name.split(":")[0]} ${short(error ? part.of(error, index) : null)} ${plainUnit(part.unit)}`;
    }),
    conditionsText(report, reading),
  ];
}
