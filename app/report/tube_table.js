// ---- tube_table.js: every visited tube's figures, made only when asked for.

function tubeTableSection(report) {
  const tubes = list(report.tubes);
  if (tubes.length === 0) return [notRecorded("Visited tubes")];
  const place = el("div");
  const fill = (event) => {
    if (event.target.open && place.childElementCount === 0) place.append(tubeTable(report, tubes));
  };
  return [el("details", {class: "card", toggle: fill}, el("summary", {}, `Figures of ${plural(tubes.length, "visited tube")}`), place)];
}

function tubeTable(report, tubes) {
  const unit = lengthUnit(report);
  const rows = tubes.map((tube, i) => [whole(i + 1), tubeName(tube), fixed(tube.x, 3), fixed(tube.y, 3), short(tube.tilt),
    short(tube.predicted_error), probability(numbers(tube.probability_by_steps, 4)?.[3]),
    ...MODES.flatMap((mode) => [short(object(tube[mode.key])?.error), caseCell(scoredCase(tube, mode.key, report.steps))])]);
  return table(["visit", "tube", `x, ${unit}`, `y, ${unit}`, `tilt, ${angleUnit(report)}`, `predicted error, ${unit}`, "chance of 3 steps",
    ...MODES.flatMap((mode) => [`error, ${mode.brief}`, "steps"])], rows, {text: [1]});
}

function caseCell(index) {
  return index === null ? null : el("span", {class: "case"}, markIcon(CASES[index]), ` ${index}`);
}
