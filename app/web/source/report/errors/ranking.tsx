// Every tried effect, most probable first; explanations side by side; and effects that could go undetected.
import {errorUnit} from "../../../../drawing/error_budget.js";
import {explanationTitle, isEnough, plainName, sizeText} from "../../../../drawing/explanations.js";
import {plural, pValue, short, whole} from "../../../../drawing/numbers.js";
import {foldedRows, rankingRows, triedText} from "../../../../drawing/ranking.js";
import {letterOf} from "../../../../drawing/reading_errors.js";
import {RankingTable} from "../../error/ranking_table";
import type {RankedEffect} from "../../server/documents";
import {Card, Lead, Missing, Named, type OfReport, Reasons, Table, TableCard} from "../parts";
import {lengthUnit, list, object, type Report, textList, textOf, vector} from "../values";
import {noiseFloorOf} from "./ladder";
import {conditionsText, reportExplanations, rootMeanSquare} from "./pairs";

export function RankingSection({report}: OfReport) {
  const ranking = list(report.ranking).map((entry) => ({
    ...entry,
    size: object(entry.size),
  })) as unknown as RankedEffect[];
  const {shown, folded} = foldedRows(rankingRows(ranking));
  if (ranking.length === 0) return <Missing what="The ranking of effects" />;
  return (
    <>
      <Lead>{rankingLead(report)}</Lead>
      <Card class="ranking">
        <RankingTable rows={shown} />
      </Card>
      {folded.length > 0 ? (
        <details>
          <summary>The other {whole(folded.length)}</summary>
          <Card class="ranking">
            <RankingTable rows={folded} />
          </Card>
        </details>
      ) : null}
    </>
  );
}

function rankingLead(report: Report): string {
  const {probability_words} = report,
    lacks = textList(report.not_tried);
  const isJoined = reportExplanations(report).some((entry) => entry.effects.length > 1);
  return [
    triedText({ranking: list(report.ranking), probability: object(report.probability), probability_words}),
    isJoined ? "The explanation above combines several; here the reduction of chi-square is that of each alone." : "",
    lacks.length === 0 ? "" : `Not tried: ${lacks.join("; ")}.`,
  ]
    .filter((text) => text !== "")
    .join(" ");
}

// ---- explanations side by side

const MOST_DIFFERING = 6;
/** Fraction of the noise below which the predictions of two explanations are treated as equal. */
const SAME_SHARE = 0.01;

export function AlternativesSection({report}: OfReport) {
  const explanations = reportExplanations(report),
    unit = errorUnit(report);
  const rows = explanations.map((entry, i) => [
    `${letterOf(i)}: ${explanationTitle(entry)}`,
    entry.effects.map((effect) => <div>{sizeText(effect)}</div>),
    short(entry.rms),
    short(entry.heldout_rms),
    short(entry.chi2),
    pValue(entry.p_value),
  ]);
  const heads = ["explanation", "sizes", `error, ${unit}`, `held-out, ${unit}`, "chi-square", "p of what is left"];
  return (
    <>
      <Lead>
        {isEnough(explanations[0])
          ? "Each of these suffices alone; these readings cannot distinguish between them."
          : "The best of the known effects. None of them reduces the error to the noise floor."}
      </Lead>
      <TableCard what="The explanations" heads={heads} rows={rows} text={[0, 1]} />
      <div class="pair">
        {explanations.slice(1).map((other, i) => (
          <Card title={`${explanationTitle(explanations[0])}, or ${explanationTitle(other)}`}>
            <Differences report={report} index={i + 1} />
          </Card>
        ))}
      </div>
    </>
  );
}

/**
 * Shows the readings at which the predictions of an explanation and of the first explanation differ most, each fitted
 * with all free parameters.
 */
function Differences({report, index}: {index: number} & OfReport) {
  const differences = list(report.readings)
    .flatMap((reading) => {
      const [a, b] = [vector(reading.explained?.[0]), vector(reading.explained?.[index])];
      return a && b ? [{reading, distance: Math.hypot(...a.map((value, k) => value - b[k]))}] : [];
    })
    .sort((one, other) => other.distance - one.distance);
  if (differences.length === 0) return <Missing what="Where they differ" />;
  const unit = lengthUnit(report),
    floor = errorUnit(report) === unit ? noiseFloorOf(report) : null;
  const rms = rootMeanSquare(differences.map(({distance}) => distance))!;
  if (floor !== null && rms < SAME_SHARE * floor)
    return (
      <p class="note">
        At these readings both predict the same to within a hundredth of the noise: no fit to them can distinguish them.
      </p>
    );
  const rows = differences
    .slice(0, MOST_DIFFERING)
    .map(({reading, distance}) => [textOf(reading.id), conditionsText(report, reading), short(distance)]);
  return (
    <>
      <p class="note">
        They put the tip {short(rms)} {unit} apart (root mean square over the readings)
        {floor === null ? "" : `, where noise is ${short(floor)} ${unit}`}. They differ most at:
      </p>
      <Table heads={["reading", "at", `apart, ${unit}`]} rows={rows} text={[0, 1]} />
    </>
  );
}

// ---- undetected effects, effects not tried, and excluded readings

export function HiddenSection({report}: OfReport) {
  const detectable = list(report.detectable),
    aside = textList(report.set_aside);
  return (
    <>
      <Lead>
        Smallest size that these readings would detect with a power of 80 %. Smaller effects may be present. Marked ▲:
        only a size that no machine has would show, so these readings say nothing about it.
      </Lead>
      <DetectableTable detectable={detectable} />
      <div class="pair">
        <Card title="Not tried">
          {textList(report.not_tried).length > 0 ? (
            <Reasons>{textList(report.not_tried)}</Reasons>
          ) : (
            <NoneOf
              given={report.not_tried}
              what="Effects that were not tried"
              none="Every effect of the catalogue was tried."
            />
          )}
        </Card>
        <Card title="Readings set aside">
          {aside.length > 0 ? (
            <p>
              {plural(aside.length, "reading")} stood out as no effect would move them and{" "}
              {aside.length === 1 ? "was" : "were"} left out: {aside.join(", ")}.
            </p>
          ) : (
            <NoneOf
              given={report.set_aside}
              what="Readings set aside"
              none="None: no reading stands out from the others."
            />
          )}
        </Card>
      </div>
    </>
  );
}

function NoneOf({given, what, none}: {given: unknown; what: string; none: string}) {
  return Array.isArray(given) ? <p class="note">{none}</p> : <Missing what={what} />;
}

/** Shows a row for each parameter of an effect, with all places of the effect. */
function DetectableTable({detectable}: {detectable: Report[]}) {
  const groups = new Map<string, Report[]>();
  for (const entry of detectable) {
    const key = `${entry.effect} ${entry.number} ${entry.unit}`;
    groups.set(key, [...(groups.get(key) ?? []), entry]);
  }
  const rows = [...groups.values()].map((entries) => {
    const [{effect, number, unit}] = entries;
    const places = entries.map(({at, size, beyond_plausible: isHidden}) => (
      <span class="places">
        {textOf(at)} <b>{isHidden === true ? "▲" : short(size)}</b>
      </span>
    ));
    return [<Named name={textOf(effect)} />, plainName(number), unit === "1" ? "" : textOf(unit), places];
  });
  const heads = ["effect", "number", "unit", "smallest detectable size, by place"];
  return <TableCard what="Effects that could remain undetected" heads={heads} rows={rows} text={[0, 1, 2, 3]} />;
}
