// Where a joint's errors are: each joint's against its angle, its direction, its moment and the load, the loudest
// framed.
import {loudest, MULTIPLE_COLUMNS, multiplesOf, multiplesScale, panelPlaces} from "../drawing/joint_multiples.js";
import {chance, plainUnit, short} from "../drawing/numbers.js";
import {MOST_POINTS} from "../drawing/shares.js";
import {el, figure, notRecorded, svg} from "./elements.js";
import {errorAxesOf, errorPairsOf, pairLegend, pointMarks} from "./error_law.js";
import {list} from "./values.js";

export function jointPanelsSection(report) {
  const [errors] = errorPairsOf(report), {variables, parts} = errorAxesOf(report, errors);
  const rows = new Map(list(report.joints).map(({name, row}) => [name, row ?? ""]));
  const multiples =
      multiplesOf({errors, variables, parts, tested: list(report.tested), rowOf: (joint) => rows.get(joint) ?? ""});
  if (multiples.length === 0) return [notRecorded("The errors joint by joint")];
  const loud = loudest(multiples), most = multiplesScale(multiples, errors);
  return [
    el("p", {class: "lead"},
       "The error expressed as an error of each joint, against the joint's angle, its direction of approach, the moment about it " +
           `and the load, all to one scale of \u00b1${short(most)} ${
               plainUnit(multiples[0].part.unit)}; larger errors are drawn at its edge. The p-value of each variable is corrected for the number of ` +
           `tests; ${loud ? "the most significant is framed" : "none is below 0.01"}.`),
    pairLegend(errors, [["line-sign", `means ${errors.tested === 0 ? "before" : "after"}`]], MOST_POINTS),
    el("div", {class: "card"}, panelTable(errors, multiples, loud, most))
  ];
}

function panelTable(errors, multiples, loud, most) {
  const cell = (joint, column) => {
    const entry = multiples.find((one) => one.joint === joint && one.column === column);
    return el("td", {}, entry ? panel(entry, errors, most, entry === loud) : "\u2013");
  };
  const unitOf = (joint) => plainUnit(multiples.find((entry) => entry.joint === joint)?.part.unit ?? "");
  return el(
      "table", {class: "joint-panels"},
      el("thead", {}, el("tr", {}, el("th", {}), MULTIPLE_COLUMNS.map((column) => el("th", {scope: "col"}, column)))),
      el("tbody", {},
         errors.joints.map(
             (joint) =>
                 el("tr", {}, el("th", {scope: "row"}, joint, el("small", {}, ` ${unitOf(joint)}`)),
                    MULTIPLE_COLUMNS.map((column) => cell(joint, column))))));
}

function panel(entry, errors, most, isLoud) {
  const words = `Error of ${entry.joint} against ${entry.variable.name}, ${chance(entry.p)}${
      isLoud ? ", the most significant" : ""}`;
  const picture = figure(words, (width) => drawPanel(entry, errors, most, width));
  return el(
      "div", {class: isLoud ? "joint-panel loud" : "joint-panel"}, picture.element, el("small", {}, chance(entry.p)));
}

function drawPanel(entry, errors, most, width) {
  const height = 64, {points, means, zero} = panelPlaces(entry, errors, most, width, height);
  return svg(
      "svg", {viewBox: `0 0 ${width} ${height}`, width, height, class: "chart"},
      svg("path", {d: `M0 ${zero}H${width}`, class: "grid"}),
      points.map((places, k) => pointMarks(errors.series[k].mark.shape, places, k)),
      svg("path", {d: means.length > 0 ? `M${means.map(([x, y]) => `${x} ${y}`).join("L")}` : "M0 0", class: "slope"}));
}
