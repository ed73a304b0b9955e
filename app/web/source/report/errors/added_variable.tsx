// Added-variable plots: the residual error against the displacement by an effect, coordinate by coordinate.
import {useMemo} from "preact/hooks";
import type uPlot from "uplot";
import {effectTitle, isEnough, keptText, sizeText} from "../../../../drawing/explanations.js";
import {fixed, isNumber, short} from "../../../../drawing/numbers.js";
import {rangeOf, symmetric} from "../../../../drawing/scales.js";
import {strokeLine} from "../../drawing/canvas";
import {palette, type Palette} from "../../drawing/colours";
import {axis, type PlotOptions} from "../../drawing/plot";
import {markPaths} from "../../drawing/plot_marks";
import {paintWithin} from "../../error/plot_painting";
import {Card, Lead, type OfReport} from "../parts";
import {list, type Report} from "../values";
import {PlotBox} from "./error_plot_box";
import {readingName, reportExplanations} from "./pairs";

export function AddedVariableSection({report}: OfReport) {
  const plots = plotsOf(report);
  if (plots.length === 0)
    return (
      <p class="missing">
        {report.verdict === "adequate"
          ? "No error remains unexplained, so no effect is drawn against it."
          : "No effect was fitted, so none is drawn against what is left."}
      </p>
    );
  return (
    <>
      <Lead>
        Each point is one coordinate of one reading. Across: its change by the effect, at the size that was found. Up:
        the residual of the model without the effect. The part that the fitted parameters can absorb is removed from
        both. Points along the line mean that the effect is missing; a round cloud means that it is not.
      </Lead>
      <div class="pair">
        {plots.map((plot) => (
          <AddedVariable report={report} plot={plot} />
        ))}
      </div>
    </>
  );
}

/** Returns the plots of the first explanation, of the closest effect, and of every other sufficient explanation. */
function plotsOf(report: Report): Report[] {
  const isShown = (plot: Report) =>
    !(plot.explanation > 0) || isEnough(reportExplanations(report)[plot.explanation] ?? {});
  return list(report.added_variable).filter((plot) => list(plot.points).length > 0 && isShown(plot));
}

function AddedVariable({report, plot}: {plot: Report} & OfReport) {
  const points = useMemo(
    () =>
      list(plot.points)
        .filter((point) => isNumber(point[1]) && isNumber(point[2]))
        .sort((a, b) => a[1] - b[1]),
    [plot],
  );
  const {options, data} = useMemo(() => makeScatter(points, plot.slope, palette.peek()), [points, palette.value]);
  const effects = reportExplanations(report)[plot.explanation]?.effects ?? [];
  const own = effects.find(({effect, at}) => effect === plot.effect && at === plot.at);
  const title = effectTitle(plot as {effect: string}),
    others = effects.filter((other) => other !== own).map(effectTitle);
  const describe = (row: number) => [
    readingName(list(report.readings)[points[row][0]]),
    `change by the effect ${fixed(points[row][1], 1)} sigmas`,
    `unexplained ${fixed(points[row][2], 1)} sigmas`,
  ];
  return (
    <Card title={`${title}${own && others.length > 0 ? ` beside ${others.join(", ")}` : ""}`}>
      <PlotBox options={options} data={data} label={`Added-variable plot of ${title}`} describe={describe} />
      <p class="note">
        <b>Slope {fixed(plot.slope, 2)}</b>, where 1 is the size found: {sizeText(own ?? (plot as any))}.
        {isNumber(plot.length) ? ` Its effect on all these readings together is ${short(plot.length)} sigmas` : ""}
        {isNumber(plot.kept_fraction) ? `; ${keptText(plot.kept_fraction)}.` : ""}
      </p>
    </Card>
  );
}

/** Returns the scatter plot of points [index of the reading, x, y]. */
function makeScatter(points: readonly Report[], slope: unknown, colours: Palette) {
  const [xs, ys] = [1, 2].map((k) => points.map((point) => point[k] as number));
  const data: uPlot.AlignedData = [xs, ys];
  const options: PlotOptions = {
    scales: {x: {time: false, range: symmetric(...rangeOf(xs))}, y: {range: symmetric(...rangeOf(ys))}},
    axes: [axis(colours, "change by the effect, noise sigmas"), axis(colours, "unexplained, noise sigmas", {side: 3})],
    series: [{}, markPaths({shape: "disc", colour: "accent"}, colours.accent)],
    hooks: {draw: [(plot) => paintSlope(plot, slope, colours)]},
  };
  return {data, options};
}

/** Paints the line of this slope through the origin. */
function paintSlope(plot: uPlot, slope: unknown, colours: Palette): void {
  const far = plot.scales.x.max! * 2;
  const at = (x: number, y: number): [number, number] => [plot.valToPos(x, "x", true), plot.valToPos(y, "y", true)];
  paintWithin(plot, (context) => {
    context.lineWidth = 1.6 * devicePixelRatio;
    context.strokeStyle = colours.ink;
    if (isNumber(slope)) strokeLine(context, at(-far, -slope * far), at(far, slope * far));
  });
}
