// ---- residual_arrows.js: the error at every reading's place as an arrow, seen from above and from the side.

const VIEWS = [
  {name: "seen from above", axes: [0, 1], names: ["x", "y"]},
  {name: "seen from the side", axes: [0, 2], names: ["x", "z"]},
];
const RESIDUAL_SHARE = 0.11;  // the longest arrow's length, in parts of the picture's width

function residualMapsSection(report) {
  const readings = placedReadings(report).filter((reading) => numbers(reading.before, 3));
  if (readings.length === 0) return [notRecorded("The errors at the readings")];
  const series = seriesOf(report);
  return [
    el("p", {class: "lead"},
       "From where the model puts the tip towards where it was measured, at every reading's place in the world. " +
           "Arrows that all lean one way, or turn with the place, are a pattern; noise points everywhere."),
    ...residualRows(series).map(
        (row) =>
            el("div", {class: "pair maps"}, row.map(([view, entry]) => residualMap(report, readings, view, entry))))
  ];
}

/// Before and after side by side, view by view; with nothing after, the views side by side.
function residualRows(series) {
  const rows = VIEWS.map((view) => series.map((entry) => [view, entry]));
  return series.length === 1 ? [rows.flat()] : rows;
}

/// The largest error of a share of 98 %, so that one wild reading does not make all others small.
function usualLargest(readings) {
  const sizes = readings.map((reading) => sizeOf(reading.before)).filter(isNumber).sort((a, b) => a - b);
  return sizes[Math.floor(0.98 * (sizes.length - 1))] || 1;
}

function residualMap(report, readings, view, series) {
  const shown = readings.filter((reading) => numbers(reading[series.key], 3));
  const picture = figure(
      `Errors ${view.name}, ${series.name}`, (width) => drawResiduals(report, readings, shown, view, series, width));
  const sizes = shown.map((reading) => sizeOf(reading[series.key]));
  const title = series.key === "before" ? "Before" : "After";
  return el(
      "div", {class: "card"}, el("h3", {}, `${title}: ${series.name}, ${view.name}`), picture.element,
      el("p", {class: "note"},
         `Root mean square ${lengthText(rootMeanSquare(sizes), report)}, largest ${
             lengthText(Math.max(...sizes), report)}.`));
}

/// Scale and place of a view: equal scales, all readings inside with room for their arrows.
function viewFrame(readings, view, width) {
  const extent = extentOfPlaces(readings.map((reading) => view.axes.map((axis) => reading.position[axis])));
  const pad = RESIDUAL_SHARE * width + 6, foot = 30;
  const across = Math.max(1e-9, extent.right - extent.left), up = Math.max(1e-9, extent.top - extent.bottom);
  const scale = Math.min((width - 2 * pad) / across, 0.78 * width / up);
  const height = up * scale + 2 * pad + foot, slack = (width - 2 * pad - across * scale) / 2;
  return {
    scale,
    height,
    foot,
    place: (p) => [pad + slack + scale * (p[view.axes[0]] - extent.left), pad + scale * (extent.top - p[view.axes[1]])]
  };
}

function extentOfPlaces(places) {
  const along = (axis) => places.map((place) => place[axis]);
  const least = (values) => values.reduce((low, value) => Math.min(low, value), Infinity);
  const most = (values) => values.reduce((top, value) => Math.max(top, value), -Infinity);
  return {left: least(along(0)), right: most(along(0)), bottom: least(along(1)), top: most(along(1))};
}

/// Both series and both views share the arrows' scale in pixels per length.
function drawResiduals(report, readings, shown, view, series, width) {
  const frame = viewFrame(readings, view, width);
  const pixels = RESIDUAL_SHARE * width / usualLargest(readings);
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${frame.height}`, width, height: frame.height, class: "chart"});
  const ends = (reading) => {
    const from = frame.place(reading.position), error = reading[series.key];
    return [from, [from[0] + pixels * error[view.axes[0]], from[1] - pixels * error[view.axes[1]]]];
  };
  append(drawing, [
    svg("path",
        {d: shown.map((reading) => circlePath(...frame.place(reading.position), 1.3)).join(""), class: "place"}),
    svg("path", {d: shown.map((reading) => arrowPath(...ends(reading))).join(""), class: `arrow-${series.key}`}),
    scaleBars(report, frame, pixels, width), viewAxes(view, frame, width)
  ]);
  hoverPicture(drawing, width, (px, py) => {
    const near = nearestOf(shown, (reading) => frame.place(reading.position), px, py, 12);
    return near ? residualTip(report, near) : null;
  });
  return drawing;
}

/// A shaft and a filled head.
function arrowPath(from, to) {
  const length = distance(from, to);
  if (length < 0.7) return "";
  const head = Math.min(6, 0.7 * length), [ux, uy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const [nx, ny] = [to[0] - head * ux, to[1] - head * uy], half = 0.4 * head;
  const at = (x, y) => `${x.toFixed(1)} ${y.toFixed(1)}`;
  return `M${at(...from)}L${at(nx, ny)}M${at(...to)}L${at(nx - half * uy, ny + half * ux)}L${
      at(nx + half * uy, ny - half * ux)}Z`;
}

function scaleBars(report, frame, pixels, width) {
  const y = frame.height - 12, unit = lengthUnit(report);
  const error = roundDown125(RESIDUAL_SHARE * width / pixels), place = roundDown125(0.22 * width / frame.scale);
  const right = 190, end = right + place * frame.scale;
  return [
    svg("path", {d: arrowPath([6, y], [6 + error * pixels, y]), class: "arrow-scale"}),
    label(6, y - 9, `error of ${exact(error)} ${unit}`),
    svg("path", {d: `M${right} ${y - 4}v8m0 -4H${end}m0 -4v8`, class: "ruler"}),
    label(right, y - 9, `${exact(place)} ${unit} of place`)
  ];
}

function viewAxes(view, frame, width) {
  const x = width - 52, y = frame.height - 12;
  return [
    svg("path", {d: arrowPath([x, y], [x + 30, y]) + arrowPath([x, y], [x, y - 30]), class: "arrow-scale"}),
    label(x + 33, y + 4, view.names[0]), label(x - 3, y - 34, view.names[1])
  ];
}

function residualTip(report, reading) {
  const unit = lengthUnit(report);
  const errors = (key) => numbers(reading[key], 3) ?
      `${key} ${short(sizeOf(reading[key]))} ${unit}: ${reading[key].map(short).join(", ")}` :
      null;
  return [readingName(reading), errors("before"), errors("after"), conditionsText(report, reading)];
}

/// "theta1 \u221253.1, theta2 75.7 deg; load 20 lbf".
function conditionsText(report, reading) {
  const names = jointNames(report, reading);
  const joints =
      (Array.isArray(reading.joints) ? reading.joints : []).map((value, i) => `${names[i].name} ${fixed(value, 1)}`);
  const load = isNumber(reading.load) ?
      `load\u00a0${exact(reading.load)}\u00a0${textOf(object(report.units)?.force, "")}` :
      null;
  return [joints.join(", "), load].filter((text) => text).join("; ");
}

/// [{name, unit}] of the joints, numbered where the page is not told their names.
function jointNames(report, reading) {
  const given = list(report.joints);
  return (Array.isArray(reading.joints) ? reading.joints : []).map((_, i) => ({
                                                                     name: textOf(given[i]?.name, `joint ${i + 1}`),
                                                                     unit: textOf(given[i]?.unit, angleUnit(report))
                                                                   }));
}
