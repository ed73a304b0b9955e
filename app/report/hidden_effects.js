// What could still be there unseen, what was not tried, and which readings were left out.
import {plainName} from "../drawing/explanations.js";
import {plural, short} from "../drawing/numbers.js";
import {el, notRecorded, table} from "./elements.js";
import {list, textList, textOf} from "./values.js";

export function hiddenEffectsSection(report) {
  const detectable = list(report.detectable);
  return [
    el("p", {class: "lead"},
       "Smallest size that these readings would detect with a power of 80 %. Smaller effects may be present. " +
           "Marked \u25b2: only a size that no machine has would show, so these readings say nothing about it."),
    detectable.length === 0 ? notRecorded("What could still hide") :
                              el("div", {class: "card"}, detectableTable(detectable)),
    el("div", {class: "pair"}, notTriedCard(report), setAsideCard(report))
  ];
}

/// One row for each effect's number, with all places.
function detectableTable(detectable) {
  const groups = new Map();
  for (const entry of detectable) {
    const key = `${entry.effect} ${entry.number} ${entry.unit}`;
    groups.set(key, [...(groups.get(key) ?? []), entry]);
  }
  const rows = [...groups.values()].map(
      (entries) =>
          [el("span", {class: "effect-name"}, textOf(entries[0].effect)), plainName(entries[0].number),
           textOf(entries[0].unit, "") === "1" ? "" : textOf(entries[0].unit),
           el("span", {}, entries.map(detectablePlace))]);
  return table(["effect", "number", "unit", "smallest detectable size, by place"], rows, {text: [0, 1, 2, 3]});
}

function detectablePlace(entry) {
  const hidden = entry.beyond_plausible === true;
  return el(
      "span", {class: hidden ? "places cannot" : "places"}, `${textOf(entry.at)} `,
      el("b", {}, hidden ? "\u25b2" : short(entry.size)));
}

function notTriedCard(report) {
  const lacks = textList(report.not_tried);
  const none = Array.isArray(report.not_tried) ? el("p", {class: "note"}, "Every effect of the catalogue was tried.") :
                                                 notRecorded("What was not tried");
  return el(
      "div", {class: "card"}, el("h3", {}, "Not tried"),
      lacks.length === 0 ? none : el("ul", {class: "reasons"}, lacks.map((text) => el("li", {}, text))));
}

function setAsideCard(report) {
  const aside = textList(report.set_aside);
  const none = Array.isArray(report.set_aside) ?
      el("p", {class: "note"}, "None: no reading stands out from the others.") :
      notRecorded("Readings set aside");
  const said = `${plural(aside.length, "reading")} stood out as no effect would move them and ${
      aside.length === 1 ? "was" : "were"} left out: ${aside.join(", ")}.`;
  return el(
      "div", {class: "card"}, el("h3", {}, "Readings set aside"), aside.length === 0 ? none : el("p", {}, said));
}
