// ---- effect_ranking.js: every effect that was tried, most probable first.

const MOST_RANKED = 12;

function rankingSection(report) {
  const ranking = list(report.ranking);
  if (ranking.length === 0) return [notRecorded("The ranking of effects")];
  const shown = ranking.slice(0, MOST_RANKED);
  return [
    el("p", {class: "lead"}, rankingLead(report, ranking)), el("div", {class: "card"}, rankingTable(report, shown)),
    ranking.length > shown.length ?
        el("details", {}, el("summary", {}, `The other ${whole(ranking.length - shown.length)}`),
           el("div", {class: "card"}, rankingTable(report, ranking.slice(MOST_RANKED), shown[0]))) :
        null
  ];
}

function rankingLead(report, ranking) {
  const tried = `${plural(ranking.length, "cause", "causes")} ${ranking.length === 1 ? "was" : "were"} tried. `;
  const chances = object(report.probability);
  const nothing = isNumber(chances?.nothing_missing) ?
      `That nothing is missing has probability ${probability(chances.nothing_missing)}, that no known effect is part ` +
          `of it ${probability(chances.unknown_alone)}. ` :
      "";
  const joined = explanationsOf(report).some((entry) => entry.effects.length > 1) ?
      "The explanation above joins several; here the fall of chi-square is of each alone. " :
      "";
  const lacks = textList(report.not_tried);
  return `${tried}${nothing}${joined}${lacks.length === 0 ? "" : `Not tried: ${lacks.join("; ")}.`}`;
}

/// A number behind a bar of its share of the largest.
function barCell(share, text) {
  const wide = 46, tall = 11;
  return el(
      "span", {class: "bar-cell"},
      svg("svg", {width: wide, height: tall, "aria-hidden": "true"},
          svg("rect", {x: 0.5, y: 0.5, width: wide - 1, height: tall - 1, class: "bar-frame"}),
          isNumber(share) && share > 0 ? svg("rect", {
            x: 0.5,
            y: 0.5,
            width: Math.max(1, (wide - 1) * Math.min(1, share)),
            height: tall - 1,
            class: "bar-fill"
          }) :
                                         null),
      text);
}

function rankedName(entry) {
  const words = [
    effectWords(entry),
    isNumber(entry.kept_fraction) && entry.kept_fraction < 0.5 ? keptText(entry.kept_fraction) : null
  ];
  return el("span", {class: "effect-name"}, effectTitle(entry), words.map((text) => text && el("small", {}, text)));
}

function rankingTable(report, ranking, first = ranking[0]) {
  const most = Math.max(1e-12, first.chi2_fall ?? 0, ...ranking.map((entry) => entry.chi2_fall).filter(isNumber));
  const rows = ranking.map((entry) => {
    const size = object(entry.size);
    return [
      rankedName(entry), barCell(entry.probability, probability(entry.probability)),
      barCell(entry.chi2_fall / most, short(entry.chi2_fall)),
      size ? el("span", {}, withSigma(size), el("small", {class: "number-name"}, plainName(size.name))) : null,
      barCell(entry.kept_fraction, percent(entry.kept_fraction))
    ];
  });
  return el(
      "div", {class: "ranking"},
      table(["effect", "probability", "chi-square falls by", "size", "of it shows"], rows));
}
