// The proposed next readings, which would distinguish open explanations, and warnings about effects.
import {PAIR_HEADS, pairCells, senseArrow, separations} from "../../../../drawing/conditions.js";
import {short} from "../../../../drawing/numbers.js";
import {Chance} from "../../error/ranking_table";
import {Card, Lead, type OfReport, PrintButton, Reasons, Table} from "../parts";
import {list, object, type Report, textList, textOf} from "../values";

export function isSplit(report: Report): boolean {
  return object(report.splitting) !== null || list(report.next_readings).length > 0;
}

export function NextReadingsSection({report}: OfReport) {
  const splitting = object(report.splitting) ?? {},
    next = list(report.next_readings),
    pairs = list(splitting.pairs);
  const means = list(splitting.other_means).map(({what}) => textOf(what)),
    columns = textList(splitting.columns_to_add);
  return (
    <>
      <Lead>{textOf(splitting.advice, "These readings would discriminate between the explanations.")}</Lead>
      {next.length === 0 ? null : (
        <>
          <PrintButton>Print these readings alone, to fill in</PrintButton>
          <Card>
            <NextReadings next={next} />
          </Card>
        </>
      )}
      {pairs.length === 0 ? null : (
        <Card title="Effect of these readings">
          <Table heads={PAIR_HEADS} rows={pairs.map(pairCells)} text={[0, 1]} />
        </Card>
      )}
      {means.length + columns.length === 0 ? null : (
        <Card title={means.length > 0 ? "Alternative measurements" : "What else to record"}>
          <Reasons>{[...means, ...columns]}</Reasons>
        </Card>
      )}
    </>
  );
}

/** Returns the quantities to be measured and written down for a reading. */
function toFill(reading: Report): string[] {
  const fill = object(reading.fill_in) ?? {};
  return [...textList(fill.columns), ...textList(fill.optional)];
}

/**
 * Shows the proposed readings: joint values with an arrow for the required sense of arrival, and the separation as a
 * bar relative to the largest separation.
 */
function NextReadings({next}: {next: Report[]}) {
  const joints = Object.keys(object(next[0].posture) ?? {}),
    blank = [...new Set(next.flatMap(toFill))];
  const rows = separations(next).map(({reading: entry, ...separation}, i) => [
    `${i + 1}. ${textOf(entry.point, textOf(entry.kind))}`,
    short(entry.load),
    ...joints.map((joint) => `${short(entry.posture?.[joint])}${senseArrow(object(entry.senses)?.[joint])}`),
    textList(entry.splits).join(" from "),
    <Chance {...separation} />,
    ...blank.map((column) => (toFill(entry).includes(column) ? <span class="to-fill" /> : null)),
  ]);
  const heads = ["reading", "load", ...joints, "splits", "by, in standard deviations", ...blank];
  return <Table heads={heads} rows={rows} text={[0, 2 + joints.length]} />;
}

export function WarningsSection({report}: OfReport) {
  const warnings: unknown[] = report.warnings;
  return (
    <>
      {warnings.map((entry) => (
        <p class="warning">{textOf(object(entry)?.sentence, textOf(entry))}</p>
      ))}
    </>
  );
}
