// The report pages about a model's errors: diagnosis, comparison, ladder, improvement, project.
import {budgetText, errorUnit, idsSetAside} from "../../../../drawing/error_budget.js";
import {isEnough} from "../../../../drawing/explanations.js";
import {verdictMark} from "../../../../drawing/kinds.js";
import {errorOf} from "../../../../drawing/ladder.js";
import {isNumber, pValue, short, whole} from "../../../../drawing/numbers.js";
import {verdictItems} from "../../../../drawing/verdict_items.js";
import {MarkIcon} from "../../drawing/marks";
import {type PageKind, type SectionKind, Summary} from "../page";
import type {OfReport} from "../parts";
import {list, object, type Report, textList, textOf} from "../values";
import {AddedVariableSection} from "./added_variable";
import * as history from "./history";
import {hasStepCounts, LadderSection, LadderStepsSection, ModelsSection, noiseFloorOf} from "./ladder";
import {JointsSection, LawSection} from "./law";
import {ChartsSection, MapsSection} from "./maps";
import {isSplit, NextReadingsSection, WarningsSection} from "./next_readings";
import {reportExplanations} from "./pairs";
import {AlternativesSection, HiddenSection, RankingSection} from "./ranking";

/** Returns true if the report has leverages, which convert an error at the tip to an error of a joint. */
const hasLevers = (report: Report) => object(report.leverage) !== null;
const hasAny = (name: string) => (report: Report) => Array.isArray(report[name]) && report[name].length > 0;

const LADDER: SectionKind = {id: "ladder", title: "The error of each model", Content: LadderSection};
const MODELS: SectionKind = {id: "models", title: "The same as a table", Content: ModelsSection};
const LAW: SectionKind = {id: "why", title: "Why: the errors and the law", Content: LawSection, of: hasLevers};
const JOINTS: SectionKind = {
  id: "joints",
  title: "Where: the errors joint by joint",
  Content: JointsSection,
  of: hasLevers,
};
const MAPS: SectionKind = {id: "maps", title: "Errors at the readings' places", Content: MapsSection};
const CHARTS: SectionKind = {id: "charts", title: "What the errors depend on", Content: ChartsSection};

const FACTS: PageKind["facts"] = ({cell, measurements, seed, version, commit}) => [
  ["cell", cell],
  ["readings", measurements],
  ["seed", seed],
  ["tubeplan", version],
  ["commit", commit],
];

const pageOf = (title: string, sections: SectionKind[]): PageKind => ({title, Head, sections, facts: FACTS});

export const ERROR_PAGES: Record<string, PageKind> = {
  diagnosis: pageOf("Diagnosis", [
    {id: "warnings", title: "Effects that the model has", Content: WarningsSection, of: hasAny("warnings")},
    LADDER,
    LAW,
    JOINTS,
    {id: "next", title: "What to measure next", Content: NextReadingsSection, of: isSplit},
    {id: "ranking", title: "Effects, most probable first", Content: RankingSection},
    {id: "added", title: "Unexplained error against the change by the effect", Content: AddedVariableSection},
    MAPS,
    CHARTS,
    {id: "hidden", title: "Effects that could remain undetected", Content: HiddenSection},
    {
      id: "alternatives",
      title: "Explanations side by side",
      Content: AlternativesSection,
      of: (report) => reportExplanations(report).length > 1,
    },
  ]),
  comparison: pageOf("Model and readings", [
    LADDER,
    {id: "patterns", title: "Patterns in the errors", Content: history.PatternsSection},
    LAW,
    JOINTS,
    MAPS,
    CHARTS,
    {id: "worst", title: "The worst readings", Content: history.WorstSection},
  ]),
  ladder: pageOf("Comparison of models", [
    LADDER,
    {id: "steps", title: "Insertion of the tool", Content: LadderStepsSection, of: hasStepCounts},
    MODELS,
    {...MAPS, of: hasAny("readings")},
  ]),
  improvement: pageOf("Improvement", [
    LADDER,
    {id: "steps", title: "Step by step", Content: history.ImprovementSection},
    MODELS,
  ]),
  project: pageOf("Project", [
    {...LADDER, of: hasAny("models")},
    {id: "history", title: "History of the models", Content: history.HistorySection},
    {
      id: "numbers",
      title: "Numbers of the current model",
      Content: history.ParametersSection,
      of: hasAny("parameters"),
    },
    {id: "inputs", title: "Contents", Content: history.InputsSection},
    {id: "commands", title: "Reproducing the figures", Content: history.CommandsSection},
  ]),
};

/** Conclusion of the report, sentence by sentence, with its key values. */
function Head({report}: OfReport) {
  const {verdict} = report,
    answer = answerOf(report);
  return (
    <>
      {textOf(verdict, "") ? (
        <p class="report-verdict">
          <MarkIcon mark={verdictMark(verdict)} size={34} /> <b>{textOf(report.verdict_words, verdict)}</b>
        </p>
      ) : null}
      {answer.length > 0 ? (
        <div class="answer">
          {answer.map((item) => (
            <p>{item}</p>
          ))}
        </div>
      ) : null}
      {budgetText(report) ? <p>{budgetText(report)}</p> : null}
      <Summary facts={factsOf(report)} />
    </>
  );
}

function answerOf(report: Report): string[] {
  const sentences = Array.isArray(report.sentences) ? textList(report.sentences) : undefined;
  const advice = textOf(object(report.splitting)?.advice, "");
  const explanations = list(report.explanations).map(({effects}) => ({effects: list(effects)}));
  return verdictItems({
    ...{sentence: textOf(report.sentence, ""), sentences, splitting: {advice}, explanations},
    ...{ranking: list(report.ranking), joints: list(report.joints)},
  });
}

function factsOf(report: Report): [string, string][] {
  const rms = object(report.rms) ?? {},
    aside = idsSetAside(report).length,
    readings = list(report.readings).length;
  const isBetter = reportExplanations(report).some(isEnough) || report.page !== "diagnosis";
  const error = (value: unknown) => {
    const known = errorOf(value);
    return known === null ? "" : `${short(known)}\u00a0${errorUnit(report)}`;
  };
  const chance = isNumber(report.p_value) ? ` (p\u00a0${pValue(report.p_value)})` : "";
  const own = (Array.isArray(report.facts) ? report.facts : []).filter(
    (fact) => Array.isArray(fact) && fact.length === 2,
  );
  const facts: [string, string][] = [
    ...own,
    ["Readings", readings > 0 ? whole(readings) : ""],
    ["Held-out error before", error(rms.heldout_before)],
    ["Held-out error after", isBetter ? error(rms.heldout_after) : ""],
    ["Noise floor", error(noiseFloorOf(report))],
    ["Chi-square per degree of freedom", isNumber(report.chi2_per_dof) ? `${short(report.chi2_per_dof)}${chance}` : ""],
    ["Readings set aside", aside > 0 ? whole(aside) : ""],
  ];
  return facts.filter(([, value]) => textOf(value, "") !== "");
}
