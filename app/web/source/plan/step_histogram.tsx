// Histogram of the planned tubes by the probability that every step of the tool enters.
import {useMemo} from "preact/hooks";
import uPlot from "uplot";
import {shareCounts} from "../../../drawing/histogram.js";
import {percent, plural} from "../../../drawing/numbers.js";
import {roundTicks} from "../../../drawing/scales.js";
import {stepKinds} from "../../../drawing/steps.js";
import {palette, type Palette} from "../drawing/colours";
import {axis, Plot, type PlotOptions} from "../drawing/plot";
import type {PlanDocument} from "../server/documents";

const BINS = 20;

export function StepHistogram({document}: {document: PlanDocument}) {
  const chances = document.tubes.flatMap(({probability_by_steps: chance}) => (chance ? [chance.at(-1)!] : []));
  const options = useMemo(() => optionsOf(palette.peek(), stepKinds(document).at(-1)!.name), [document, palette.value]);
  const data = useMemo<uPlot.AlignedData>(
    () => [Array.from({length: BINS}, (_, k) => k / BINS), shareCounts(chances, BINS)],
    [document],
  );
  if (chances.length === 0)
    return <p class="muted pad">No chances are known: they need a base that was calibrated by touching holes.</p>;
  return (
    <Plot
      options={options}
      data={data}
      label={`Histogram of ${plural(chances.length, "tube")} by the chance of all steps`}
    />
  );
}

function optionsOf(colours: Palette, name: string): PlotOptions {
  return {
    padding: [10, 26, 0, 0], // room for the label of 100 %
    scales: {x: {time: false, range: () => [0, 1]}, y: {range: (_plot, _low, high) => [0, 1.08 * (high || 1)]}},
    axes: [
      axis(colours, `chance: ${name}`, {
        splits: () => [0, 0.25, 0.5, 0.75, 1],
        values: (_plot, splits) => splits.map((value) => percent(value)),
      }),
      axis(colours, "tubes", {
        side: 3,
        splits: (_plot: uPlot, _axis: number, low: number, high: number) =>
          roundTicks(low, high, 4).filter(Number.isInteger),
        values: (_plot: uPlot, splits: number[]) => splits.map(String),
      }),
    ],
    series: [
      {},
      {
        stroke: colours.accent,
        width: 0,
        fill: colours.accent,
        points: {show: false},
        paths: uPlot.paths.bars!({size: [0.92, Infinity], align: 1}),
      },
    ],
  };
}
