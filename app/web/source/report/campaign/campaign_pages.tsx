// The pages of campaigns: centring, the rate of correct diagnoses, and outages.
import {MISSING, plural, probability, short, whole} from "../../../../drawing/numbers.js";
import type {PageKind} from "../page";
import {Card, Lead, Named, type OfReport, Table} from "../parts";
import {list, object, type Report, textOf} from "../values";
import {ChanceMapSection, CurvesSection, settingName, SettingsSection, WorstHolesSection} from "./centring_runs";
import {type Estimate, Estimates, lookOf} from "./estimates";
import {ChangesSection, FoundSection, outageSentence} from "./outage_pages";

const FACTS: PageKind["facts"] = ({cell, seed, version}) => [
  ["cell", cell],
  ["seed", seed],
  ["tubeplan", version],
];

/** Returns the page of a kind of campaign; `sentence` states its result. */
function pageOf(sentence: (report: Report) => string, sections: PageKind["sections"]): PageKind {
  return {
    title: "Campaign",
    Head: ({report}) => <Runs report={report}>{sentence(report)}</Runs>,
    sections,
    facts: FACTS,
  };
}

const CENTRING = pageOf(centringSentence, [
  {id: "curves", title: "Centring error", Content: CurvesSection},
  {id: "settings", title: "Settings side by side", Content: SettingsSection},
  {id: "sheet", title: "Probabilities over the sheet", Content: ChanceMapSection},
  {id: "worst", title: "The worst holes", Content: WorstHolesSection},
]);

/** Pages of the kinds of campaigns other than centring. */
const OTHERS: Record<string, PageKind> = {
  diagnose: pageOf(diagnosisSentence, [
    {id: "rates", title: "Fraction of correct answers", Content: RatesSection},
    {id: "sizes", title: "By size", Content: SizesSection},
    {id: "effects", title: "By effect", Content: EffectsSection},
  ]),
  outage: pageOf(outageSentence, [
    {id: "found", title: "Changes found", Content: FoundSection},
    {id: "changes", title: "By change", Content: ChangesSection},
  ]),
};

/** Returns the page for the kind of a campaign. */
export function campaignPage({kind}: Report): PageKind {
  return OTHERS[textOf(kind, "")] ?? CENTRING;
}

function Runs({report, children}: {children: string} & OfReport) {
  return (
    <p class="sentence">
      {whole(report.runs_done)} of {plural(report.runs, "run")}. {children}
    </p>
  );
}

function centringSentence(report: Report): string {
  const setting = list(report.settings)[0],
    steps = list(object(setting?.compensated)?.steps),
    last = steps.at(-1),
    chance = object(last?.probability);
  if (!last || !chance) return "No run was scored.";
  return (
    `With ${settingName(report, setting)}, ${last.at_least} of ${plural(steps.length, "step")} of the tool enter a hole ` +
    `with a probability of ${probability(chance.value)} (${probability(chance.low)} to ${probability(chance.high)}) ` +
    `after compensation, ${textOf(object(setting?.base)?.words)}.`
  );
}

function diagnosisSentence(report: Report): string {
  const found = object(object(report.hidden)?.truth_among_answers),
    alarms = object(object(report.nothing_hidden)?.false_alarms);
  return (
    `The truth is among the answers in ${probability(found?.value)} of the runs with a hidden effect; ` +
    `${probability(alarms?.value)} of those without one are false alarms.`
  );
}

// ---- rates of correct diagnoses

function Rates({label, rows}: {label: string; rows: readonly Estimate[]}) {
  return <Estimates label={label} rows={rows} to={1} title="fraction of the runs" write={probability} />;
}

function RatesSection({report}: OfReport) {
  const nothing = object(report.nothing_hidden) ?? {},
    hidden = object(report.hidden) ?? {};
  const alarms = {name: "false alarms", ...(object(nothing.false_alarms) ?? {}), look: lookOf(1)},
    open = {name: "inconclusive", ...(object(nothing.inconclusive) ?? {}), look: lookOf(4)};
  const rates = list(report.rates).map(({name, words}, i) => ({
    ...(object(hidden[name]) ?? {}),
    name: textOf(words, name),
    look: lookOf(i),
  }));
  return (
    <>
      <Lead>Verdicts by the true cause. Bars are 95 % bands.</Lead>
      <div class="pair">
        <Card title="No hidden effect">
          <Rates label="Nothing hidden" rows={[alarms, open]} />
        </Card>
        <Card title="Hidden effect">
          <Rates label="An effect hidden" rows={rates} />
        </Card>
      </div>
    </>
  );
}

function SizesSection({report}: OfReport) {
  const rows = list(report.by_size).map(({size, truth_among_answers: found}, i) => ({
    name: `${short(size?.[0])} to ${short(size?.[1])} of the largest`,
    ...(object(found) ?? {}),
    look: lookOf(i),
  }));
  return (
    <>
      <Lead>The larger an effect, the more reliably it is found. Sizes are relative to the largest plausible one.</Lead>
      <Card>
        <Rates label="Truth among the answers by size" rows={rows} />
      </Card>
    </>
  );
}

function EffectsSection({report}: OfReport) {
  const outcomes = list(report.outcomes),
    all = list(report.by_effect);
  const countsOf = (counts: unknown) => outcomes.map(({name}) => object(counts)?.[name]);
  const isDrawn = (entry: Report) => countsOf(entry.outcomes).some((count) => count > 0);
  const nothing = object(report.nothing_hidden) ?? {};
  const rows = all
    .filter(isDrawn)
    .map((entry) => [
      <Named name={textOf(entry.effect)} words={textOf(entry.words, "")} />,
      ...countsOf(entry.outcomes).map(whole),
      probability(object(entry.truth_among_answers)?.value),
    ]);
  const absent = all.filter((entry) => !isDrawn(entry)).map(({effect}) => textOf(effect));
  return (
    <Card>
      <Table
        heads={["hidden", ...outcomes.map(({words}) => textOf(words)), "truth among the answers"]}
        rows={[["(nothing)", ...countsOf(nothing.outcomes).map((count) => whole(count ?? 0)), MISSING], ...rows]}
      />
      {absent.length > 0 ? <p class="note">Hidden in none of these runs: {absent.join(", ")}.</p> : null}
    </Card>
  );
}
