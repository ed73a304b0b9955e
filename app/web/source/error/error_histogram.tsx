// Histogram of the errors of the readings, by size or in sigmas, before and after on common bins.
import {signal} from "@preact/signals";
import {useMemo} from "preact/hooks";
import uPlot from "uplot";
import {histogramOf} from "../../../drawing/histogram.js";
import {exact, plainUnit, plural} from "../../../drawing/numbers.js";
import {roundTicks} from "../../../drawing/scales.js";
import {palette, type Palette} from "../drawing/colours";
import {axis, Plot, type PlotOptions} from "../drawing/plot";
import {choicesOf, Segments} from "../drawing/segments";
import {readingErrors, type ReadingErrors} from "./residuals";
import {SeriesLegend} from "./series_legend";

type What = "size" | "sigmas";
const what = signal<What>("size");
const CHOICES = choicesOf<What>([
  ["size", "Size"],
  ["sigmas", "Sigmas"],
]);

export function HistogramChoice() {
  return <Segments label="Counted" choices={CHOICES} value={what.value} onChoose={(next) => (what.value = next)} />;
}

export function ErrorHistogram() {
  const errors = readingErrors.value;
  const made = useMemo(
    () => (errors ? makeHistogram(errors, what.value, palette.peek()) : null),
    [errors, what.value, palette.value],
  );
  if (!errors || !made || made.data[0].length === 0)
    return <p class="muted pad">The histogram of the errors appears here after a comparison.</p>;
  return (
    <div class="panel-body flush with-legend">
      <Plot options={made.options} data={made.data} label={made.words} />
      <SeriesLegend errors={errors} most={Infinity} />
    </div>
  );
}

/**
 * Returns the values of the series before and after. Sizes of other units than the most frequent one are left out, such
 * as angles among lengths.
 */
export function countedValues(errors: Pick<ReadingErrors, "sizes" | "sigmas" | "sizeUnits">, of: What) {
  if (of === "sigmas") return {series: errors.sigmas, unit: ""};
  const unit = mostFrequent(errors.sizeUnits);
  const series = errors.sizes.map((sizes) => sizes.map((size, i) => (errors.sizeUnits[i] === unit ? size : null)));
  return {series, unit};
}

function mostFrequent(units: readonly string[]): string {
  const counts = new Map<string, number>();
  for (const unit of units) counts.set(unit, (counts.get(unit) ?? 0) + 1);
  return [...counts].sort(([, a], [, b]) => b - a)[0]?.[0] ?? "";
}

function makeHistogram(errors: ReadingErrors, of: What, colours: Palette) {
  const {series, unit} = countedValues(errors, of);
  const {edges, counts, width} = histogramOf(series.slice(0, errors.series.length));
  // The series after is drawn first, so that the outline of the series before stays visible.
  const drawn = counts.map((bins) => bins.map((count) => count || null)); // an empty bin has no outline
  const data: uPlot.AlignedData = [edges, ...drawn.toReversed()];
  const name = of === "sigmas" ? "error, in its sigmas" : `size of the error, ${plainUnit(unit)}`;
  const options: PlotOptions = {
    scales: {
      x: {time: false, range: () => [edges[0], edges.at(-1)! + width]},
      y: {range: (_plot, _low, high) => [0, 1.08 * (high || 1)]},
    },
    axes: [
      axis(colours, name, {values: (_plot, splits) => splits.map(exact)}),
      axis(colours, "readings", {
        side: 3,
        splits: (_plot: uPlot, _axis: number, low: number, high: number) =>
          roundTicks(low, high, 5).filter(Number.isInteger),
        values: (_plot: uPlot, splits: number[]) => splits.map(exact),
      }),
    ],
    series: [{}, ...errors.series.map(({mark}, k) => barsOf(colours[mark.colour], k === 0)).toReversed()],
  };
  return {data, options, words: `Histogram of ${plural(errors.readings.length, "reading")}: ${name}`};
}

/** Returns the bars of a series: outlined before, filled after, so that they are distinct without colour. */
function barsOf(colour: string, isHollow: boolean): uPlot.Series {
  return {
    stroke: colour,
    width: isHollow ? 1.6 : 0,
    fill: isHollow ? undefined : colour,
    points: {show: false},
    paths: uPlot.paths.bars!({size: [1, Infinity], align: 1}),
  };
}
