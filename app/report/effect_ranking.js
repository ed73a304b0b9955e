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
  const evidence = object(report.evidence);
  const tried = `${plural(ranking.length, "effect at a place", "effects at a place")} ${
      ranking.length === 1 ? "was" : "were"} tried, each alone. `;
  const isKnown = isNumber(evidence?.best) && isNumber(evidence?.noise_reaches);
  const joint = isKnown && evidence.best <= evidence.noise_reaches ? ", less than the" : "; noise alone reaches";
  const found = isKnown ?
      `The best stands out by ${evidenceText(evidence.best)} powers of ten${joint} ${fixed(evidence.noise_reaches, 1)}${
          joint.startsWith(",") ? " that noise alone reaches" : ""} over the whole list. ` :
      "";
  const pairs = explanationsOf(report).some((entry) => entry.effects.length > 1) ?
      "The explanation above joins two effects; here each stands alone, so that its probability may be small. " :
      "";
  return `${tried}${found}${pairs}"Like the first": how far its signature is that of the first; at 1 no fit tells ` +
      "them apart.";
}

/// Powers of ten; beyond 300 the chance of it is no longer a number.
function evidenceText(best) { return best >= 300 ? "more than 300" : fixed(best, 1); }

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
      barCell(entry.kept_fraction, percent(entry.kept_fraction)),
      isNumber(entry.correlation_with_leader) ? fixed(Math.abs(entry.correlation_with_leader), 3) : null
    ];
  });
  return el(
      "div", {class: "ranking"},
      table(["effect", "probability", "chi-square falls by", "size", "of it shows", "like the first"], rows));
}
