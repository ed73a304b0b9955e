// How many steps of the tool enter.
import {exact, isNumber, percent, plural, whole} from "../drawing/numbers.js";
import {outlineOf} from "../drawing/shapes.js";
import {stepKinds, stepMark} from "../drawing/steps.js";
import {countsOf, modesOf} from "./cases.js";
import {append, el, figure, label, notRecorded, svg, table} from "./elements.js";
import {markIcon} from "./mark_drawing.js";
import {lengthUnit, list, object} from "./values.js";

export function stepSection(report) {
  const rows = modesOf(report).map((mode) => ({name: mode.brief, counts: countsOf(report, mode.key)}));
  const scored = rows.filter((row) => row.counts);
  if (scored.length === 0) return [notRecorded("Scores against a true arm")];
  const bars = figure("Fraction of tubes by steps inserted", (width) => drawStepBars(scored, width));
  return [
    el("p", {class: "lead"}, "How far the tool enters, by number of tubes, without compensation and with it."),
    el("div", {class: "pair"},
       el("div", {class: "card"}, el("h3", {}, "Tubes by steps inserted"), stepTable(report, rows)),
       el("div", {class: "card"}, el("h3", {}, "The same as shares"), bars.element)),
  ];
}

function stepTable(report, rows) {
  const tolerances = list(report.steps).map((step) => step.tolerance).filter(isNumber), kinds = stepKinds(report);
  const heads = [
    "",
    ...kinds.map(
        ({mark}, i) =>
            el("span", {}, markIcon(mark), ` ${plural(i, "step").replace(" ", "\u00a0")}`,
               el("small", {}, errorRange(tolerances, i)))),
    "of"
  ];
  const cells = rows.map(({name, counts}) => {
    if (!counts) return [name, ...kinds.map(() => null), "not recorded"];
    const total = counts.reduce((sum, count) => sum + count, 0);
    return [
      name, ...counts.map((count) => `${whole(count)} (${percent(total > 0 ? count / total : null)})`), whole(total)
    ];
  });
  return [table(heads, cells), list(report.steps).length === 0 ? notRecorded("The tool's steps") : toolNote(report)];
}

/// The centring errors of a case: above the first tolerance, or up to the step's own.
function errorRange(tolerances, index) {
  if (index > tolerances.length || tolerances.length === 0) return "";
  return index === 0 ? `> ${exact(tolerances[0])}` : `\u2264 ${exact(tolerances[index - 1])}`;
}

function toolNote(report) {
  const unit = lengthUnit(report);
  const steps = list(report.steps).map((step, i) => `step ${i + 1}: ${exact(step.diameter)}`).join(", ");
  return el(
      "p", {class: "note"},
      `Below each case, its centring error (${unit}). Diameters (${unit}): ${steps}; ` +
          `hole: ${exact(object(report.sheet)?.hole_diameter)}.`);
}

/// Stacked bars of shares; every part carries its case's symbol and its count.
export function drawStepBars(rows, width) {
  const tall = 24, gap = 34, left = 2, wide = width - 4;
  const height = rows.length * (tall + gap) + 4;
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, width, height, class: "chart"});
  rows.forEach(({name, counts}, i) => {
    const y = i * (tall + gap) + 20, total = counts.reduce((sum, count) => sum + count, 0) || 1;
    append(drawing, [label(left, y - 6, `${name} (${whole(total)})`)]);
    let x = left;
    counts.forEach((count, index) => {
      const part = wide * count / total;
      if (count > 0) append(drawing, [barPart(x, y, part, tall, {steps: index, of: counts.length - 1, text: whole(count)})]);
      x += part;
    });
  });
  return drawing;
}

function barPart(x, y, width, height, {steps, of, text}) {
  const mark = stepMark(steps, of);
  const middle = y + height / 2, start = x + Math.min(14, width / 2);
  const {fill, line} = outlineOf(mark.shape, start, middle, 5);
  return svg(
      "g", {},
      svg("rect",
          {x: x + 0.5, y, width: Math.max(1, width - 1), height, rx: 2, class: "bar", fill: `var(--${mark.colour})`}),
      width > 14 ? svg("path", {d: fill || line, class: fill ? "bar-mark" : "bar-cross"}) : null,
      width > 34 ? label(start + 11, middle + 4, text, {class: "bar-text"}) : null,
      svg("title", {}, `${plural(steps, "step")}: ${text}`));
}
