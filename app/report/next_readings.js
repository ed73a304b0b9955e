// ---- next_readings.js: what to measure next so that open explanations are told apart, and warnings about effects.

function isSplit(report) { return object(report.splitting) !== null || list(report.next_readings).length > 0; }

function nextReadingsSection(report) {
  const splitting = object(report.splitting) ?? {}, next = list(report.next_readings), pairs = list(splitting.pairs);
  return [
    el("p", {class: "lead"}, textOf(splitting.advice, "These readings would tell the explanations apart.")),
    next.length === 0 ? null : printButton("Print these readings alone, to fill in"),
    next.length === 0 ? null : el("div", {class: "card"}, nextReadingsTable(report, next)),
    pairs.length === 0 ? null : el("div", {class: "card"}, el("h3", {}, "What they would do"), pairsTable(pairs)),
    otherMeansCard(splitting)
  ];
}

function senseText(senses, joint) {
  const sense = object(senses)?.[joint];
  if (!isNumber(sense) || sense === 0) return "";
  return sense > 0 ? " \u2191" : " \u2193";
}

/// What is to be written down of each kind of reading; a touch is its joints alone.
const TO_WRITE = {position: ["x", "y", "z"], distance: ["distance"], deflection: ["dx", "dy", "dz"]};

/// Joints with an arrow for the sense in which each must arrive, and the separation as a bar of the largest.
function nextReadingsTable(report, next) {
  const joints = Object.keys(object(next[0].posture) ?? {});
  const most = Math.max(1e-12, ...next.map((entry) => entry.separation_sigmas).filter(isNumber));
  const blank = TO_WRITE[textOf(next[0].kind)] ?? joints.map((joint) => `${joint} read`);
  const rows = next.map((entry, i) => [
    `${i + 1}. ${textOf(entry.point, textOf(entry.kind))}`, short(entry.load),
    ...joints.map((joint) => `${short(entry.posture?.[joint])}${senseText(entry.senses, joint)}`),
    textList(entry.splits).join(" from "),
    barCell(entry.separation_sigmas / most, short(entry.separation_sigmas)),
    ...blank.map(() => el("span", {class: "to-fill"}))
  ]);
  const text = [0, 2 + joints.length];
  return table(["reading", "load", ...joints, "splits", "by, in noise sigmas", ...blank], rows, {text});
}

function pairsTable(pairs) {
  const rows = pairs.map((pair) => [
    textOf(pair.if_true), textOf(pair.against), short(pair.criterion_gap_now), short(pair.criterion_gap_expected),
    probability(pair.probability_told)
  ]);
  return table(["if it is", "rather than", "BIC apart now", "expected then", "chance to be named"], rows, {text: [0, 1]});
}

function otherMeansCard(splitting) {
  const means = list(splitting.other_means), columns = textList(splitting.columns_to_add);
  if (means.length + columns.length === 0) return null;
  return el(
      "div", {class: "card"}, el("h3", {}, means.length > 0 ? "What else would tell" : "What to write down beside"),
      el("ul", {class: "reasons"}, means.map((entry) => el("li", {}, textOf(entry.what))),
         columns.map((text) => el("li", {}, text))));
}

function warningsSection(report) {
  return [el("div", {class: "card"},
             el("ul", {class: "reasons"},
                list(report.warnings).map((entry) => el("li", {}, textOf(object(entry)?.sentence, textOf(entry))))))];
}
