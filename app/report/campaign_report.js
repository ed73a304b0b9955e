// The page itself, by the kind of the campaign.
import {chance, plural, probability, whole} from "../drawing/numbers.js";
import {chanceMapSection, curvesSection, settingName, settingsSection, worstHolesSection} from "./centring_views.js";
import {effectsSection, ratesSection, sizesSection} from "./diagnosis_rates.js";
import {append, el, followColourScheme} from "./elements.js";
import {readReport, showSections} from "./sections.js";
import {readSheet} from "./sheet_frame.js";
import {list, object, textOf} from "./values.js";

const CENTRING_SECTIONS = [
  {id: "curves", title: "Centring error", make: curvesSection},
  {id: "settings", title: "Settings side by side", make: settingsSection},
  {id: "sheet", title: "Probabilities over the sheet", make: chanceMapSection},
  {id: "worst", title: "The worst holes", make: worstHolesSection},
];
const DIAGNOSIS_SECTIONS = [
  {id: "rates", title: "How often it is right", make: ratesSection},
  {id: "sizes", title: "By size", make: sizesSection},
  {id: "effects", title: "By effect", make: effectsSection},
];

function centringSentence(report) {
  const setting = list(report.settings)[0], steps = list(object(setting?.compensated)?.steps);
  const last = steps[steps.length - 1], chance = object(last?.probability);
  if (!chance) return "No run was scored.";
  return `With ${settingName(report, setting)}, ${last.at_least} of ${
             plural(steps.length, "step")} of the tool enter a hole with a probability of ` +
      `${probability(chance.value)} (${probability(chance.low)} to ${probability(chance.high)}) after compensation, ` +
      `${textOf(object(setting.base)?.words)}.`;
}

function diagnosisSentence(report) {
  const found = object(object(report.hidden)?.truth_among_answers),
        alarms = object(object(report.nothing_hidden)?.false_alarms);
  return `The truth is among the answers in ${probability(found?.value)} of the runs with a hidden effect; ` +
      `${probability(alarms?.value)} of those without one are false alarms.`;
}

function showCampaign() {
  const report = readReport(), isDiagnosis = report.kind === "diagnose";
  const title = textOf(report.title, "Campaign");
  document.title = title;
  append(document.getElementById("head"), [
    el("h1", {}, title),
    el("p", {class: "sentence"},
       `${whole(report.runs_done)} of ${plural(report.runs, "run")}. ` +
           (isDiagnosis ? diagnosisSentence(report) : centringSentence(report)))
  ]);
  showSections(isDiagnosis ? DIAGNOSIS_SECTIONS : CENTRING_SECTIONS, report, readSheet(report));
  append(document.getElementById("foot"), [[
           ["cell", report.cell], ["seed", report.seed], ["tubeplan", report.version]
         ].map(([name, value]) =>
                   `${name} ${textOf(value)}`).join(" \u00b7 ")]);
  followColourScheme();
}

showCampaign();
