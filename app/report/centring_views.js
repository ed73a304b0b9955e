// How well tools centre over random truths: curves, chances, the sheet.
import {isNumber, plural, probability, short, whole} from "../drawing/numbers.js";
import {roundTicks} from "../drawing/scales.js";
import {sheetWords} from "../drawing/sheet_model.js";
import {chartFrame} from "./axes.js";
import {append, choice, el, figure, label, notRecorded, svg, table} from "./elements.js";
import {estimateRows, SERIES, settingLook} from "./estimate_rows.js";
import {drawMarks, markIcon, svgMark} from "./mark_drawing.js";
import {drawSheet} from "./sheet_drawing.js";
import {markRadius} from "./sheet_frame.js";
import {hoverHoles} from "./tooltip.js";
import {lengthUnit, list, object, points, textOf, tubeName} from "./values.js";

/// [name, words] of the ways, compensated first.
function waysOf(report) {
  return list(report.ways).map((way) => [textOf(way.name), textOf(way.words, textOf(way.name))]).reverse();
}

export function settingName(report, setting) {
  const parts = [`${plural(setting.touches, "touch", "touches")}`, `${textOf(setting.choice)}`];
  const sigmas = new Set(list(report.settings).map((other) => other.touch_sigma));
  if (sigmas.size > 1) parts.push(`noise ${short(setting.touch_sigma)} ${lengthUnit(report)}`);
  return parts.join(", ");
}

/// A choice of setting above a figure; nothing where there is only one.
function settingSelect(report, state, refresh) {
  const settings = list(report.settings);
  if (settings.length < 2) return null;
  return el(
      "select", {
        "aria-label": "Setting",
        change: (event) => {
          state.setting = Number(event.target.value);
          refresh();
        }
      },
      settings.map((setting, i) => el("option", {value: i}, settingName(report, setting))));
}

export function curvesSection(report) {
  const settings = list(report.settings);
  const state = {way: "compensated"};
  const picture = figure("Fraction of visits with a larger centring error", (width) => drawCurves(report, state, width));
  const legend =
      settings.slice(0, SERIES.length)
          .map((setting, i) => el("li", {}, markIcon({...settingLook(i), name: ""}), settingName(report, setting)));
  return [
    el("p", {class: "lead"},
       "Fraction of the visits whose centring error exceeds the value below, from one down to one in a thousand. The dashed " +
           "lines are what the steps of the tool let through."),
    settings.length > SERIES.length ? el("p", {class: "note"}, `The first ${SERIES.length} settings are drawn.`) : null,
    el("div", {class: "card"},
       choice(
           "Compensation", waysOf(report), state.way,
           (way) => {
             state.way = way;
             picture.redraw();
           }),
       picture.element, el("ul", {class: "legend"}, legend))
  ];
}

function drawCurves(report, state, width) {
  const settings = list(report.settings).slice(0, SERIES.length);
  const curves = settings.map((setting) => points(object(setting[state.way])?.curve));
  const tolerances = (Array.isArray(report.step_tolerances) ? report.step_tolerances : []).filter(isNumber);
  const most = Math.max(...tolerances.map((value) => 1.1 * value), ...curves.flat().map(([error]) => error), 1e-9);
  const floor = 1e-3;
  const {drawing, at} = chartFrame(
      width, 340, {
        from: 0,
        to: most,
        ticks: roundTicks(0, most, width > 500 ? 7 : 4),
        title: `centring error, ${lengthUnit(report)}`
      },
      {from: floor, to: 1, ticks: [0.001, 0.01, 0.1, 1], scale: Math.log10, title: "fraction of visits beyond"});
  tolerances.forEach((tolerance, i) => {
    const [x, top] = at(tolerance, 1), [, bottom] = at(tolerance, floor);
    append(drawing, [
      svg("line", {x1: x, x2: x, y1: top, y2: bottom, class: "required"}),
      label(x + 4, top + 12, `step ${i + 1}`, {class: "required-text"})
    ]);
  });
  curves.forEach((curve, i) => {
    const series = settingLook(i);
    const beyond = [[0, 1], ...curve.map(([error, share]) => [error, 1 - share])].filter(([, share]) => share >= floor);
    const path = beyond.map(([error, share], k) => `${k ? "L" : "M"}${at(error, share).join(" ")}`).join("");
    append(drawing, [
      svg("path", {d: path, class: "curve", style: `stroke: var(--${series.colour})`, "stroke-dasharray": series.dash})
    ]);
    for (let k = 1 + i; k < beyond.length; k += Math.max(1, Math.floor(beyond.length / 8)))
      append(drawing, [svgMark(series, ...at(...beyond[k]), 5)]);
  });
  return drawing;
}

/// Settings one below the other: mean error, and the chance of each step.
export function settingsSection(report) {
  const settings = list(report.settings), unit = lengthUnit(report);
  const rows = waysOf(report).flatMap(([way, words]) => settings.map((setting, i) => {
    const mean = object(object(setting[way])?.mean) ?? {};
    const half = isNumber(mean.sigma) ? 1.96 * mean.sigma : null;
    return {
      name: `${settingName(report, setting)}, ${words}`,
      value: mean.value,
      low: half === null ? null : Math.max(0, mean.value - half),
      high: half === null ? null : mean.value + half,
      mark: settingLook(i)
    };
  }));
  const most = Math.max(1e-9, ...rows.map((row) => row.high ?? row.value ?? 0));
  const count = (report.step_tolerances ?? []).length;
  const chances = (k) => settings.map((setting, i) => {
    const step = list(object(setting.compensated)?.steps).find((entry) => entry.at_least === k);
    return {name: settingName(report, setting), ...(object(step?.probability) ?? {}), mark: settingLook(i)};
  });
  return [
    el("p", {class: "lead"}, "The same true arms under every setting. Bars are 95 % bands."),
    el("div", {class: "pair"},
       el("div", {class: "card"}, el("h3", {}, `Mean centring error, ${unit}`),
          estimateRows(
              "Mean centring error", rows,
              {from: 0, to: 1.05 * most, title: `mean centring error, ${unit}`, write: short})),
       [...Array(count)].map(
           (_, k) =>
               el("div", {class: "card"}, el("h3", {}, `Probability of ${k + 1} or more steps, compensated`),
                  estimateRows(
                      `Probability of ${k + 1} steps or more`, chances(k + 1),
                      {from: 0, to: 1, title: "probability for one hole", write: probability})))),
    settingsTable(report)
  ];
}

function settingsTable(report) {
  const unit = lengthUnit(report);
  const rows = list(report.settings).flatMap((setting) => waysOf(report).map(([way, words]) => {
    const figures = object(setting[way]) ?? {}, quantiles = object(figures.quantiles) ?? {};
    const steps = list(figures.steps);
    return [
      `${settingName(report, setting)}, ${words}`, `${whole(setting.scored)} of ${whole(setting.runs)}`,
      short(object(figures.mean)?.value), short(figures.rms),
      ...["50", "90", "95", "99"].map((q) => short(quantiles[q])), short(figures.max),
      ...steps.map((step) => probability(object(step.in_all_holes)?.value))
    ];
  }));
  const count = (report.step_tolerances ?? []).length;
  const heads = [
    "setting", "runs scored", `mean, ${unit}`, "rms", "50 %", "90 %", "95 %", "99 %", "largest",
    ...[...Array(count)].map((_, k) => `${k + 1} or more in all of a run`)
  ];
  return el("div", {class: "card"}, table(heads, rows), refusedList(report));
}

function refusedList(report) {
  const entries =
      list(report.settings)
          .flatMap(
              (setting) => list(setting.refused)
                               .map(
                                   (reason) =>
                                       el("li", {},
                                          `${settingName(report, setting)}: ${plural(reason.runs, "run")} not scored, ${
                                              textOf(reason.reason)} ` +
                                              `(the first is run ${whole(reason.first_run)})`)));
  return entries.length ? el("ul", {class: "reasons"}, entries) : el("p", {class: "good"}, "Every run was scored.");
}

/// Bands of chances, told apart by colour and by shape.
const CHANCES = [
  {shape: "cross", colour: "case0", name: "below 50 %", least: 0},
  {shape: "triangle", colour: "case1", name: "50 to 95 %", least: 0.5},
  {shape: "square", colour: "case2", name: "95 to 99 %", least: 0.95},
  {shape: "disc", colour: "case3", name: "99 % or more", least: 0.99},
];

function chanceCase(value) { return CHANCES.findLastIndex((chance) => value >= chance.least); }

export function chanceMapSection(report, sheet) {
  const maps = list(report.maps);
  if (!sheet || maps.length === 0) return [notRecorded("The holes one by one")];
  const count = (report.step_tolerances ?? []).length;
  const state = {setting: 0, way: "compensated", step: count};
  const legend = el("ul", {class: "legend"});
  const picture = figure("Probability of the steps over the sheet", (width) => drawChanceMap(report, sheet, state, width));
  const refresh = () => {
    const holes = mapHoles(report, state);
    legend.replaceChildren(
        ...CHANCES
            .map(
                (mark, i) =>
                    el("li", {}, markIcon(mark), mark.name,
                       el("b", {}, whole(holes.filter((hole) => chanceCase(hole.chance) === i).length))))
            .reverse());
    picture.redraw();
  };
  refresh();
  return [
    el("p", {class: "lead"},
       `${sheetWords(sheet.model)}. The probability that this many steps of the tool enter a hole. Point at a ` +
           "hole for its figures."),
    el("div", {class: "card"},
       el("div", {class: "card-head"},
          choice(
              "Steps", [...Array(count)].map((_, k) => [k + 1, `${k + 1} or more`]), state.step,
              (step) => {
                state.step = step;
                refresh();
              }),
          choice(
              "Compensation", waysOf(report), state.way,
              (way) => {
                state.way = way;
                refresh();
              }),
          settingSelect(report, state, refresh)),
       picture.element, legend)
  ];
}

/// Of the chosen setting and way: [{row, column, x, y, visits, mean, chance, low, high}].
function mapHoles(report, state) {
  const map = list(report.maps).find((entry) => entry.setting === state.setting && entry.way === state.way);
  return (Array.isArray(map?.holes) ? map.holes : []).map(([row, column, x, y, visits, mean, chances]) => {
    const [chance, low, high] = chances[state.step - 1] ?? [];
    return {row, column, x, y, visits, mean, chance, low, high};
  });
}

function drawChanceMap(report, sheet, state, width) {
  const {canvas, context, frame} = drawSheet(sheet, width, {faint: true});
  const holes = mapHoles(report, state);
  const radius = markRadius(holes.map((hole) => frame.place([hole.x, hole.y])));
  CHANCES.forEach(
      (mark, i) => drawMarks(
          context, mark,
          holes.filter((hole) => chanceCase(hole.chance) === i).map((hole) => frame.place([hole.x, hole.y])), radius));
  const known = new Map(holes.map((hole) => [`${hole.row} ${hole.column}`, hole]));
  hoverHoles(canvas, frame, (place) => {
    const hole = known.get(`${place.row} ${place.column}`);
    if (!hole) return [tubeName(place), "Not visited"];
    return [
      tubeName(hole), `${plural(hole.visits, "visit")}, mean error ${short(hole.mean)} ${lengthUnit(report)}`,
      `Probability: ${probability(hole.chance)} (${probability(hole.low)} to ${probability(hole.high)})`
    ];
  });
  return canvas;
}

export function worstHolesSection(report) {
  const unit = lengthUnit(report), count = (report.step_tolerances ?? []).length;
  const cards = list(report.settings).map((setting) => {
    const rows =
        list(object(setting.compensated)?.worst_holes)
            .map(
                (hole) => [textOf(hole.hole), whole(hole.visits), short(hole.mean), ...[...Array(count)].map((_, k) => {
                  const chance = object(hole.at_least?.[k]) ?? {};
                  return `${probability(chance.value)} (${probability(chance.low)} to ${probability(chance.high)})`;
                })]);
    const heads = ["hole", "visits", `mean error, ${unit}`, ...[...Array(count)].map((_, k) => `${k + 1} or more`)];
    return el(
        "div", {class: "card"}, el("h3", {}, settingName(report, setting)),
        rows.length ? table(heads, rows) : notRecorded("Holes visited ten times or more"));
  });
  return [
    el("p", {class: "lead"}, "The holes with the largest mean error, compensated, of those visited ten times or more."),
    ...cards
  ];
}
