// ---- diagnosis_rates.js: how often a diagnosis is right.

const RATES = [
  ["truth_among_answers", "truth among the answers"], ["named", "named alone"], ["wrong", "another named"],
  ["refused", "refused as unexplained"], ["missed", "not seen"]
];

function rateRows(entry) {
  return RATES.map(([key, name], i) => ({name, ...(object(entry?.[key]) ?? {}), mark: seriesOf(i)}));
}

const RATE_AXIS = {
  from: 0,
  to: 1,
  title: "share of the runs",
  write: probability
};

function ratesSection(report) {
  const nothing = object(report.nothing_hidden) ?? {};
  return [
    el("p", {class: "lead"}, "What the diagnosis said, seen from the truth. Bars are 95 % bands."),
    el("div", {class: "pair"},
       el("div", {class: "card"}, el("h3", {}, "Nothing was hidden"),
          estimateRows(
              "Nothing hidden",
              [
                {name: "false alarms", ...(object(nothing.false_alarms) ?? {}), mark: seriesOf(1)},
                {name: "inconclusive", ...(object(nothing.inconclusive) ?? {}), mark: seriesOf(4)}
              ],
              RATE_AXIS)),
       el("div", {class: "card"}, el("h3", {}, "An effect was hidden"),
          estimateRows("An effect hidden", rateRows(object(report.hidden)), RATE_AXIS)))
  ];
}

function sizesSection(report) {
  const rows = list(report.by_size).map((entry, i) => ({
                                          name: `${short(entry.size?.[0])} to ${short(entry.size?.[1])} of the largest`,
                                          ...(object(entry.truth_among_answers) ?? {}),
                                          mark: seriesOf(i)
                                        }));
  return [
    el("p", {class: "lead"},
       "The larger an effect, the surer it is found. Sizes are shares of the largest that a machine has."),
    el("div", {class: "card"}, estimateRows("Truth among the answers by size", rows, RATE_AXIS))
  ];
}

function effectsSection(report) {
  const keys = ["named", "among", "other", "unexplained", "inconclusive", "adequate", "not-made"];
  const rows = list(report.by_effect)
                   .map(
                       (entry) =>
                           [textOf(entry.effect), ...keys.map((key) => whole(object(entry.outcomes)?.[key])),
                            probability(object(entry.truth_among_answers)?.value)]);
  const nothing = object(object(report.nothing_hidden)?.outcomes) ?? {};
  rows.unshift(["(nothing)", ...keys.map((key) => whole(nothing[key])), MISSING]);
  return [el("div", {class: "card"}, table(["hidden", ...keys, "truth among the answers"], rows))];
}
