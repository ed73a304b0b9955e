// The sheet before and after compensation, every visited tube by its case.
import {stateMark, UNREACHABLE, UNSCORED} from "../drawing/kinds.js";
import {fixed, isNumber, plural, probability, short, whole} from "../drawing/numbers.js";
import {sheetWords} from "../drawing/sheet_model.js";
import {stepKinds, stepText} from "../drawing/steps.js";
import {visitText} from "../drawing/visits.js";
import {chancesOf, modesOf, predictedCase, scoredCase} from "./cases.js";
import {choice, el, figure, notRecorded} from "./elements.js";
import {drawMarks, markIcon} from "./mark_drawing.js";
import {drawSheet, stateGroups, stateText} from "./sheet_drawing.js";
import {markRadius} from "./sheet_frame.js";
import {hoverHoles} from "./tooltip.js";
import {angleUnit, lengthUnit, list, object, textOf, tubeName} from "./values.js";

/// What a map can show: each mode that was scored against the true arm, and what the plan itself expects.
function mapModes(report) {
  const tubes = list(report.tubes);
  const scored = modesOf(report)
                     .map((mode) => ({...mode, caseOf: (tube) => scoredCase(tube, mode.key, report.steps)}))
                     .filter((mode) => tubes.some((tube) => mode.caseOf(tube) !== null));
  const predicted =
      {key: "predicted", name: "as predicted", brief: "predicted", caseOf: (tube) => predictedCase(tube, report)};
  return {
    before: scored.find((mode) => mode.key === "none") ?? null,
    after: [...scored.filter((mode) => mode.key !== "none").reverse(), predicted]
  };
}

export function sheetMapsSection(report, sheet) {
  if (!sheet) return [notRecorded("The sheet's holes")];
  const {before, after} = mapModes(report);
  return [
    el("p", {class: "lead"},
       `${plural(sheet.holes.length, "hole")}, ${sheetWords(sheet.model)}. Every mark is a visited tube: how ` +
           "far the stepped calibration tool goes in. Point at a hole for its figures; the boxes below a map hide " +
           "and show its marks." +
           (before ? "" : " Centring without compensation is not shown: the plan has no true arm to be scored against.")),
    el("div", {class: "pair"}, before && sheetMap(report, sheet, "Before", [before]),
       sheetMap(report, sheet, before ? "After" : "The plan", after)),
    unreachableList(report),
  ];
}

/// One map with its heading, a choice of mode when there are several, and its legend with live counts.
function sheetMap(report, sheet, heading, modes) {
  const state = {mode: modes[0], kinds: stepKinds(report), hidden: new Set()};
  const legend = el("ul", {class: "legend"});
  const title = el("h3");
  const picture = figure(
      `Tube sheet, ${sheetWords(sheet.model)}: ${heading.toLowerCase()}`,
      (width) => drawMap(report, sheet, state, width));
  const refresh = () => {
    title.textContent = `${heading}: ${state.mode.name}`;
    legend.replaceChildren(...legendEntries(report, sheet, state, refresh));
    picture.redraw();
  };
  refresh();
  const modeChoice = modes.length < 2 ?
      null :
      choice("Compensation shown", modes.map((mode) => [mode, mode.brief]), state.mode, (mode) => {
        state.mode = mode;
        refresh();
      });
  return el("div", {class: "card"}, el("div", {class: "card-head"}, title, modeChoice), picture.element, legend);
}

/// The groups of marks that a map shows, each {mark, name, holes}, in drawing order.
function markGroups(report, state) {
  const tubes = list(report.tubes).filter((tube) => isNumber(tube.x) && isNumber(tube.y));
  const unreachable = list(report.unreachable).filter((tube) => isNumber(tube.x) && isNumber(tube.y));
  return [
    ...state.kinds
        .map((kind, k) => ({...kind, holes: tubes.filter((tube) => state.mode.caseOf(tube) === k)}))
        .reverse(),
    {mark: UNREACHABLE, name: "cannot be visited", holes: unreachable},
    {mark: UNSCORED, name: "not scored", holes: tubes.filter((tube) => state.mode.caseOf(tube) === null)}
  ];
}

function drawMap(report, sheet, state, width) {
  const {canvas, context, frame} = drawSheet(sheet, width);
  const groups = markGroups(report, state);
  const places = groups.flatMap((group) => group.holes.map((hole) => frame.place([hole.x, hole.y])));
  const radius = markRadius(places);
  for (const {mark, holes} of groups) {
    if (!state.hidden.has(mark)) drawMarks(context, mark, holes.map((hole) => frame.place([hole.x, hole.y])), radius);
  }
  hoverHoles(canvas, frame, holeDescriber(report, sheet, state.mode));
  return canvas;
}

function legendEntries(report, sheet, state, refresh) {
  const toggle = (mark) => (event) => {
    if (event.target.checked)
      state.hidden.delete(mark);
    else
      state.hidden.add(mark);
    refresh();
  };
  const groups = markGroups(report, state);
  const [unreachable, unscored] = groups.slice(state.kinds.length);
  const cases = groups.slice(0, state.kinds.length).reverse();
  const shown = [...cases, unreachable, ...(unscored.holes.length > 0 ? [unscored] : [])];
  const marks = shown.map(
      ({mark, name, holes}) =>
          el("li", {},
             el("label", {}, el("input", {type: "checkbox", checked: !state.hidden.has(mark), change: toggle(mark)}),
                markIcon(mark), name, el("b", {}, whole(holes.length)))));
  const plain = (mark, name, count) => el("li", {}, markIcon(mark), name, el("b", {}, whole(count)));
  const states = stateGroups(sheet).map(({mark, name, holes}) => plain(mark, name, holes.length));
  const listed = list(report.tubes).length + list(report.unreachable).length;
  return [...marks, plain(stateMark("open"), "not on the list", Math.max(0, sheet.holes.length - listed)), ...states];
}

/// Text for a hole: name and state, and for a visited tube its order, errors and probabilities.
export function holeDescriber(report, sheet, mode) {
  const tubes = new Map(list(report.tubes).map((tube) => [`${tube.row} ${tube.column}`, tube]));
  const unreachable = new Map(list(report.unreachable).map((tube) => [`${tube.row} ${tube.column}`, tube]));
  const unit = lengthUnit(report);
  return (hole) => {
    const key = `${hole.row} ${hole.column}`;
    const name = `Row ${textOf(hole.row)}, column ${textOf(hole.column)}`;
    const place = `x ${fixed(hole.x, 3)}, y ${fixed(hole.y, 3)} ${unit}`;
    const states = stateText(sheet, hole);
    if (unreachable.has(key)) return [name, place, states, `Cannot be visited: ${textOf(unreachable.get(key).reason)}`];
    if (!tubes.has(key)) return [name, place, states, "Not on the list"];
    return [name, place, states, ...tubeLines(tubes.get(key), mode, report, unit)];
  };
}

function tubeLines(tube, mode, report, unit) {
  const score = object(tube[mode.key]);
  const index = mode.caseOf(tube);
  const chances = chancesOf(tube, report);
  return [
    `V${visitOf(report, tube).slice(1)}`,
    score ? `Error, ${mode.name}: ${short(score.error)} ${unit} (dx ${short(score.dx)}, dy ${short(score.dy)})` : null,
    index === null ? null : `${score ? "Tool" : "Expected"}: ${stepText(report.step_words, index)}`,
    score && isNumber(score.approach_deviation) ?
        `Deviation from the hole's axis during the approach: ${short(score.approach_deviation)} ${unit}` :
        null,
    `Predicted error: ${short(tube.predicted_error)} ${unit}; tilt ${short(tube.tilt)} ${angleUnit(report)}`,
    chances ? `Probability of ${[...chances.keys()].join("/")} steps: ${chances.map(probability).join(" / ")}` : null,
  ];
}

/// The tubes that cannot be visited, by reason; long lists fold away.
function unreachableList(report) {
  const tubes = list(report.unreachable);
  if (!Array.isArray(report.unreachable)) return notRecorded("Tubes that cannot be visited");
  if (tubes.length === 0) return el("p", {class: "good"}, "Every tube on the list is visited.");
  const reasons = new Map();
  for (const tube of tubes) {
    const reason = textOf(tube.reason, "no reason recorded");
    reasons.set(reason, [...(reasons.get(reason) ?? []), tube]);
  }
  const entries = [...reasons].sort((a, b) => b[1].length - a[1].length).map(([reason, group]) => {
    const names = group.map(tubeName).join(", ");
    return el(
        "li", {}, el("b", {}, `${reason}: `),
        group.length <= 12 ? names : el("details", {}, el("summary", {}, plural(group.length, "tube")), names));
  });
  return el(
      "div", {class: "card"}, el("h3", {}, markIcon(UNREACHABLE), ` ${plural(tubes.length, "tube")} cannot be visited`),
      el("ul", {class: "reasons"}, entries));
}

/// "visit 7 of 60": the tubes are listed in visiting order.
export function visitOf(report, tube) {
  const tubes = list(report.tubes);
  return visitText(tubes.indexOf(tube), tubes.length);
}
