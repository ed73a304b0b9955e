// The pages about a model's errors: a diagnosis, a comparison, a ladder.
import {budgetText, idsSetAside} from "../drawing/error_budget.js";
import {isEnough} from "../drawing/explanations.js";
import {verdictMark} from "../drawing/kinds.js";
import {errorOf} from "../drawing/ladder.js";
import {isNumber, pValue, short, whole} from "../drawing/numbers.js";
import {verdictItems} from "../drawing/verdict_items.js";
import {addedVariableSection} from "./added_variable.js";
import {alternativesSection} from "./alternatives_view.js";
import {modelsSection, patternsSection, worstSection} from "./comparison_view.js";
import {rankingSection} from "./effect_ranking.js";
import {append, el, followColourScheme} from "./elements.js";
import {errorText, ladderSection, noiseFloorOf} from "./error_ladder.js";
import {errorLawSection} from "./error_law.js";
import {reportExplanations} from "./error_series.js";
import {hiddenEffectsSection} from "./hidden_effects.js";
import {jointPanelsSection} from "./joint_panels.js";
import {hasStepCounts, ladderStepsSection} from "./ladder_steps.js";
import {improvementStepsSection} from "./improvement_steps.js";
import {markIcon} from "./mark_drawing.js";
import {isSplit, nextReadingsSection, warningsSection} from "./next_readings.js";
import {commandsSection, historySection, inputsSection, parametersSection} from "./project_view.js";
import {residualMapsSection} from "./residual_arrows.js";
import {residualChartsSection} from "./residual_charts.js";
import {readReport, showSections} from "./sections.js";
import {list, object, textList, textOf} from "./values.js";

const LADDER = {
  id: "ladder",
  title: "The error of each model",
  make: ladderSection
};
const MAPS = {
  id: "maps",
  title: "Errors at the readings' places",
  make: residualMapsSection
};
/// Only where the page has what makes an error at the tip that of a joint.
const hasLevers = (report) => object(report.leverage) !== null;
const LAW = {
  id: "why",
  title: "Why: the errors and the law",
  make: errorLawSection,
  of: hasLevers
};
const JOINTS = {
  id: "joints",
  title: "Where: the errors joint by joint",
  make: jointPanelsSection,
  of: hasLevers
};
const CHARTS = {
  id: "charts",
  title: "What the errors depend on",
  make: residualChartsSection
};

/// The sections of each kind of page; those whose `of` says no are left out.
const PAGES = {
  diagnosis: {
    title: "Diagnosis",
    sections: [
      {
        id: "warnings",
        title: "Effects that the model has",
        make: warningsSection,
        of: (report) => list(report.warnings).length > 0
      },
      LADDER,
      LAW,
      JOINTS,
      {id: "next", title: "What to measure next", make: nextReadingsSection, of: isSplit},
      {id: "ranking", title: "Effects, most probable first", make: rankingSection},
      {id: "added", title: "What is left beside what the effect would do", make: addedVariableSection},
      MAPS,
      CHARTS,
      {id: "hidden", title: "What could still hide", make: hiddenEffectsSection},
      {
        id: "alternatives",
        title: "Explanations side by side",
        make: alternativesSection,
        of: (report) => reportExplanations(report).length > 1
      },
    ]
  },
  comparison: {
    title: "Model and readings",
    sections: [
      LADDER, {id: "patterns", title: "Patterns in the errors", make: patternsSection}, LAW, JOINTS, MAPS, CHARTS,
      {id: "worst", title: "The worst readings", make: worstSection}
    ]
  },
  ladder: {
    title: "Comparison of models",
    sections: [
      LADDER, {id: "steps", title: "Insertion of the tool", make: ladderStepsSection, of: hasStepCounts},
      {id: "models", title: "The same as a table", make: modelsSection},
      {...MAPS, of: (report) => list(report.readings).length > 0}
    ]
  },
  improvement: {
    title: "Improvement",
    sections: [
      LADDER, {id: "steps", title: "Step by step", make: improvementStepsSection},
      {id: "models", title: "The same as a table", make: modelsSection}
    ]
  },
  project: {
    title: "Project",
    sections: [
      {...LADDER, of: (report) => list(report.models).length > 0},
      {id: "history", title: "How the models came about", make: historySection},
      {
        id: "numbers",
        title: "Numbers of the current model",
        make: parametersSection,
        of: (report) => list(report.parameters).length > 0
      },
      {id: "inputs", title: "Contents", make: inputsSection},
      {id: "commands", title: "Reproducing the figures", make: commandsSection},
    ]
  },
};

function factsOf(report) {
  const rms = object(report.rms) ?? {};
  const chi2 = isNumber(report.chi2_per_dof) ?
      `${short(report.chi2_per_dof)}${isNumber(report.p_value) ? ` (p\u00a0${pValue(report.p_value)})` : ""}` :
                                                                 null;
  const isBetter = reportExplanations(report).some(isEnough) || report.page !== "diagnosis";
  const error = (value) => (errorOf(value) === null ? null : errorText(errorOf(value), report));
  const facts = Array.isArray(report.facts) ? report.facts : [];
  const own = facts.filter((fact) => Array.isArray(fact) && fact.length === 2);
  return [
    ...own, ["Readings", list(report.readings).length > 0 ? whole(list(report.readings).length) : null],
    ["Held-out error before", error(rms.heldout_before)],
    ["Held-out error after", isBetter ? error(rms.heldout_after) : null], ["Noise floor", error(noiseFloorOf(report))],
    ["Chi-square per degree of freedom", chi2],
    ["Readings set aside", idsSetAside(report).length > 0 ? whole(idsSetAside(report).length) : null]
  ].filter(([, value]) => value !== null && value !== "");
}

/// What the report comes to, sentence by sentence.
function answerOf(report) {
  const sentences = Array.isArray(report.sentences) ? textList(report.sentences) : undefined;
  const advice = textOf(object(report.splitting)?.advice, "");
  return verdictItems({sentence: textOf(report.sentence, ""), sentences, splitting: {advice}});
}

function verdictLine(report, verdict) {
  const words = textOf(report.verdict_words, verdict);
  return el("p", {class: "verdict"}, markIcon(verdictMark(verdict), 34), el("b", {}, words));
}

function showHead(report, page) {
  const answer = answerOf(report);
  const title = textOf(report.title, page.title), verdict = textOf(report.verdict, ""), facts = factsOf(report);
  document.title = title;
  append(document.getElementById("head"), [
    el("h1", {}, title), verdict ? verdictLine(report, verdict) : null,
    answer.length === 0 ? null : el("div", {class: "answer"}, answer.map((item) => el("p", {}, item))),
    budgetText(report) === "" ? null : el("p", {class: "budget"}, budgetText(report)),
    facts.length === 0 ? null :
                         el("dl", {class: "summary"},
                            facts.map(([name, value]) => el("div", {}, el("dt", {}, name), el("dd", {}, value))))
  ]);
}

function showFoot(report) {
  const facts = [
    ["cell", report.cell], ["readings", report.measurements], ["seed", report.seed], ["tubeplan", report.version],
    ["commit", report.commit]
  ].filter(([, value]) => textOf(value, "") !== "");
  append(document.getElementById("foot"), [facts.map(([name, value]) => `${name} ${textOf(value)}`).join(" \u00b7 ")]);
}

function showReport() {
  const report = readReport();
  const page = Object.hasOwn(PAGES, report.page) ? PAGES[report.page] : PAGES.diagnosis;
  showHead(report, page);
  showSections(page.sections.filter(({of}) => !of || of(report)), report);
  showFoot(report);
  followColourScheme();
}

showReport();
