// Every effect that was tried, most probable first.
import {isNumber, whole} from "../drawing/numbers.js";
import {IS_THERE, MOST_RANKED, rankingRows, triedText} from "../drawing/ranking.js";
import {el, notRecorded, svg, table} from "./elements.js";
import {reportExplanations} from "./error_series.js";
import {list, object, textList} from "./values.js";

export function rankingSection(report) {
  const rows = rankingRows(list(report.ranking).map((entry) => ({...entry, size: object(entry.size)})));
  if (rows.length === 0) return [notRecorded("The ranking of effects")];
  const others = rows.slice(MOST_RANKED);
  return [
    el("p", {class: "lead"}, rankingLead(report)),
    el("div", {class: "card"}, rankingTable(rows.slice(0, MOST_RANKED))),
    others.length > 0 ? el("details", {}, el("summary", {}, `The other ${whole(others.length)}`),
                           el("div", {class: "card"}, rankingTable(others))) :
                        null
  ];
}

function rankingLead(report) {
  const joined = reportExplanations(report).some((entry) => entry.effects.length > 1) ?
      " The explanation above combines several; here the reduction of chi-square is that of each alone." :
      "";
  const lacks = textList(report.not_tried);
  const about = {
    ranking: list(report.ranking),
    probability: object(report.probability),
    probability_words: report.probability_words
  };
  return `${triedText(about)}${joined}${
      lacks.length === 0 ? "" : ` Not tried: ${lacks.join("; ")}.`}`;
}

/// A figure behind a bar of its share of the largest.
export function barCell({share, text}) {
  const wide = 46, tall = 11;
  const bar = (width, kind) => svg("rect", {x: 0.5, y: 0.5, width, height: tall - 1, class: kind});
  return el(
      "span", {class: "bar-cell"},
      svg("svg", {width: wide, height: tall, "aria-hidden": "true"}, bar(wide - 1, "bar-frame"),
          share > 0 ? bar(Math.max(1, (wide - 1) * share), "bar-fill") : null),
      text);
}

function rankedName({entry, title, words, kept}) {
  const hides = isNumber(entry.kept_fraction) && entry.kept_fraction < 0.5;
  return el(
      "span", {class: "effect-name"}, title,
      [words, hides ? kept : ""].map((text) => (text ? el("small", {}, text) : null)));
}

function rankingTable(rows) {
  const cells =
      rows.map((row) => [rankedName(row), barCell(row.probability), barCell(row.fall),
                         el("span", {}, row.size.text, el("small", {class: "number-name"}, row.size.name)),
                         barCell(row.shows)]);
  return el(
      "div", {class: "ranking"},
      table(["effect", IS_THERE, "chi-square reduction", "size", "observable"], cells));
}
