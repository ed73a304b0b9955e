// ---- sheet_maps.js: the sheet before and after compensation, every visited tube by its case.

/// What a map can show: each mode that was scored against the true arm, and what the plan itself expects.
function mapModes(report) {
  const tubes = list(report.tubes);
  const scored = MODES.filter((mode) => tubes.some((tube) => scoredCase(tube, mode.key, report.steps) !== null))
                     .map((mode) => ({...mode, caseOf: (tube) => scoredCase(tube, mode.key, report.steps)}));
  const predicted =
      {key: "predicted", name: "as predicted", brief: "predicted", caseOf: (tube) => predictedCase(tube, report.steps)};
  return {
    before: scored.find((mode) => mode.key === "none") ?? null,
    after: [...scored.filter((mode) => mode.key !== "none").reverse(), predicted]
  };
}

function sheetMapsSection(report, sheet) {
  if (!sheet) return [notRecorded("The sheet's holes")];
  const {before, after} = mapModes(report);
  return [
    el("p", {class: "lead"},
       `${plural(sheet.holes.length, "hole")}, ${viewName(sheet)}. Every mark is a visited tube: how ` +
           "far the stepped calibration tool goes in. Point at a hole for its figures; the boxes below a map hide and " +
           "show its marks."),
    el("div", {class: "pair"},
       before ?
           sheetMap(report, sheet, "Before", [before]) :
           el("div", {class: "card"}, el("h3", {}, "Before: no compensation"),
              notRecorded("Centring without compensation (the plan was made without a true arm to score against)")),
       sheetMap(report, sheet, before ? "After" : "The plan", after)),
    unreachableList(report),
  ];
}

/// One map with its heading, a choice of mode when there are several, and its legend with live counts.
function sheetMap(report, sheet, heading, modes) {
  const state = {mode: modes[0], hidden: new Set()};
  const legend = el("ul", {class: "legend"});
  const title = el("h3");
  const picture = figure(
      `Tube sheet, ${viewName(sheet)}: ${heading.toLowerCase()}`, (width) => drawMap(report, sheet, state, width));
  const refresh = () => {
    title.textContent = `${heading}: ${state.mode.name}`;
    legend.replaceChildren(...legendEntries(report, sheet, state, refresh));
    picture.redraw();
  };
  refresh();
  const modeChoice = modes.length < 2 ?
      null :
      choice("Compensation shown", modes.map((mode) => [mode, mode.brief]), state.mode, (mode) => {
        state.mode = mode;
        refresh();
      });
  return el("div", {class: "card"}, el("div", {class: "card-head"}, title, modeChoice), picture.element, legend);
}

/// The groups of marks that a map shows, each {mark, holes}, in drawing order.
function markGroups(report, state) {
  const tubes = list(report.tubes).filter((tube) => isNumber(tube.x) && isNumber(tube.y));
  const unreachable = list(report.unreachable).filter((tube) => isNumber(tube.x) && isNumber(tube.y));
  return [
    ...CASES.map((mark, index) => ({mark, holes: tubes.filter((tube) => state.mode.caseOf(tube) === index)})).reverse(),
    {mark: UNREACHABLE, holes: unreachable},
    {mark: UNSCORED, holes: tubes.filter((tube) => state.mode.caseOf(tube) === null)}
  ];
}

function drawMap(report, sheet, state, width) {
  const {canvas, context, frame} = drawSheet(sheet, width);
  const groups = markGroups(report, state);
  const places = groups.flatMap((group) => group.holes.map((hole) => frame.place([hole.x, hole.y])));
  const radius = markRadius(places);
  for (const {mark, holes} of groups) {
    if (!state.hidden.has(mark)) drawMarks(context, mark, holes.map((hole) => frame.place([hole.x, hole.y])), radius);
  }
  hoverHoles(canvas, sheet, frame, holeDescriber(report, state.mode));
  return canvas;
}

function legendEntries(report, sheet, state, refresh) {
  const toggle = (mark) => (event) => {
    if (event.target.checked)
      state.hidden.delete(mark);
    else
      state.hidden.add(mark);
    refresh();
  };
  const groups = markGroups(report, state);
  const [unreachable, unscored] = groups.slice(CASES.length);
  const shown = [...groups.slice(0, CASES.length).reverse(), unreachable, ...(unscored.holes.length > 0 ? [unscored] : [])];
  const marks = shown.map(
      ({mark, holes}) =>
          el("li", {},
             el("label", {}, el("input", {type: "checkbox", checked: !state.hidden.has(mark), change: toggle(mark)}),
                markIcon(mark), mark.name, el("b", {}, whole(holes.length)))));
  const plain = (mark, count) => el("li", {}, markIcon(mark), mark.name, el("b", {}, whole(count)));
  const states = [...holesByState(sheet)].map(([name, holes]) => plain(stateMark(name), holes.length));
  const listed = list(report.tubes).length + list(report.unreachable).length;
  return [...marks, plain(NOT_VISITED, Math.max(0, sheet.holes.length - listed)), ...states];
}

/// Text for a hole: name and state, and for a visited tube its order, errors and probabilities.
function holeDescriber(report, mode) {
  const tubes = new Map(list(report.tubes).map((tube) => [`${tube.row} ${tube.column}`, tube]));
  const unreachable = new Map(list(report.unreachable).map((tube) => [`${tube.row} ${tube.column}`, tube]));
  const unit = lengthUnit(report);
  return (hole) => {
    const key = `${hole.row} ${hole.column}`;
    const name = `Row ${textOf(hole.row)}, column ${textOf(hole.column)}`;
    const place = `x ${fixed(hole.x, 3)}, y ${fixed(hole.y, 3)} ${unit}`;
    const states = stateMark(hole.state) ? `State: ${stateMark(hole.state).name}` : null;
    if (unreachable.has(key)) return [name, place, states, `Cannot be visited: ${textOf(unreachable.get(key).reason)}`];
    if (!tubes.has(key)) return [name, place, states, "Not on the list"];
    return [name, place, states, ...tubeLines(tubes.get(key), mode, report, unit)];
  };
}

function tubeLines(tube, mode, report, unit) {
  const score = object(tube[mode.key]);
  const index = mode.caseOf(tube);
  const chances = numbers(tube.probability_by_steps, 4);
  return [
    `Visit ${visitNumber(report, tube)}`,
    score ? `Error, ${mode.name}: ${short(score.error)} ${unit} (dx ${short(score.dx)}, dy ${short(score.dy)})` : null,
    index === null ? null : `${score ? "Tool" : "Expected"}: ${CASES[index].long}`,
    score && isNumber(score.approach_deviation) ?
        `Off the hole's axis on the way in: ${short(score.approach_deviation)} ${unit}` :
        null,
    `Predicted error: ${short(tube.predicted_error)} ${unit}; tilt ${short(tube.tilt)} ${angleUnit(report)}`,
    chances ? `Chance of 0/1/2/3 steps: ${chances.map(probability).join(" / ")}` : null,
  ];
}

/// The tubes that cannot be visited, by reason; long lists fold away.
function unreachableList(report) {
  const tubes = list(report.unreachable);
  if (!Array.isArray(report.unreachable)) return notRecorded("Tubes that cannot be visited");
  if (tubes.length === 0) return el("p", {class: "good"}, "Every tube on the list is visited.");
  const reasons = new Map();
  for (const tube of tubes) {
    const reason = textOf(tube.reason, "no reason recorded");
    reasons.set(reason, [...(reasons.get(reason) ?? []), tube]);
  }
  const entries = [...reasons].sort((a, b) => b[1].length - a[1].length).map(([reason, group]) => {
    const names = group.map(tubeName).join(", ");
    return el(
        "li", {}, el("b", {}, `${reason}: `),
        group.length <= 12 ? names : el("details", {}, el("summary", {}, plural(group.length, "tube")), names));
  });
  return el(
      "div", {class: "card"}, el("h3", {}, markIcon(UNREACHABLE), ` ${plural(tubes.length, "tube")} cannot be visited`),
      el("ul", {class: "reasons"}, entries));
}

/// "7 of 60": the tubes are listed in visiting order.
function visitNumber(report, tube) {
  const tubes = list(report.tubes);
  return `${tubes.indexOf(tube) + 1} of ${tubes.length}`;
}
