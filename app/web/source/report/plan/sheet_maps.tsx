// The sheet before and after compensation: every visited tube with its number of steps that enter, and the tubes that
// cannot be visited.
import {useSignal} from "@preact/signals";
import {useCallback, useMemo} from "preact/hooks";
import {stateMark, UNREACHABLE, UNSCORED} from "../../../../drawing/kinds.js";
import {isNumber, plural, whole} from "../../../../drawing/numbers.js";
import {sheetWords, type SheetModel} from "../../../../drawing/sheet_model.js";
import {stepKinds} from "../../../../drawing/steps.js";
import {toggled} from "../../drawing/fields";
import {MarkIcon, type Mark} from "../../drawing/marks";
import {choicesOf, Segments} from "../../drawing/segments";
import {Card, Lead, Missing, type OfReport, Reasons} from "../parts";
import {list, type Report, textOf, tubeName} from "../values";
import {holeDescriber, type Mode, predictedMode, scoredModes} from "./cases";
import {type MarkGroup, type Painter, paintGroups, readSheet, SheetBox, stateGroups} from "./sheet_box";

export function SheetSection({report}: OfReport) {
  const sheet = readSheet(report);
  const {before, after} = useMemo(() => {
    const scored = scoredModes(report),
      isBefore = ({key}: Mode) => key === "none";
    const after = [...scored.filter((mode) => !isBefore(mode)).reverse(), predictedMode(report)];
    return {before: scored.filter(isBefore), after};
  }, [report]);
  if (!sheet) return <Missing what="The sheet's holes" />;
  return (
    <>
      <Lead>
        {plural(sheet.count, "hole")}, {sheetWords(sheet)}. Every mark is a visited tube: how far the stepped
        calibration tool goes in. Point at a hole for its figures; the boxes below a map hide and show its marks.
        {before.length === 0
          ? " Centring without compensation is not shown: the plan has no true arm to be scored against."
          : ""}
      </Lead>
      <div class="pair">
        {before.length > 0 ? <SheetMap report={report} sheet={sheet} heading="Before" modes={before} /> : null}
        <SheetMap report={report} sheet={sheet} heading={before.length > 0 ? "After" : "The plan"} modes={after} />
      </div>
      <Unreachable report={report} />
    </>
  );
}

/**
 * Returns the groups of marks that a map shows: tubes by the number of steps that enter, unreachable tubes, and tubes
 * that are not scored.
 */
function groupsOf(report: Report, mode: Mode): MarkGroup[] {
  const placed = (tubes: unknown) => list(tubes).filter(({x, y}) => isNumber(x) && isNumber(y));
  const group = ({mark, name}: {mark: Mark; name: string}, tubes: Report[]): MarkGroup => ({
    mark,
    name,
    places: tubes.map(({x, y}) => [x, y]),
  });
  const tubes = placed(report.tubes),
    of = (steps: number | null) => tubes.filter((tube) => mode.caseOf(tube) === steps);
  return [
    ...stepKinds(report).map((kind, k) => group(kind, of(k))),
    group({mark: UNREACHABLE, name: "cannot be visited"}, placed(report.unreachable)),
    ...(of(null).length > 0 ? [group({mark: UNSCORED, name: "not scored"}, of(null))] : []),
  ];
}

interface SheetMapProps {
  report: Report;
  sheet: SheetModel;
  heading: string;
  modes: readonly Mode[];
}

/** Map with a heading, a choice of mode if there are several, and a legend with the counts of the chosen mode. */
function SheetMap({report, sheet, heading, modes}: SheetMapProps) {
  const chosen = useSignal(modes[0].key),
    hidden = useSignal<ReadonlySet<string>>(new Set());
  const mode = modes.find(({key}) => key === chosen.value)!;
  const groups = useMemo(() => groupsOf(report, mode), [report, mode]);
  const describe = useMemo(() => holeDescriber(report, mode), [report, mode]);
  const paint = useCallback((painter: Painter) => paintGroups(painter, groups, hidden.value), [groups, hidden.value]);
  return (
    <Card>
      <div class="card-head">
        <h3>
          {heading}: {mode.name}
        </h3>
        {modes.length > 1 ? (
          <Segments
            label="Compensation shown"
            choices={choicesOf(modes.map(({key, brief}) => [key, brief] as const))}
            value={mode.key}
            onChoose={(next) => (chosen.value = next)}
          />
        ) : null}
      </div>
      <SheetBox
        {...{report, sheet, describe, paint}}
        label={`Tube sheet, ${sheetWords(sheet)}: ${heading.toLowerCase()}, ${mode.name}`}
      />
      <ul class="legend">
        {groups.map(({mark, name, places}) => (
          <li>
            <label>
              <input
                type="checkbox"
                checked={!hidden.value.has(name)}
                onChange={() => (hidden.value = toggled(hidden.value, name))}
              />
              <MarkIcon mark={mark} /> {name} <b>{whole(places.length)}</b>
            </label>
          </li>
        ))}
        <OtherHoles report={report} sheet={sheet} />
      </ul>
    </Card>
  );
}

/** Legend of the holes that are not on the list, and of the holes in each state. */
function OtherHoles({report, sheet}: {sheet: SheetModel} & OfReport) {
  const listed = list(report.tubes).length + list(report.unreachable).length;
  const open = {mark: stateMark("open") as Mark, name: "not on the list", count: Math.max(0, sheet.count - listed)};
  return (
    <>
      {[open, ...stateGroups(sheet)].map(({mark, name, count}) => (
        <li>
          <MarkIcon mark={mark} /> {name} <b>{whole(count)}</b>
        </li>
      ))}
    </>
  );
}

/** Tubes that cannot be visited, grouped by reason; long lists are folded. */
function Unreachable({report}: OfReport) {
  const tubes = list(report.unreachable);
  if (!Array.isArray(report.unreachable)) return <Missing what="Tubes that cannot be visited" />;
  if (tubes.length === 0) return <p class="good">Every tube on the list is visited.</p>;
  const reasons = new Map<string, string[]>();
  for (const tube of tubes) {
    const reason = textOf(tube.reason, "no reason recorded");
    reasons.set(reason, [...(reasons.get(reason) ?? []), tubeName(tube)]);
  }
  const title = (
    <>
      <MarkIcon mark={UNREACHABLE} /> {plural(tubes.length, "tube")} cannot be visited
    </>
  );
  return (
    <Card title={title}>
      <Reasons>
        {[...reasons]
          .sort(([, a], [, b]) => b.length - a.length)
          .map(([reason, names]) => (
            <>
              <b>{reason}: </b>
              {names.length <= 12 ? (
                names.join(", ")
              ) : (
                <details>
                  <summary>{plural(names.length, "tube")}</summary>
                  {names.join(", ")}
                </details>
              )}
            </>
          ))}
      </Reasons>
    </Card>
  );
}
