// The number of tool steps that enter, the clearance of the tour, and the duration of the tour.
import {useMemo} from "preact/hooks";
import uPlot from "uplot";
import {duration, exact, fixed, isNumber, percent, plural, short, whole} from "../../../../drawing/numbers.js";
import {MARKED} from "../../../../drawing/sigma_text.js";
import {stepKinds} from "../../../../drawing/steps.js";
import {palette, type Palette} from "../../drawing/colours";
import type {PlotOptions} from "../../drawing/plot";
import {MarkIcon} from "../../drawing/marks";
import {paintWithin} from "../../error/plot_painting";
import {clearanceAxes, paintRequired, paintWords, ROOT_SCALE} from "../../plan/clearance_axes";
import {PlotBox} from "../errors/error_plot_box";
import {shareCells} from "../errors/ladder";
import {Card, Lead, Missing, type OfReport, Table} from "../parts";
import {StepBars} from "../step_bars";
import {lengthUnit, list, object, points, type Report, textOf} from "../values";
import {countsOf, modesOf} from "./cases";

// ---- numbers of steps that enter

export function StepsSection({report}: OfReport) {
  const rows = modesOf(report).map(({key, brief}) => ({name: brief, counts: countsOf(report, key)}));
  const scored = rows.flatMap(({name, counts}) => (counts ? [{name, counts}] : []));
  if (scored.length === 0) return <Missing what="Scores against a true arm" />;
  return (
    <>
      <Lead>Number of tubes by insertion of the tool, without compensation and with it.</Lead>
      <div class="pair">
        <Card title="Tubes by steps inserted">
          <StepTable report={report} rows={rows} />
          {list(report.steps).length === 0 ? <Missing what="The tool's steps" /> : <ToolNote report={report} />}
        </Card>
        <Card title="The same as shares">
          <StepBars label="Fraction of tubes by steps inserted" rows={scored} />
        </Card>
      </div>
    </>
  );
}

function StepTable({report, rows}: {rows: readonly {name: string; counts: number[] | null}[]} & OfReport) {
  const tolerances = list(report.steps)
      .map((step) => step.tolerance)
      .filter(isNumber),
    kinds = stepKinds(report);
  const heads = kinds.map(({mark}, i) => (
    <>
      <MarkIcon mark={mark} /> {plural(i, "step").replace(" ", "\u00a0")}
      <small>{errorRange(tolerances, i)}</small>
    </>
  ));
  const cells = rows.map(({name, counts}) =>
    counts
      ? [name, ...shareCells(counts), whole(counts.reduce((sum, count) => sum + count, 0))]
      : [name, ...kinds.map(() => null), "not recorded"],
  );
  return <Table heads={["", ...heads, "of"]} rows={cells} />;
}

/**
 * Returns the range of centring errors with which this number of steps enters: above the first tolerance if no step
 * enters, otherwise up to the tolerance of the last step that enters.
 */
function errorRange(tolerances: readonly number[], steps: number): string {
  if (steps > tolerances.length || tolerances.length === 0) return "";
  return steps === 0 ? `> ${exact(tolerances[0])}` : `≤ ${exact(tolerances[steps - 1])}`;
}

function ToolNote({report}: OfReport) {
  const unit = lengthUnit(report);
  const steps = list(report.steps).map(({diameter}, i) => `step ${i + 1}: ${exact(diameter)}`);
  return (
    <p class="note">
      Below each case, its centring error ({unit}). Diameters ({unit}): {steps.join(", ")}; hole:{" "}
      {exact(object(report.sheet)?.hole_diameter)}.
    </p>
  );
}

// ---- the clearance over the motion's time

export function ClearanceSection({report}: OfReport) {
  const curve = useMemo(() => points(report.clearance_along), [report]);
  return (
    <>
      <LeastClearance report={report} />
      {curve.length < 2 ? (
        <Missing what="The clearance along the tour" />
      ) : (
        <Card>
          <ClearancePlot report={report} curve={curve} />
          <p class="note">
            The curve is sampled along the motion; the figure above is the least of the whole check. The scale is a
            square root, to show what is small.
          </p>
        </Card>
      )}
    </>
  );
}

function LeastClearance({report}: OfReport) {
  const {min_clearance: least, clearance_required: required} = report,
    unit = lengthUnit(report);
  if (!isNumber(least)) return <Missing what="The least clearance" />;
  const isShort = isNumber(required) && least < required;
  return (
    <Lead>
      <b class={isShort ? "bad" : "good"}>
        {isShort ? MARKED : ""}Least clearance {short(least)} {unit}
      </b>
      {isNumber(required) ? ` (${exact(required)} ${unit} required)` : " (no requirement recorded)"}
      {textOf(report.tightest, "") ? `, ${textOf(report.tightest)}.` : "."}
    </Lead>
  );
}

function ClearancePlot({report, curve}: {curve: [number, number][]} & OfReport) {
  const unit = lengthUnit(report);
  const {options, data} = useMemo(() => makeClearance(report, curve, palette.peek()), [curve, palette.value]);
  const describe = (row: number) => [`${fixed(curve[row][0], 1)} s`, `${short(curve[row][1])} ${unit}`];
  return <PlotBox options={options} data={data} label="Clearance along the tour" describe={describe} />;
}

function makeClearance(report: Report, curve: readonly [number, number][], colours: Palette) {
  const unit = lengthUnit(report),
    required = isNumber(report.clearance_required) ? report.clearance_required : null;
  const least = curve.reduce((low, point) => (point[1] < low[1] ? point : low));
  const options: PlotOptions = {
    scales: {
      x: {time: false},
      y: {...ROOT_SCALE, range: (_plot, _low, high) => [0, 1.08 * Math.max(high, required ?? 0)]},
    },
    axes: clearanceAxes(colours, unit),
    series: [{}, {stroke: colours.accent, width: 1.5, points: {show: false}}],
    hooks: {
      draw: [
        (plot) => paintRequired(plot, required, unit, colours),
        (plot) => paintLeast(plot, least, `${short(least[1])} ${unit}`, colours),
      ],
    },
  };
  const data: uPlot.AlignedData = [curve.map(([time]) => time), curve.map(([, clearance]) => clearance)];
  return {options, data};
}

/** Paints a triangle below the smallest sample, with its value. */
function paintLeast(plot: uPlot, least: readonly [number, number], words: string, colours: Palette): void {
  const [x, y] = [plot.valToPos(least[0], "x", true), plot.valToPos(least[1], "y", true)],
    r = 5 * uPlot.pxRatio;
  paintWithin(plot, (context) => {
    context.fillStyle = colours.ink;
    context.beginPath();
    for (const [dx, dy] of [
      [0, 1],
      [r, 2.6 * r],
      [-r, 2.6 * r],
    ])
      context.lineTo(x + dx, y + dy);
    context.fill();
    const isRight = x > plot.bbox.left + 0.8 * plot.bbox.width;
    context.textAlign = isRight ? "right" : "left";
    paintWords(plot, words, x + (isRight ? -2 : 2) * r, y + 2.6 * r, colours);
  });
}

// ---- the travel time compared with its lower bound and the order by rows

export function TimeSection({report}: OfReport) {
  const times = object(report.times);
  const rows = [
    ["Lower bound (no order can be faster)", times?.lower_bound_s, "bound"],
    ["This tour", times?.travel_time_s, "tour"],
    ["Row by row, to and fro", times?.row_by_row_time_s, "rows"],
  ].filter((row): row is [string, number, string] => isNumber(row[1]));
  if (!times || rows.length === 0) return <Missing what="Times" />;
  const most = Math.max(...rows.map(([, seconds]) => seconds)) || 1;
  return (
    <>
      <Lead>{timeSentence(times)}</Lead>
      <Card class="times">
        {rows.map(([name, seconds, kind]) => (
          <>
            <span>{name}</span>
            <div>
              <i class={`time ${kind}`} style={{width: `${(85 * seconds) / most}%`}} /> <b>{duration(seconds)}</b>
            </div>
          </>
        ))}
      </Card>
    </>
  );
}

function timeSentence({
  travel_time_s: travel,
  total_time_s: total,
  lower_bound_s: bound,
  row_by_row_time_s: rows,
  gap,
}: Report) {
  const all = isNumber(total) ? ` (${duration(total)} with approaches and retreats)` : "";
  const parts = [`The travel between tubes takes ${duration(travel)}${all}`];
  if (isNumber(bound))
    parts.push(`the lower bound is ${duration(bound)}${isNumber(gap) ? ` (gap ${percent(gap, 1)})` : ""}`);
  if (isNumber(rows) && isNumber(travel) && rows > 0) {
    const saved = 1 - travel / rows;
    parts.push(`${percent(Math.abs(saved), 0)} ${saved >= 0 ? "less" : "more"} than row by row`);
  }
  return `${parts.join("; ")}.`;
}
