// Maps of the legs: the standing of each hole's items, with the remaining work on each leg.
import {useSignal} from "@preact/signals";
import {useCallback, useMemo} from "preact/hooks";
import {NOT_PLANNED, standingMark} from "../../../../drawing/kinds.js";
import {duration, fixed, isNumber, whole} from "../../../../drawing/numbers.js";
import {sheetWords, type SheetModel} from "../../../../drawing/sheet_model.js";
import {MarkIcon} from "../../drawing/marks";
import {choicesOf, Segments} from "../../drawing/segments";
import {type MarkGroup, type Painter, paintGroups, type Place, readSheet, SheetBox} from "../plan/sheet_box";
import {Card, Lead, Missing, type OfReport} from "../parts";
import {list, type Report, textOf} from "../values";

export function MapsSection({report}: OfReport) {
  const legs = list(report.legs);
  if (legs.length === 0) return <Missing what="The legs" />;
  return (
    <>
      <Lead>
        Where a tube is in several packages, its mark is that of the most urgent: held, then queued, open, done and
        excluded. The time left is that of the planned visits, without mounting and tool changes.
      </Lead>
      {legs.map((leg) => (
        <LegCard report={report} leg={leg} />
      ))}
    </>
  );
}

/** Returns the marks of a leg's holes by their standing, and the holes that are in no package. */
function groupsOf(report: Report, sheet: SheetModel, holes: string): MarkGroup[] {
  const places = (letter: string): Place[] => {
    const found: Place[] = [];
    for (let i = 0; i < sheet.count; ++i)
      if (holes[i] === letter) found.push([sheet.world[3 * i], sheet.world[3 * i + 1]]);
    return found;
  };
  return list(report.letters).map(({letter, name}) => ({
    mark: standingMark(textOf(name)),
    name: textOf(name),
    places: places(textOf(letter)),
  }));
}

function LegCard({report, leg}: {leg: Report} & OfReport) {
  const ofSheet = useMemo(() => ({sheet: leg.sheet, units: report.units}), [leg, report]);
  const sheet = readSheet(ofSheet);
  const standings = list(leg.standings),
    name = textOf(leg.leg);
  const chosen = useSignal("");
  const holes = textOf(standings.find((of) => of.package === chosen.value)?.of, "");
  const groups = useMemo(() => (sheet ? groupsOf(report, sheet, holes) : []), [report, sheet, holes]);
  const paint = useCallback((painter: Painter) => paintGroups(painter, groups), [groups]);
  const describe = useCallback(
    (row: number, column: number) => {
      const at = sheet?.find(row, column) ?? -1;
      return standings
        .filter((of) => of.package !== "" && textOf(of.of, "")[at] !== ".")
        .map((of) => `${of.package}: ${nameOf(report, textOf(of.of, "")[at])}`);
    },
    [report, sheet, leg],
  );
  return (
    <Card class="leg-map">
      <div class="card-head">
        <h3>
          {name} <small>{sheet ? sheetWords(sheet) : ""}</small>
        </h3>
        {standings.length > 2 ? (
          <Segments
            label="Package shown"
            choices={choicesOf(
              standings.map((of) => [textOf(of.package, ""), textOf(of.package, "all packages")] as const),
            )}
            value={chosen.value}
            onChoose={(next) => (chosen.value = next)}
          />
        ) : null}
      </div>
      <p>
        <b>{fixed(percentLeft(leg), 1)} % left</b>: {whole(leg.to_visit)} to visit
        {isNumber(leg.time_left_s) ? `, about ${duration(leg.time_left_s)}` : ", time not planned"}.{" "}
        {whole(leg.planned)} planned = {whole(leg.done)} done + {whole(leg.excluded)} excluded + {whole(leg.unresolved)}{" "}
        unresolved.
      </p>
      {sheet ? (
        <div class="map-frame">
          <SheetBox
            report={ofSheet}
            sheet={sheet}
            describe={describe}
            paint={paint}
            label={`${name}, ${sheetWords(sheet)}`}
            isFaint
          />
        </div>
      ) : (
        <Missing what="The sheet" />
      )}
      <ul class="legend">
        {groups.map(({mark, name, places}) => (
          <li>
            <MarkIcon mark={mark} /> {name} <b>{whole(places.length)}</b>
          </li>
        ))}
        <li>
          <MarkIcon mark={NOT_PLANNED} /> in no package{" "}
          <b>{whole([...holes].filter((letter) => letter === ".").length)}</b>
        </li>
      </ul>
    </Card>
  );
}

function nameOf(report: Report, letter: string): string {
  return textOf(list(report.letters).find((row) => row.letter === letter)?.name);
}

/** Returns the items of a leg that are not finished, in percent of those that are not excluded. */
function percentLeft(leg: Report): number | null {
  const toDo = leg.planned - leg.excluded;
  return isNumber(toDo) ? (toDo > 0 ? (100 * leg.unresolved) / toDo : 0) : null;
}

/** Returns the sum of the legs' times [s]; null if one of them is not planned. */
export function timeLeft(report: Report): number | null {
  const times = list(report.legs).map(({time_left_s}) => time_left_s);
  return times.length > 0 && times.every(isNumber) ? times.reduce((sum, time) => sum + time, 0) : null;
}
