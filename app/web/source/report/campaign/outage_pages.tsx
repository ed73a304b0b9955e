// Pages of a campaign of outages: how often the watch found a change, how late, and what it named.
import {MISSING, isNumber, probability, short, whole} from "../../../../drawing/numbers.js";
import {Card, Lead, Named, type OfReport, Table} from "../parts";
import {list, object, type Report, textOf} from "../values";
import {Estimates, lookOf} from "./estimates";

/** Returns a figure as text: a count, a share with its interval, or the median and nine tenths of a number of visits. */
function figureText(value: unknown): string {
  if (isNumber(value)) return whole(value);
  const figure = object(value) ?? {};
  if ("50" in figure) return isNumber(figure["50"]) ? `${short(figure["50"])}, ${short(figure["90"])}` : MISSING;
  if (!isNumber(figure.value)) return MISSING;
  return `${probability(figure.value)} (${probability(figure.low)} to ${probability(figure.high)})`;
}

export function outageSentence(report: Report): string {
  const quiet = object(report.unchanged) ?? {},
    changed = object(report.changed) ?? {};
  return (
    `Of ${whole(quiet.runs)} outages without a change, ${probability(object(quiet.false_alarms)?.value)} had a false ` +
    `alarm. Of those with one, the watch found ${probability(object(changed.detected)?.value)}, and named it in ` +
    `${probability(object(changed.named)?.value)} of the alarms.`
  );
}

export function FoundSection({report}: OfReport) {
  const rowsOf = (key: string) =>
    list(report.changes).map((change, i) => ({
      ...(object(change[key]) ?? {}),
      name: textOf(change.words, change.name),
      look: lookOf(i),
    }));
  return (
    <>
      <Lead>By the hidden change. Bars are 95 % bands.</Lead>
      <div class="pair">
        {list(report.meanings)
          .filter(({name}) => ["detected", "named"].includes(name))
          .map(({name, words}) => (
            <Card title={textOf(words)}>
              <Estimates label={textOf(words)} rows={rowsOf(name)} to={1} title="fraction" write={probability} />
            </Card>
          ))}
      </div>
    </>
  );
}

export function ChangesSection({report}: OfReport) {
  const changes = list(report.changes),
    all = object(report.changed) ?? {};
  const rows = list(report.meanings).map(({name, words}) => [
    <Named name={textOf(name)} words={textOf(words)} />,
    ...[...changes, all].map((change) => figureText(change[name])),
  ]);
  return (
    <>
      <Lead>Shares have their 95 % interval in brackets. Numbers of visits are the median and nine tenths.</Lead>
      <Card>
        <Table heads={["", ...changes.map(({name}) => textOf(name)), "all of these"]} rows={rows} />
      </Card>
    </>
  );
}
