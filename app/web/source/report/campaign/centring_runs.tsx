// Centring of tools for randomly drawn true arms: curves, probabilities, and the sheet.
import {useSignal} from "@preact/signals";
import {useCallback, useMemo} from "preact/hooks";
import type uPlot from "uplot";
import {exact, isNumber, plural, probability, short, whole} from "../../../../drawing/numbers.js";
import {sheetWords, type SheetModel} from "../../../../drawing/sheet_model.js";
import {strokeLine} from "../../drawing/canvas";
import {palette, type Palette} from "../../drawing/colours";
import {drawMark, type Mark} from "../../drawing/marks";
import {Select} from "../../drawing/fields";
import {axis, type PlotOptions} from "../../drawing/plot";
import {choicesOf, Segments} from "../../drawing/segments";
import {paintWithin} from "../../error/plot_painting";
import {paintWords} from "../../plan/clearance_axes";
import {PlotBox} from "../errors/error_plot_box";
import {Card, Lead, Legend, Missing, type OfReport, Reasons, Table, TableCard} from "../parts";
import {type MarkGroup, type Painter, paintGroups, type Place, readSheet, SheetBox} from "../plan/sheet_box";
import {lengthUnit, list, object, points, type Report, textOf} from "../values";
import {type Estimate, Estimates, lookOf, LOOKS} from "./estimates";

type Choices = readonly (readonly [string, string])[];

/** Returns the names and labels of the compensation modes, compensated first. */
function waysOf(report: Report): Choices {
  return list(report.ways)
    .map(({name, words}) => [textOf(name), textOf(words, textOf(name))] as const)
    .reverse();
}

function tolerancesOf(report: Report): number[] {
  return (Array.isArray(report.step_tolerances) ? report.step_tolerances : []).filter(isNumber);
}

/** Returns the step numbers 1, 2, ... of the tool. */
function stepsOf(report: Report): number[] {
  return tolerancesOf(report).map((_, k) => k + 1);
}

export function settingName(report: Report, setting: Report): string {
  const sigmas = new Set(list(report.settings).map((other) => other.touch_sigma));
  const noise = sigmas.size > 1 ? `, noise ${short(setting.touch_sigma)} ${lengthUnit(report)}` : "";
  return `${plural(setting.touches, "touch", "touches")}, ${textOf(setting.choice)}${noise}`;
}

function WayChoice({report, value, onChoose}: {value: string; onChoose: (way: string) => void} & OfReport) {
  return <Segments label="Compensation" choices={choicesOf(waysOf(report))} value={value} onChoose={onChoose} />;
}

// ---- the fraction of visits beyond an error

export function CurvesSection({report}: OfReport) {
  const way = useSignal("compensated"),
    settings = list(report.settings).slice(0, LOOKS.length),
    isCut = list(report.settings).length > settings.length;
  const curves = useMemo(() => settings.map((setting) => beyondOf(setting, way.value)), [report, way.value]);
  const {options, data} = useMemo(() => makeCurves(report, curves, palette.peek()), [curves, palette.value]);
  const describe = (row: number) => [
    `${short(data[0][row])} ${lengthUnit(report)}`,
    ...settings.map((setting, k) => {
      const share = data[k + 1][row];
      return isNumber(share) && `${probability(share)} beyond: ${settingName(report, setting)}`;
    }),
  ];
  return (
    <>
      <Lead>
        Fraction of the visits whose centring error exceeds the value below, from one down to one in a thousand. The
        dashed lines are what the steps of the tool let through.
      </Lead>
      {isCut ? <p class="note">The first {LOOKS.length} settings are drawn.</p> : null}
      <Card>
        <WayChoice report={report} value={way.value} onChoose={(next) => (way.value = next)} />
        <PlotBox
          options={options}
          data={data}
          label="Fraction of visits with a larger centring error"
          describe={describe}
        />
        <Legend>{settings.map((setting, i) => [lookOf(i), settingName(report, setting)] as const)}</Legend>
      </Card>
    </>
  );
}

/** Smallest fraction of visits that is drawn. */
const LEAST = 1e-3;

/** Returns points of the curve: an error and the fraction of visits with a larger error. */
function beyondOf(setting: Report, way: string): Place[] {
  const curve = points(object(setting[way])?.curve).map(([error, share]): Place => [error, 1 - share]);
  return [[0, 1] as Place, ...curve].filter(([, share]) => share >= LEAST);
}

function makeCurves(report: Report, curves: readonly Place[][], colours: Palette) {
  const tolerances = tolerancesOf(report);
  const errors = [...new Set(curves.flat().map(([error]) => error))].sort((a, b) => a - b);
  const most = Math.max(1e-9, ...tolerances.map((value) => 1.1 * value), ...errors);
  const columns = curves.map((curve) => {
    const shares = new Map(curve);
    return errors.map((error) => shares.get(error));
  });
  const options: PlotOptions = {
    scales: {x: {time: false, range: [0, most]}, y: {distr: 3, range: [LEAST, 1]}},
    axes: [
      axis(colours, `centring error, ${lengthUnit(report)}`, {space: 90}),
      axis(colours, "fraction of visits beyond", {
        side: 3,
        splits: () => [0.001, 0.01, 0.1, 1],
        values: (_plot: uPlot, splits: number[]) => splits.map(exact),
        filter: (_plot: uPlot, splits: number[]) => splits,
      }),
    ],
    series: [
      {},
      ...curves.map((_, i) => {
        const {colour} = lookOf(i),
          dash = lookOf(i).dash.map((long) => long * devicePixelRatio);
        return {stroke: colours[colour], width: 1.6, dash, spanGaps: true, points: {show: false}};
      }),
    ],
    hooks: {
      draw: [
        (plot) => paintTolerances(plot, tolerances, colours),
        (plot) => curves.forEach((curve, i) => paintMarksAlong(plot, curve, i, colours)),
      ],
    },
  };
  return {options, data: [errors, ...columns] as uPlot.AlignedData};
}

function paintTolerances(plot: uPlot, tolerances: readonly number[], colours: Palette): void {
  paintWithin(plot, (context) => {
    context.strokeStyle = colours.bad;
    context.lineWidth = 1.5 * devicePixelRatio;
    context.setLineDash([7, 4].map((long) => long * devicePixelRatio));
    for (const tolerance of tolerances) {
      const x = plot.valToPos(tolerance, "x", true);
      strokeLine(context, [x, plot.bbox.top], [x, plot.bbox.top + plot.bbox.height]);
    }
    context.setLineDash([]);
    context.fillStyle = colours.bad;
    context.textAlign = "left";
    tolerances.forEach((tolerance, i) => {
      const x = plot.valToPos(tolerance, "x", true) + 4 * devicePixelRatio;
      paintWords(plot, `step ${i + 1}`, x, plot.bbox.top + (14 + 14 * i) * devicePixelRatio, colours);
    });
  });
}

/** Paints marks of a setting at intervals along its curve, with a different offset for each setting. */
function paintMarksAlong(plot: uPlot, curve: readonly Place[], i: number, colours: Palette): void {
  const {shape, colour} = lookOf(i),
    every = Math.max(1, Math.floor(curve.length / 8));
  plot.ctx.fillStyle = plot.ctx.strokeStyle = colours[colour];
  for (let k = 1 + i; k < curve.length; k += every) {
    const [x, y] = [plot.valToPos(curve[k][0], "x", true), plot.valToPos(curve[k][1], "y", true)];
    drawMark(plot.ctx, shape, x, y, 5 * devicePixelRatio);
  }
}

// ---- settings side by side

export function SettingsSection({report}: OfReport) {
  const settings = list(report.settings),
    unit = lengthUnit(report);
  const means = waysOf(report).flatMap(([way, words]) =>
    settings.map((setting, i) => meanOf(object(setting[way]), `${settingName(report, setting)}, ${words}`, i)),
  );
  const title = `mean centring error, ${unit}`,
    most = Math.max(1e-9, ...means.map(({high, value}) => high ?? value ?? 0));
  const chances = (steps: number): Estimate[] =>
    settings.map((setting, i) => {
      const step = list(object(setting.compensated)?.steps).find((entry) => entry.at_least === steps);
      return {name: settingName(report, setting), ...(object(step?.probability) ?? {}), look: lookOf(i)};
    });
  return (
    <>
      <Lead>The same true arms under every setting. Bars are 95 % bands.</Lead>
      <div class="pair">
        <Card title={`Mean centring error, ${unit}`}>
          <Estimates label="Mean centring error" rows={means} to={1.05 * most} title={title} write={short} />
        </Card>
        {stepsOf(report).map((steps) => (
          <Card title={`Probability of ${steps} or more steps, compensated`}>
            <Estimates
              label={`Probability of ${steps} steps or more`}
              rows={chances(steps)}
              to={1}
              title="probability for one hole"
              write={probability}
            />
          </Card>
        ))}
      </div>
      <SettingsTable report={report} />
    </>
  );
}

function meanOf(figures: Report | null, name: string, i: number): Estimate {
  const {value, sigma} = object(figures?.mean) ?? {};
  const half = isNumber(sigma) ? 1.96 * sigma : null;
  return half === null
    ? {name, value, look: lookOf(i)}
    : {name, value, look: lookOf(i), low: Math.max(0, value - half), high: value + half};
}

function SettingsTable({report}: OfReport) {
  const rows = list(report.settings).flatMap((setting) =>
    waysOf(report).map(([way, words]) => {
      const figures = object(setting[way]) ?? {},
        quantiles = object(figures.quantiles) ?? {};
      return [
        `${settingName(report, setting)}, ${words}`,
        `${whole(setting.scored)} of ${whole(setting.runs)}`,
        short(object(figures.mean)?.value),
        short(figures.rms),
        ...["50", "90", "95", "99"].map((q) => short(quantiles[q])),
        short(figures.max),
        ...list(figures.steps).map((step) => probability(object(step.in_all_holes)?.value)),
      ];
    }),
  );
  const figures = [`mean, ${lengthUnit(report)}`, "rms", "50 %", "90 %", "95 %", "99 %", "largest"];
  const refused = list(report.settings).flatMap((setting) =>
    list(setting.refused).map(
      ({runs, reason, first_run: first}) =>
        `${settingName(report, setting)}: ${plural(runs, "run")} not scored, ${textOf(reason)} (the first is run ${whole(first)})`,
    ),
  );
  const warnings = list(report.settings).flatMap((setting) =>
    list(setting.warnings).map((warning) => `${settingName(report, setting)}: ${textOf(warning)}`),
  );
  const inAll = stepsOf(report).map((steps) => `${steps} or more in all of a run`);
  return (
    <Card>
      <Table heads={["setting", "runs scored", ...figures, ...inAll]} rows={rows} />
      {refused.length > 0 ? <Reasons>{refused}</Reasons> : <p class="good">Every run was scored.</p>}
      {warnings.length > 0 && <Reasons>{warnings}</Reasons>}
    </Card>
  );
}

// ---- the holes one by one

/** Bands of probability, distinguished by colour and shape. */
const BANDS: {mark: Mark; name: string; least: number}[] = [
  {mark: {shape: "disc", colour: "case3"}, name: "99 % or more", least: 0.99},
  {mark: {shape: "square", colour: "case2"}, name: "95 to 99 %", least: 0.95},
  {mark: {shape: "triangle", colour: "case1"}, name: "50 to 95 %", least: 0.5},
  {mark: {shape: "cross", colour: "case0"}, name: "below 50 %", least: 0},
];

interface HoleChance {
  row: number;
  column: number;
  place: Place;
  visits: number;
  mean: number;
  chance: number;
  low: number;
  high: number;
}

export function ChanceMapSection({report}: OfReport) {
  const sheet = readSheet(report);
  if (!sheet || list(report.maps).length === 0) return <Missing what="The holes one by one" />;
  return (
    <>
      <Lead>
        {sheetWords(sheet)}. The probability that this many steps of the tool enter a hole. Point at a hole for its
        figures.
      </Lead>
      <Card>
        <ChanceMap report={report} sheet={sheet} />
      </Card>
    </>
  );
}

function ChanceMap({report, sheet}: {sheet: SheetModel} & OfReport) {
  const steps = useSignal(tolerancesOf(report).length),
    way = useSignal("compensated"),
    setting = useSignal(0),
    settings = list(report.settings);
  const holes = useMemo(
    () => holesOf(report, setting.value, way.value, steps.value),
    [report, setting.value, way.value, steps.value],
  );
  const groups = useMemo(() => {
    const bandOf = ({chance}: HoleChance) => BANDS.findIndex(({least}) => chance >= least);
    return BANDS.map(({mark, name}, k): MarkGroup => {
      return {mark, name, places: holes.filter((hole) => bandOf(hole) === k).map(({place}) => place)};
    });
  }, [holes]);
  const describe = useMemo(() => {
    const known = new Map(holes.map((hole) => [`${hole.row} ${hole.column}`, hole]));
    return (row: number, column: number) => describeChance(known.get(`${row} ${column}`), lengthUnit(report));
  }, [holes]);
  const paint = useCallback((painter: Painter) => paintGroups(painter, groups), [groups]);
  return (
    <>
      <div class="card-head">
        <Segments
          label="Steps"
          choices={choicesOf(stepsOf(report).map((count) => [count, `${count} or more`] as const))}
          value={steps.value}
          onChoose={(next) => (steps.value = next)}
        />
        <WayChoice report={report} value={way.value} onChoose={(next) => (way.value = next)} />
        {settings.length > 1 ? (
          <Select
            label="Setting"
            choices={settings.map((entry, value) => ({value, words: settingName(report, entry)}))}
            value={setting.value}
            onChoose={(next) => (setting.value = next)}
          />
        ) : null}
      </div>
      <SheetBox {...{report, sheet, describe, paint}} label="Probability of the steps over the sheet" isFaint />
      <Legend>
        {groups.map(({mark, name, places}) => [mark, [name, " ", <b>{whole(places.length)}</b>]] as const)}
      </Legend>
    </>
  );
}

function holesOf(report: Report, setting: number, way: string, steps: number): HoleChance[] {
  const map = list(report.maps).find((entry) => entry.setting === setting && entry.way === way);
  return list(map?.holes).map(([row, column, x, y, visits, mean, chances]: any) => {
    const [chance, low, high] = chances[steps - 1] ?? [];
    return {row, column, place: [x, y], visits, mean, chance, low, high};
  });
}

function describeChance(hole: HoleChance | undefined, unit: string): string[] {
  if (!hole) return ["not visited"];
  return [
    `${plural(hole.visits, "visit")}, mean error ${short(hole.mean)} ${unit}`,
    `probability: ${probability(hole.chance)} (${probability(hole.low)} to ${probability(hole.high)})`,
  ];
}

export function WorstHolesSection({report}: OfReport) {
  const unit = lengthUnit(report),
    steps = stepsOf(report);
  const rowsOf = (setting: Report) =>
    list(object(setting.compensated)?.worst_holes).map((hole) => [
      textOf(hole.hole),
      whole(hole.visits),
      short(hole.mean),
      ...steps.map((_, k) => {
        const {value, low, high} = object(hole.at_least?.[k]) ?? {};
        return `${probability(value)} (${probability(low)} to ${probability(high)})`;
      }),
    ]);
  const heads = ["hole", "visits", `mean error, ${unit}`, ...steps.map((count) => `${count} or more`)];
  return (
    <>
      <Lead>The holes with the largest mean error, compensated, of those visited ten times or more.</Lead>
      {list(report.settings).map((setting) => (
        <TableCard
          what="Holes visited ten times or more"
          title={settingName(report, setting)}
          heads={heads}
          rows={rowsOf(setting)}
        />
      ))}
    </>
  );
}
