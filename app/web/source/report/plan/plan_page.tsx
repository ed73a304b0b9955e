// The report page of a plan.
import {duration, isNumber, plural, short, whole} from "../../../../drawing/numbers.js";
import {MARKED} from "../../../../drawing/sigma_text.js";
import {type PageKind, Summary} from "../page";
import {Lead, Missing, type OfReport} from "../parts";
import {lengthUnit, list, object, type Report, textOf} from "../values";
import {wholeToolText} from "./cases";
import {CentringSection} from "./centring";
import {ClearanceSection, StepsSection, TimeSection} from "./course";
import {SheetSection} from "./sheet_maps";
import {SideViewSection} from "./side_view";
import {TouchesSection} from "./touches";
import {TourSection} from "./tour";
import {TubesSection, WorkListSection} from "./tubes";

export const PLAN_PAGE: PageKind = {
  title: "Plan report",
  Head,
  sections: [
    {id: "sheet", title: "The sheet", Content: SheetSection},
    {id: "errors", title: "Centring errors", Content: CentringSection},
    {id: "tour", title: "The tour", Content: TourSection},
    {id: "arm", title: "The arm from the side", Content: SideViewSection},
    {id: "touches", title: "Touches and residuals", Content: TouchesSection},
    {id: "steps", title: "Steps inserted", Content: StepsSection},
    {id: "clearance", title: "Clearance", Content: ClearanceSection},
    {id: "time", title: "Time", Content: TimeSection},
    {id: "tubes", title: "Every tube", Content: TubesSection},
    {id: "list", title: "Work list", Content: WorkListSection},
  ],
  facts: ({cell, sheet, seed, version}) => [
    ["cell", cell],
    ["tube sheet", object(sheet)?.name],
    ["map fingerprint", object(sheet)?.fingerprint],
    ["seed", seed],
    ["tubeplan", version],
  ],
};

/**
 * Returns a sentence such as "60 tubes visited in 9 min 12 s of travel; against the true arm ...; least clearance 0.25
 * in."
 */
function headSentence(report: Report): string {
  const time = object(report.times)?.travel_time_s,
    {tubes, unreachable, min_clearance: least} = report;
  const visited = `${plural(list(tubes).length, "tube")} visited`;
  const parts = [
    Array.isArray(tubes) ? `${visited}${isNumber(time) ? ` in ${duration(time)} of travel` : ""}` : null,
    list(unreachable).length > 0 ? `${whole(unreachable.length)} cannot be visited` : null,
    wholeToolText(report),
    isNumber(least) ? `least clearance ${short(least)} ${lengthUnit(report)}` : null,
  ].filter((part) => part !== null);
  return parts.length === 0 ? "No results are recorded." : `${parts.join("; ")}.`;
}

/** Maximum length of a fact in the summary grid [characters]; a longer fact becomes a separate sentence. */
const LONGEST_FACT = 60;

function Head({report}: OfReport) {
  const rows = (Array.isArray(report.summary) ? report.summary : [])
    .filter((row: unknown) => Array.isArray(row) && row.length >= 2)
    .map(([name, value]: [unknown, unknown]) => [textOf(name), isNumber(value) ? short(value) : textOf(value)]) as [
    string,
    string,
  ][];
  const warnings = rows.filter(([name]) => name === "warning"),
    others = rows.filter(([name]) => name !== "warning");
  return (
    <>
      <p class="sentence">{textOf(report.sentence, headSentence(report))}</p>
      <Standing report={report} />
      {report.sentence ? <Lead>{headSentence(report)}</Lead> : null}
      {rows.length === 0 ? (
        <Missing what="The summary" />
      ) : (
        <Summary facts={others.filter(([, value]) => value.length <= LONGEST_FACT)} />
      )}
      {others
        .filter(([, value]) => value.length > LONGEST_FACT)
        .map(([name, value]) => (
          <p class="remark">
            <b>{name}</b>: {value}.
          </p>
        ))}
      {warnings.map(([, value]) => (
        <p class="remark bad">
          {MARKED}
          <b>Warning</b>: {value}.
        </p>
      ))}
    </>
  );
}

/** Base for which the plan is proved and the numbers of steps are stated. */
function Standing({report}: OfReport) {
  const {placed, words} = object(report.base) ?? {};
  if (textOf(words, "") === "") return null;
  const isPlaced = placed !== false;
  return (
    <p class={`standing ${isPlaced ? "" : "bad"}`}>
      <span>
        {isPlaced ? "" : MARKED}
        <b>Proved {textOf(words)}</b>.
        {isPlaced ? "" : " Steps, where they are shown, have marks of their own: hollow and blue."}
      </span>
    </p>
  );
}
