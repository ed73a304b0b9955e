// The report page of a shift's hand-over. The most important information for the next shift comes first.
import {duration, fixed, isNumber, plural, whole} from "../../../../drawing/numbers.js";
import {CountsTable, type NamedCounts} from "../../outage/totals_table";
import {type PageKind, Summary} from "../page";
import {Card, Missing, type OfReport, TableCard} from "../parts";
import {list, object, type Report, textList, textOf} from "../values";
import {GroupedTubes, type TubeGroup} from "./grouped_tubes";
import {planOf, ScheduleSection} from "./job_plan_page";
import {LogSection} from "./shift_log";
import {MapsSection, timeLeft} from "./standing_maps";

export const HAND_OVER_PAGE: PageKind = {
  title: "Hand-over",
  Head,
  sections: [
    {id: "first", title: "Know this first", Content: FirstSection},
    {id: "work", title: "Done in the shift", Content: WorkSection},
    {id: "totals", title: "Totals", Content: TotalsSection},
    {id: "maps", title: "Remaining work on each leg", Content: MapsSection},
    {id: "plan", title: "The plan", Content: ScheduleSection},
    {id: "log", title: "Log of the shift", Content: LogSection},
  ],
  facts: ({made_at, last_event, planned_at, version}) => [
    ["made at", made_at],
    ["after event", last_event],
    ["planned at", planned_at],
    ["tubeplan", version],
  ],
};

/** Returns a time of the record in words: "2025-04-02 06:15". */
export function timeWords(at: unknown): string {
  return textOf(at)
    .replace("T", " ")
    .replace(/:\d\dZ$/, "");
}

function shiftWords(report: Report): string {
  const shift = object(report.shift);
  if (!shift) return `Nothing has been recorded yet for ${textOf(report.asked, "any shift")}.`;
  return `${textOf(shift.words)}, ${timeWords(shift.from)} to ${timeWords(shift.to)} UTC.`;
}

/** Returns the balance of the shift of the report; null if it has no event. */
function shiftRow(report: Report): Report | null {
  const wanted = object(report.shift)?.words;
  return list(report.shifts).find((row) => row.name === wanted) ?? null;
}

function Head({report}: OfReport) {
  const total = object(report.total) ?? {},
    row = shiftRow(report),
    left = timeLeft(report);
  const attention =
    list(report.wrong_tubes).length +
    textList(report.plugged_at_one_end).length +
    list(report.plugged_in_the_meantime).length;
  return (
    <>
      <p class="sentence">{shiftWords(report)}</p>
      <Summary
        facts={[
          ["done in the shift", row ? whole(row.done_in_shift) : "0"],
          [
            "done in all",
            `${whole(total.done)} of ${whole(total.planned - total.excluded)} (${fixed(total.percent, 1)} %)`,
          ],
          [
            "left",
            `${whole(total.unresolved)}: ${whole(total.open)} open, ${whole(total.queued)} again, ${whole(total.held)} held`,
          ],
          [
            "time left of all arms",
            isNumber(left) ? duration(left) : planOf(report) ? "not all is planned" : "no plan yet",
          ],
          ["warnings", whole(attention)],
        ]}
      />
    </>
  );
}

/** Warnings of the record, worst first: their sign, the list in the report, and their words. */
const WARNINGS: {key: string; sign: string; words: (of: Report) => string}[] = [
  {
    key: "wrong_tubes",
    sign: "\u2715",
    words: ({tube, found, who, at}) =>
      `At ${textOf(tube)} ${textOf(who)} found ${textOf(found)} (${timeWords(at)}): confirm the tube again before any tool enters.`,
  },
  {
    key: "plugged_at_one_end",
    sign: "\u25b2",
    words: ({tube}) =>
      `${textOf(tube)} is plugged at this end only: plug the other end too, or check which tube it is.`,
  },
  {
    key: "plugged_in_the_meantime",
    sign: "\u25b2",
    words: ({tube, package: of}) =>
      `${textOf(tube)} is plugged, but ${textOf(of)} still plans to visit it: mark it excluded there.`,
  },
];

function FirstSection({report}: OfReport) {
  const warnings = WARNINGS.flatMap(({key, sign, words}) =>
    (Array.isArray(report[key]) ? report[key] : []).map((of: unknown) => [
      sign,
      words(typeof of === "string" ? {tube: of} : (object(of) ?? {})),
    ]),
  );
  const held = list(report.held) as unknown as TubeGroup[],
    retests = list(report.retests);
  if (warnings.length + held.length + retests.length === 0)
    return <p class="good">No warning, nothing held, nothing to be visited again.</p>;
  return (
    <>
      {warnings.length > 0 ? (
        <Card title={plural(warnings.length, "warning")}>
          {warnings.map(([sign, words]) => (
            <p class="desk-warning">
              {sign} {words}
            </p>
          ))}
        </Card>
      ) : null}
      {held.length > 0 ? (
        <Card title="Held, until it is decided what to do">
          <GroupedTubes groups={held} />
        </Card>
      ) : null}
      {retests.length > 0 ? (
        <TableCard
          what="Tubes to be visited again"
          title={`${plural(retests.length, "tube")} to be visited again, the longest waiting first`}
          heads={["tube", "package", "mark", "since", "by", "reason"]}
          rows={retests.map(({tube, package: of, mark, at, who, reason}) =>
            [tube, of, mark, timeWords(at), who, reason].map((value) => textOf(value, "")),
          )}
          text={[0, 1, 2, 3, 4, 5]}
        />
      ) : null}
    </>
  );
}

function WorkSection({report}: OfReport) {
  const people = list(report.people);
  if (people.length === 0) return <p class="note">Nothing was recorded in this shift.</p>;
  const marks = list(report.marks).filter(({name}) => people.some((of) => of.marks?.[name]));
  const rows = people.map((of) => [
    textOf(of.who),
    ...marks.map(({name}) => (of.marks?.[name] ? whole(of.marks[name]) : "")),
    ...["confirmed", "wrong", "undone"].map((key) => (of[key] ? whole(of[key]) : "")),
  ]);
  const wrong = list(report.wrong);
  return (
    <>
      <TableCard
        what="People"
        heads={["who", ...marks.map(({name}) => textOf(name)), "confirmed", "wrong tube", "undid"]}
        rows={rows}
      />
      {wrong.length === 0 ? (
        <p class="note">Every confirmation found the tube that was meant.</p>
      ) : (
        <TableCard
          what="Wrong tubes"
          title={`Another tube than the meant one was found ${plural(wrong.length, "time")}`}
          heads={["at", "meant", "found", "by", "method", "package", "since then"]}
          rows={wrong.map((of) => [
            ...[timeWords(of.at), of.tube, of.found, of.who, of.method, of.package].map((value) => textOf(value, "")),
            of.is_resolved ? "confirmed" : <b class="bad">not confirmed</b>,
          ])}
          text={[0, 1, 2, 3, 4, 5, 6]}
        />
      )}
    </>
  );
}

function TotalsSection({report}: OfReport) {
  const total = object(report.total);
  if (!total) return <Missing what="The totals" />;
  const all = {...total, name: "all"} as NamedCounts;
  const shifts = list(report.shifts) as NamedCounts[];
  return (
    <>
      <p class="note">
        Planned = done + excluded + unresolved, in every row.
        {isNumber(report.later_events) && report.later_events > 0
          ? ` Totals, held and queued tubes are of the end of the shift; warnings and maps are of the present, after ${plural(report.later_events, "later event")}.`
          : ""}
      </p>
      {list(report.totals).map(({by, rows}) => (
        <Card title={`By ${textOf(by)}`}>
          <CountsTable what={textOf(by)} rows={[...(list(rows) as NamedCounts[]), all]} />
        </Card>
      ))}
      {shifts.length > 0 ? (
        <Card title="By shift, at its end">
          <CountsTable
            what="shift"
            rows={shifts}
            more={[
              {head: "marks in it", of: (row) => whole((row as Report).marks)},
              {head: "done in it", of: (row) => whole((row as Report).done_in_shift)},
              {head: "done no longer", of: (row) => whole((row as Report).reopened_in_shift)},
            ]}
          />
        </Card>
      ) : null}
    </>
  );
}
