// What to measure next so that open explanations are told apart, and warnings about effects.
import {PAIR_HEADS, pairCells, senseArrow, separations} from "../drawing/conditions.js";
import {short} from "../drawing/numbers.js";
import {barCell} from "./effect_ranking.js";
import {el, printButton, table} from "./elements.js";
import {list, object, textList, textOf} from "./values.js";

export function isSplit(report) { return object(report.splitting) !== null || list(report.next_readings).length > 0; }

export function nextReadingsSection(report) {
  const splitting = object(report.splitting) ?? {}, next = list(report.next_readings), pairs = list(splitting.pairs);
  return [
    el("p", {class: "lead"}, textOf(splitting.advice, "These readings would discriminate between the explanations.")),
    next.length === 0 ? null : printButton("Print these readings alone, to fill in"),
    next.length === 0 ? null : el("div", {class: "card"}, nextReadingsTable(report, next)),
    pairs.length === 0 ? null : el("div", {class: "card"}, el("h3", {}, "What they would do"), pairsTable(pairs)),
    otherMeansCard(splitting)
  ];
}

/// What is to be written down of a reading, by the document.
function toFill(reading) {
  const fill = object(reading.fill_in) ?? {};
  return [...textList(fill.columns), ...textList(fill.optional)];
}

/// Joints with an arrow for the sense in which each must arrive, and the separation as a bar of the largest.
function nextReadingsTable(report, next) {
  const joints = Object.keys(object(next[0].posture) ?? {});
  const blank = [...new Set(next.flatMap(toFill))];
  const rows = separations(next).map(({reading: entry, ...separation}, i) => [
    `${i + 1}. ${textOf(entry.point, textOf(entry.kind))}`, short(entry.load),
    ...joints.map((joint) => `${short(entry.posture?.[joint])}${senseArrow(object(entry.senses)?.[joint])}`),
    textList(entry.splits).join(" from "),
    barCell(separation),
    ...blank.map((column) => toFill(entry).includes(column) ? el("span", {class: "to-fill"}) : null)
  ]);
  const text = [0, 2 + joints.length];
  return table(["reading", "load", ...joints, "splits", "by, in standard deviations", ...blank], rows, {text});
}

function pairsTable(pairs) {
  return table(PAIR_HEADS, pairs.map(pairCells), {text: [0, 1]});
}

function otherMeansCard(splitting) {
  const means = list(splitting.other_means), columns = textList(splitting.columns_to_add);
  if (means.length + columns.length === 0) return null;
  return el(
      "div", {class: "card"}, el("h3", {}, means.length > 0 ? "Alternative measurements" : "What else to record"),
      el("ul", {class: "reasons"}, means.map((entry) => el("li", {}, textOf(entry.what))),
         columns.map((text) => el("li", {}, text))));
}

export function warningsSection(report) {
  return [el("div", {class: "card"},
             el("ul", {class: "reasons"},
                list(report.warnings).map((entry) => el("li", {}, textOf(object(entry)?.sentence, textOf(entry))))))];
}
