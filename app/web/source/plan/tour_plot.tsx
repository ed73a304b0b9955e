// Clearance, travel time and centring along the tour, with the playhead. The cursor reads the clearance; a click moves
// the playhead.
import {choicesOf, Segments} from "../drawing/segments";
import {signal, useSignalEffect} from "@preact/signals";
import {useMemo, useRef} from "preact/hooks";
import uPlot from "uplot";
import {strokeLine} from "../drawing/canvas";
import {palette, type Palette} from "../drawing/colours";
import {exact, fixed, short} from "../../../drawing/numbers.js";
import {roundTicks} from "../../../drawing/scales.js";
import {stepKinds} from "../../../drawing/steps.js";
import {Panel} from "../drawing/panel";
import {axis, Plot, type PlotOptions} from "../drawing/plot";
import type {PathDocument, PlanDocument} from "../server/documents";
import {units} from "../server/workbench";
import {arrivals, clearances, isPlaying, path, plan, time} from "./playback";
import {clearanceAxes, paintRequired, ROOT_SCALE} from "./clearance_axes";
import {sampleAt} from "./sampling";
import {StepHistogram} from "./step_histogram";

type What = "clearance" | "travel" | "centring" | "chances";
const WHATS: [What, string][] = [
  ["clearance", "Clearance"],
  ["travel", "Travel time"],
  ["centring", "Chance of all steps"],
  ["chances", "Tubes by chance"],
];
const what = signal<What>("clearance");
/** Time under the pointer [s]; null if the pointer is outside. */
const pointed = signal<number | null>(null);

export function TourPlot() {
  const held = useRef<uPlot | null>(null);
  const document = plan.value.document,
    along = path.value;
  const made = useMemo(
    () =>
      document && along && what.value !== "chances" ? makePlot(what.value, document, along, clearances.value) : null,
    [document, along, what.value, clearances.value, palette.value, units.value],
  );
  useSignalEffect(() => {
    void time.value;
    held.current?.redraw(false, false);
  });
  const choice = (
    <Segments label="Plotted" choices={choicesOf(WHATS)} value={what.value} onChoose={(next) => (what.value = next)} />
  );
  return (
    <Panel title="Along the tour" end={choice} body="flush">
      {along && what.value === "clearance" ? <ClearanceFigure along={along} /> : null}
      {document && what.value === "chances" ? (
        <StepHistogram document={document} />
      ) : made ? (
        <Plot
          {...made}
          label="Along the tour"
          onReady={(plot) => {
            held.current = plot;
            plot.over.addEventListener("click", () => {
              if (plot.cursor.left !== undefined && plot.cursor.left >= 0) {
                isPlaying.value = false;
                time.value = plot.posToVal(plot.cursor.left, "x");
              }
            });
          }}
        />
      ) : (
        <p class="muted pad">Clearance and time appear here after planning.</p>
      )}
    </Panel>
  );
}

/** Clearance of the arm at the time under the pointer, otherwise at the playhead. */
function ClearanceFigure({along}: {along: PathDocument}) {
  const at = pointed.value ?? time.value;
  const sample = sampleAt(along.time, at);
  const here = clearances.value[sample],
    proved = along.clearance?.[sample];
  return (
    <p class="tour-figure">
      {fixed(at, 1)} s: <b>{here === undefined ? "…" : here === null ? "–" : short(here)}</b> {units.value.length}
      {typeof proved === "number" ? (
        <span class="muted">
          {" "}
          (motion proved {short(proved)} {plan.value.document?.base?.words})
        </span>
      ) : null}
    </p>
  );
}

/** Returns the times with one or two curves: sampled values, and the proved values of the motions. */
function pointsOf(
  which: What,
  document: PlanDocument,
  along: PathDocument,
  sampled: (number | null)[],
): [number[], ...(number | null)[][]] {
  if (which === "clearance" && along.clearance)
    return [along.time, along.time.map((_, i) => sampled[i] ?? null), along.clearance];
  const times = arrivals.peek();
  const known = document.tubes
    .map((tube, i) => ({tube, at: times[i], before: i > 0 ? times[i - 1] : 0}))
    .filter((row) => Number.isFinite(row.at));
  if (which === "centring")
    return [known.map((row) => row.at), known.map((row) => row.tube.probability_by_steps?.at(-1) ?? null)];
  return [known.map((row) => row.at), known.map((row) => row.at - (Number.isFinite(row.before) ? row.before : 0))];
}

function makePlot(which: What, document: PlanDocument, along: PathDocument, sampled: (number | null)[]) {
  const colours = palette.peek();
  const data: uPlot.AlignedData = pointsOf(which, document, along, sampled);
  const options: PlotOptions = {
    cursor: {y: false, points: {show: false}, drag: {x: false, y: false}},
    scales: scalesOf(which),
    axes: axesOf(which, document, colours),
    series: seriesOf(which, data.length > 2, colours),
    hooks: {
      draw: [
        (plot) => {
          if (which === "clearance") paintRequired(plot, document.clearance_required, units.peek().length, colours);
          drawPlayhead(plot);
        },
      ],
      setCursor: [
        ({cursor, posToVal}) => {
          const left = cursor.left ?? -1;
          pointed.value = left >= 0 ? posToVal(left, "x") : null;
        },
      ],
    },
  };
  return {options, data};
}

function scalesOf(which: What): uPlot.Scales {
  const most = (high: number) => (which === "centring" ? 1 : 1.08 * (high || 1));
  return {x: {time: false}, y: which === "clearance" ? ROOT_SCALE : {range: (_plot, _low, high) => [0, most(high)]}};
}

function axesOf(which: What, document: PlanDocument, colours: Palette): uPlot.Axis[] {
  if (which === "clearance") return clearanceAxes(colours, units.peek().length);
  const name = which === "travel" ? "to this tube, s" : `chance: ${stepKinds(document).at(-1)!.name}`;
  return [
    axis(colours, "time, s"),
    axis(colours, name, {
      side: 3,
      values: (_plot: uPlot, splits: number[]) => splits.map((value) => (value === null ? "" : exact(value))),
      splits: (_plot: uPlot, _axis: number, _low: number, high: number) => roundTicks(0, high, 5),
    }),
  ];
}

/**
 * Returns the series of the plot: the clearance as a line, with the proved clearance of the motions as steps; for other
 * quantities a bar for each tube.
 */
function seriesOf(which: What, hasProved: boolean, colours: Palette): uPlot.Series[] {
  const isBars = which !== "clearance";
  return [
    {},
    {
      stroke: colours.accent,
      width: 1.3,
      fill: isBars ? colours.accent : undefined,
      points: {show: false},
      ...(isBars ? {paths: uPlot.paths.bars!({size: [0.6, 8]})} : {}),
    },
    ...(hasProved
      ? [{stroke: colours.muted, width: 1, points: {show: false}, paths: uPlot.paths.stepped!({align: 1})}]
      : []),
  ];
}

function drawPlayhead(plot: uPlot): void {
  const {ctx, bbox} = plot;
  const x = plot.valToPos(time.peek(), "x", true);
  ctx.save();
  ctx.setLineDash([]);
  ctx.strokeStyle = palette.peek().ink;
  ctx.lineWidth = 1.5 * uPlot.pxRatio;
  strokeLine(ctx, [x, bbox.top], [x, bbox.top + bbox.height]);
  ctx.restore();
}
