// The page itself, section by section.
import {duration, isNumber, plural, short, whole} from "../drawing/numbers.js";
import {MARKED} from "../drawing/sigma_text.js";
import {wholeToolText} from "./cases.js";
import {clearanceSection} from "./clearance_view.js";
import {append, el, followColourScheme, notRecorded} from "./elements.js";
import {errorArrowsSection} from "./error_arrows.js";
import {readReport, showSections} from "./sections.js";
import {readSheet} from "./sheet_frame.js";
import {sheetMapsSection} from "./sheet_maps.js";
import {sideViewSection} from "./side_view.js";
import {stepSection} from "./step_table.js";
import {timingSection} from "./timing_view.js";
import {touchesSection} from "./touches_view.js";
import {tourSection} from "./tour_view.js";
import {tubeTableSection} from "./tube_table.js";
import {lengthUnit, list, object, textOf} from "./values.js";
import {workListSection} from "./work_list.js";

const SECTIONS = [
  {id: "sheet", title: "The sheet", make: sheetMapsSection},
  {id: "errors", title: "Centring errors", make: errorArrowsSection},
  {id: "tour", title: "The tour", make: tourSection},
  {id: "arm", title: "The arm from the side", make: sideViewSection},
  {id: "touches", title: "Touches and residuals", make: touchesSection},
  {id: "steps", title: "Steps inserted", make: stepSection},
  {id: "clearance", title: "Clearance", make: clearanceSection},
  {id: "time", title: "Time", make: timingSection},
  {id: "tubes", title: "Every tube", make: tubeTableSection},
  {id: "list", title: "Work list", make: workListSection},
];

/// "60 tubes visited in 9 min 12 s of travel; against the true arm ...; least clearance 0.25 in."
function headSentence(report) {
  const parts = [];
  if (Array.isArray(report.tubes)) {
    const time = object(report.times)?.travel_time_s;
    parts.push(`${plural(list(report.tubes).length, "tube")} visited${
        isNumber(time) ? ` in ${duration(time)} of travel` : ""}`);
  }
  if (Array.isArray(report.unreachable) && report.unreachable.length > 0)
    parts.push(`${whole(report.unreachable.length)} cannot be visited`);
  const inserted = wholeToolText(report);
  if (inserted) parts.push(inserted);
  if (isNumber(report.min_clearance))
    parts.push(`least clearance ${short(report.min_clearance)} ${lengthUnit(report)}`);
  return parts.length === 0 ? "No results are recorded." : `${parts.join("; ")}.`;
}

function summaryRows(report) {
  return (Array.isArray(report.summary) ? report.summary : [])
      .filter((row) => Array.isArray(row) && row.length >= 2)
      .map(([name, value]) => [textOf(name), typeof value === "number" ? short(value) : textOf(value)]);
}

/// For which base the plan is proved and steps are given.
function standingLine(report) {
  const base = object(report.base);
  if (textOf(base?.words, "") === "") return null;
  return base.placed === false ?
      el("p", {class: "standing bad"}, MARKED, el("b", {}, `Proved ${textOf(base.words)}`),
         ". Steps, where they are shown, have marks of their own: hollow and blue.") :
      el("p", {class: "standing"}, el("b", {}, `Proved ${textOf(base.words)}`), ".");
}

/// What is longer is no figure for the summary's grid, but a sentence of its own.
const LONGEST_FACT = 60;

function showHead(report) {
  const title = textOf(report.title, "Plan report");
  document.title = title;
  const rows = summaryRows(report);
  const warnings = rows.filter(([name]) => name === "warning"), others = rows.filter(([name]) => name !== "warning");
  const isBrief = ([, value]) => value.length <= LONGEST_FACT;
  append(document.getElementById("head"), [
    el("h1", {}, title), el("p", {class: "sentence"}, textOf(report.sentence, headSentence(report))),
    standingLine(report), report.sentence ? el("p", {class: "lead"}, headSentence(report)) : null,
    rows.length === 0 ?
        notRecorded("The summary") :
        el("dl", {class: "summary"},
           others.filter(isBrief).map(([name, value]) => el("div", {}, el("dt", {}, name), el("dd", {}, value)))),
    others.filter((row) => !isBrief(row))
        .map(([name, value]) => el("p", {class: "remark"}, el("b", {}, name), `: ${value}.`)),
    warnings.length === 0 ?
        null :
        el("ul", {class: "warnings"},
           warnings.map(([, value]) => el("li", {class: "bad"}, MARKED, el("b", {}, "Warning"), `: ${value}.`)))
  ]);
}

function showFoot(report) {
  const facts = [
    ["cell", report.cell], ["tube sheet", object(report.sheet)?.name],
    ["map fingerprint", object(report.sheet)?.fingerprint], ["seed", report.seed], ["tubeplan", report.version]
  ].filter(([, value]) => textOf(value, "") !== "");
  append(document.getElementById("foot"), [facts.map(([name, value]) => `${name} ${textOf(value)}`).join(" \u00b7 ")]);
}

function showReport() {
  const report = readReport();
  showHead(report);
  showSections(SECTIONS, report, readSheet(report));
  showFoot(report);
  followColourScheme();
}

showReport();
