// The errors against anything that a reading says of itself.
import {Segments} from "../drawing/segments";
import {signal} from "@preact/signals";
import {useMemo} from "preact/hooks";
import type uPlot from "uplot";
import {MarkIcon} from "../drawing/marks";
import {palette} from "../drawing/colours";
import {exact, isNumber, roundTicks, short} from "../drawing/numbers";
import {Plot, axis} from "../drawing/plot";
import {markPaths} from "../drawing/plot_marks";
import type {ErrorReading, MomentsDocument, Vector3} from "../server/documents";
import {units} from "../server/workbench";
import {moments} from "./moments";
import {readingErrors, type ReadingErrors} from "./series";

interface Variable {
  key: string;
  name: string;
  unit: string;
  isSense?: boolean;
  of: (reading: ErrorReading, index: number) => number | undefined;
}

const PARTS = ["size", "x", "y", "z"] as const;
type Part = (typeof PARTS)[number];

const part = signal<Part>("size");
const chosen = signal("");

function partOf(error: Vector3 | null, which: Part): number | null {
  if (!error) return null;
  return which === "size" ? Math.hypot(...error) : error["xyz".indexOf(which)];
}

/** A moment that differs by less, as a share of the largest, is what rounding leaves of none. */
const LEAST_MOMENT = 1e-6;

/** Of the moments those that differ between the readings. */
function momentVariables(errors: ReadingErrors, found: MomentsDocument | null): Variable[] {
  if (!found) return [];
  const {names, readings, unit} = found;
  const ofReading = (reading: ErrorReading, k: number) => readings[reading.id]?.[k];
  const spans = names.map((_, k) => {
    const values = errors.readings.map((reading) => ofReading(reading, k)).filter(isNumber);
    return values.length > 0 ? Math.max(...values) - Math.min(...values) : 0;
  });
  const least = LEAST_MOMENT * Math.max(0, ...spans);
  return names.flatMap((name, k) =>
    spans[k] > least ? [{key: name, name, unit, of: (reading: ErrorReading) => ofReading(reading, k)}] : [],
  );
}

/** Only what differs between the readings. */
export function variablesOf(
  errors: ReadingErrors,
  unit: Record<string, string | undefined>,
  found: MomentsDocument | null = null,
): Variable[] {
  const all: Variable[] = [
    ...errors.joints.map((name, i) => ({
      key: name,
      name,
      unit: unit.angle ?? "",
      of: (reading: ErrorReading) => reading.joints[i],
    })),
    ...errors.joints.map((name, i) => ({
      key: `${name}_dir`,
      name: `sense of ${name}`,
      unit: "",
      isSense: true,
      of: (reading: ErrorReading) => reading.senses?.[i],
    })),
    {key: "load", name: "load", unit: unit.force ?? "", of: (reading) => reading.load},
    ...momentVariables(errors, found),
    {key: "temperature", name: "temperature", unit: unit.temperature ?? "", of: (reading) => reading.temperature},
    {key: "time", name: "time", unit: unit.time ?? "", of: (reading) => reading.time},
    {key: "order", name: "order", unit: "", of: (_, index) => index + 1},
  ];
  return all.filter(({of}) => new Set(errors.readings.map(of).filter(isNumber)).size > 1);
}

/** Points of one sense are spread a little, so that all of them are seen. */
function spread(variable: Variable, value: number, index: number): number {
  return variable.isSense ? value + 0.5 * (((index * 0.618034) % 1) - 0.5) : value;
}

/** A pattern says "moment forearm.z" of what a formula calls moment_forearm_z. */
export function suggestVariable(patternVariable: string | undefined, variables: Variable[]): string {
  const wanted = patternVariable?.startsWith("moment ") ? patternVariable.replace(/\W/g, "_") : patternVariable;
  return variables.find((variable) => variable.name === wanted)?.key ?? variables[0]?.key ?? "";
}

export function ResidualPlot({suggested}: {suggested?: string}) {
  const errors = readingErrors.value;
  const unit = units.value as unknown as Record<string, string | undefined>;
  const variables = useMemo(
    () => (errors ? variablesOf(errors, unit, moments.value) : []),
    [errors, units.value, moments.value],
  );
  const variable =
    variables.find((entry) => entry.key === (chosen.value || suggestVariable(suggested, variables))) ?? variables[0];
  const wanted: Part = part.value === "size" && variable?.isSense && chosen.value === "" ? "y" : part.value;
  const plot = useMemo(
    () => (errors && variable ? makePlot(errors, variable, wanted, units.value.length) : null),
    [errors, variable, wanted, palette.value],
  );
  return (
    <section class="panel">
      <header>
        <h2>Error against</h2>
        <select
          aria-label="Variable"
          value={variable?.key ?? ""}
          onChange={(event) => (chosen.value = event.currentTarget.value)}
        >
          {variables.map((entry) => (
            <option value={entry.key}>{entry.name}</option>
          ))}
        </select>
        <div class="end">
          <Segments
            label="Part of the error"
            choices={PARTS.map((name) => ({value: name, words: name}))}
            value={wanted}
            onChoose={(name) => {
              part.value = name;
              if (chosen.value === "") chosen.value = variable?.key ?? "";
            }}
          />
        </div>
      </header>
      <div class="panel-body flush with-legend">
        {plot ? (
          <Plot {...plot} label="Errors of the readings" />
        ) : (
          <p class="muted pad">Readings are drawn here once they are compared.</p>
        )}
        <SeriesLegend errors={errors} />
      </div>
    </section>
  );
}

export function SeriesLegend({errors}: {errors: ReadingErrors | null}) {
  return (
    <p class="series-legend">
      {(errors?.series ?? []).map((series) => (
        <span>
          <MarkIcon mark={series.mark} size={12} /> {series.name}
        </span>
      ))}
    </p>
  );
}

function makePlot(
  errors: ReadingErrors,
  variable: Variable,
  which: Part,
  unit: string,
): {options: Omit<uPlot.Options, "width" | "height">; data: uPlot.AlignedData} {
  const rows = errors.readings
    .map((reading, index) => ({x: variable.of(reading, index), index}))
    .filter((row): row is {x: number; index: number} => isNumber(row.x))
    .map((row) => ({...row, x: spread(variable, row.x, row.index)}))
    .sort((a, b) => a.x - b.x);
  const data: uPlot.AlignedData = [
    rows.map((row) => row.x),
    ...errors.series.map((series) => rows.map((row) => partOf(series.errors[row.index], which))),
  ];
  const name = `${variable.name}${variable.unit ? `, ${variable.unit}` : ""}`;
  const colours = palette.peek();
  return {
    data,
    options: {
      legend: {show: false},
      cursor: {y: false, points: {show: false}},
      scales: {
        x: {time: false, range: (_, low, high) => [low - 0.04 * (high - low || 1), high + 0.04 * (high - low || 1)]},
        y: {range: (_, low, high) => (which === "size" ? [0, 1.08 * high || 1] : symmetric(low, high))},
      },
      axes: [
        axis(colours, name, {
          values: (_plot: uPlot, splits: number[]) => splits.map((value) => exact(value)),
          ...(variable.isSense ? {splits: () => [-1, 0, 1]} : {}),
        }),
        axis(colours, `${which === "size" ? "error" : `error along ${which}`}, ${unit}`, {
          side: 3,
          splits: (_plot: uPlot, _axis: number, low: number, high: number) => roundTicks(low, high, 5),
          values: (_plot: uPlot, splits: number[]) => splits.map((value) => short(value)),
        }),
      ],
      series: [{}, ...errors.series.map((series) => markPaths(series.mark, colours[series.mark.colour]))],
    },
  };
}

function symmetric(low: number, high: number): [number, number] {
  const most = 1.08 * Math.max(Math.abs(low), Math.abs(high)) || 1;
  return [-most, most];
}
