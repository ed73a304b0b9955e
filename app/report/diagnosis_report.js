// ---- diagnosis_report.js: the pages about a model's errors: a diagnosis, a comparison, a ladder.

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
const CHARTS = {
  id: "charts",
  title: "What the errors follow",
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
        of: (report) => explanationsOf(report).length > 1
      },
    ]
  },
  comparison: {
    title: "Model and readings",
    sections: [
      LADDER, {id: "patterns", title: "Patterns in the errors", make: patternsSection}, MAPS, CHARTS,
      {id: "worst", title: "The worst readings", make: worstSection}
    ]
  },
  ladder: {
    title: "Ladder of models",
    sections: [
      LADDER, {id: "steps", title: "How far the tool goes in", make: ladderStepsSection, of: hasStepCounts},
      {id: "models", title: "The same in figures", make: modelsSection},
      {...MAPS, of: (report) => list(report.readings).length > 0}
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
      {id: "inputs", title: "What it is of", make: inputsSection},
      {id: "commands", title: "The same figures again", make: commandsSection},
    ]
  },
};

function factsOf(report) {
  const rms = object(report.rms) ?? {};
  const chi2 = isNumber(report.chi2_per_dof) ?
      `${short(report.chi2_per_dof)}${isNumber(report.p_value) ? ` (p\u00a0${pText(report.p_value)})` : ""}` :
                                                                 null;
  const isBetter = explanationsOf(report).some((entry) => entry.enough !== false) || report.page !== "diagnosis";
  const error = (value) => (errorOf(value) === null ? null : lengthText(errorOf(value), report));
  const own = Array.isArray(report.facts) ? report.facts.filter((fact) => Array.isArray(fact) && fact.length === 2) : [];
  return [
    ...own, ["Readings", list(report.readings).length > 0 ? whole(list(report.readings).length) : null],
    ["Held-out error before", error(rms.heldout_before)],
    ["Held-out error after", isBetter ? error(rms.heldout_after) : null], ["Noise floor", error(noiseFloorOf(report))],
    ["Chi-square per degree of freedom", chi2],
    ["Readings set aside", textList(report.set_aside).length > 0 ? whole(report.set_aside.length) : null]
  ].filter(([, value]) => value !== null && value !== "");
}

function showHead(report, page) {
  const title = textOf(report.title, page.title), verdict = verdictOf(report), facts = factsOf(report);
  document.title = title;
  append(document.getElementById("head"), [
    el("h1", {}, title), verdict ? el("p", {class: "verdict"}, markIcon(verdict, 34), el("b", {}, verdict.word)) : null,
    textOf(report.sentence, "") === "" ? null : el("p", {class: "answer"}, report.sentence),
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
