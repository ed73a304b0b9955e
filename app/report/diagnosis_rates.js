// How often a diagnosis is right.
import {MISSING, probability, short, whole} from "../drawing/numbers.js";
import {el, table} from "./elements.js";
import {estimateRows, settingLook} from "./estimate_rows.js";
import {list, object, textOf} from "./values.js";

/// The shares of the runs that hide an effect, in the words of the report.
function rateRows(report) {
  const hidden = object(report.hidden) ?? {};
  return list(report.rates)
      .map(({name, words}, i) => ({...(object(hidden[name]) ?? {}), name: textOf(words, name), mark: settingLook(i)}));
}

const RATE_AXIS = {
  from: 0,
  to: 1,
  title: "fraction of the runs",
  write: probability
};

export function ratesSection(report) {
  const nothing = object(report.nothing_hidden) ?? {};
  return [
    el("p", {class: "lead"}, "Verdicts by the true cause. Bars are 95 % bands."),
    el("div", {class: "pair"},
       el("div", {class: "card"}, el("h3", {}, "No hidden effect"),
          estimateRows(
              "Nothing hidden",
              [
                {name: "false alarms", ...(object(nothing.false_alarms) ?? {}), mark: settingLook(1)},
                {name: "inconclusive", ...(object(nothing.inconclusive) ?? {}), mark: settingLook(4)}
              ],
              RATE_AXIS)),
       el("div", {class: "card"}, el("h3", {}, "Hidden effect"),
          estimateRows("An effect hidden", rateRows(report), RATE_AXIS)))
  ];
}

export function sizesSection(report) {
  const rows = list(report.by_size).map((entry, i) => ({
                                          name: `${short(entry.size?.[0])} to ${short(entry.size?.[1])} of the largest`,
                                          ...(object(entry.truth_among_answers) ?? {}),
                                          mark: settingLook(i)
                                        }));
  return [
    el("p", {class: "lead"},
       "The larger an effect, the more reliably it is found. Sizes are relative to the largest plausible one."),
    el("div", {class: "card"}, estimateRows("Truth among the answers by size", rows, RATE_AXIS))
  ];
}

export function effectsSection(report) {
  const outcomes = list(report.outcomes), keys = outcomes.map((outcome) => outcome.name);
  const all = list(report.by_effect),
        isDrawn = ({outcomes: counts}) => keys.some((key) => (object(counts)?.[key] ?? 0) > 0);
  const rows = all.filter(isDrawn).map(
      (entry) =>
          [effectCell(entry), ...keys.map((key) => whole(object(entry.outcomes)?.[key])),
           probability(object(entry.truth_among_answers)?.value)]);
  const nothing = object(object(report.nothing_hidden)?.outcomes) ?? {};
  rows.unshift(["(nothing)", ...keys.map((key) => whole(nothing[key])), MISSING]);
  const heads = ["hidden", ...outcomes.map((outcome) => textOf(outcome.words)), "truth among the answers"];
  const absent = all.filter((entry) => !isDrawn(entry)).map(({effect}) => textOf(effect));
  return [el(
      "div", {class: "card"}, table(heads, rows),
      absent.length === 0 ? null : el("p", {class: "note"}, `Hidden in none of these runs: ${absent.join(", ")}.`))];
}

/// The name of an effect over what it is.
function effectCell({effect, words}) {
  return el("span", {class: "effect-name"}, textOf(effect), textOf(words, "") ? el("small", {}, words) : null);
}
