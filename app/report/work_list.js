// The tubes in visiting order as a sheet of paper to tick off at the arm; every line names leg, row and
// column, and those that cannot be visited stand at its end with their reason.
import {isNumber, plural, short, whole} from "../drawing/numbers.js";
import {el, notRecorded, printButton, table} from "./elements.js";
import {list, object, textOf, tubeName} from "./values.js";

export function workListSection(report) {
  const tubes = list(report.tubes);
  if (tubes.length === 0) return [notRecorded("The work list")];
  const place = el("div");
  const show = () => {
    if (place.childElementCount === 0) place.append(...workList(report, tubes));
  };
  const card = el(
      "details", {class: "card", toggle: (event) => event.target.open && show()},
      el("summary", {}, `Work list of ${plural(tubes.length, "tube")}, to print`), place);
  const print = printButton("Print the list alone", () => {
    show();
    card.open = true;
  });
  return [print, card];
}

function workList(report, tubes) {
  const sheet = object(report.sheet) ?? {}, leg = String(sheet.leg ?? "");
  const head = el(
      "p", {},
      [sheet.name, sheet.leg_words, sheet.view_words, `sheet ${textOf(sheet.fingerprint)}`, ""]
          .map((text) => textOf(text, ""))
          .join(" \u00b7 "),
      `${plural(tubes.length, "tube")} \u00b7 signed ____________________  date ____________`);
  const rows = tubes.map((tube, i) => ["\u2610", whole(i + 1), `${leg} ${tubeName(tube)}`, stayText(tube), ""]);
  const parts = [head, table(["done", "visit", "tube", "stay, s", "remark"], rows, {text: [0, 2, 4]})];
  const missed = list(report.unreachable);
  if (missed.length > 0)
    parts.push(
        el("p", {}, `${plural(missed.length, "tube")} cannot be visited:`),
        table(["tube", "reason"], missed.map((tube) => [`${leg} ${tubeName(tube)}`, tube.reason]), {text: [0, 1]}));
  return parts;
}

function stayText(tube) { return isNumber(tube.dwell_s) ? short(tube.dwell_s) : ""; }
