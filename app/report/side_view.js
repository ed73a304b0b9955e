// The arm in its vertical plane, rigid and deflected.
import {extentOf} from "../drawing/frames.js";
import {exact, isNumber, short} from "../drawing/numbers.js";
import {roundDown125} from "../drawing/scales.js";
import {outlineOf} from "../drawing/shapes.js";
import {append, choice, el, figure, label, notRecorded, svg} from "./elements.js";
import {isPoint, lengthUnit, list, points, textOf} from "./values.js";

export function sideViewSection(report) {
  const views =
      list(report.side_views).filter((view) => points(view.rigid).length > 1 || points(view.flexible).length > 1);
  if (views.length === 0) return [notRecorded("Side views of the arm")];
  const state = {view: views[0], factor: 1};
  const says = el("p", {class: "note"});
  const picture = figure("The arm from the side, rigid and deflected", (width) => drawSideView(report, state, width));
  const refresh = () => {
    says.replaceChildren(...deflectionText(state, lengthUnit(report)));
    picture.redraw();
  };
  refresh();
  const selector =
      el("select", {
        change: (event) => {
          state.view = views[event.target.value];
          refresh();
        }
      },
         views.map((view, i) => el("option", {value: i}, textOf(view.label, `View ${i + 1}`))));
  const factors = choice("Deflection", [[1, "deflection \u00d71"], [10, "deflection \u00d710"]], 1, (factor) => {
    state.factor = factor;
    refresh();
  });
  return [
    el("p", {class: "lead"},
       "The arm in its own vertical plane under a tube: as a rigid arm would stand at the same " +
           "joint values (dashed) and as it hangs under its weight (solid)."),
    el("div", {class: "card"},
       el("div", {class: "card-head"}, el("label", {class: "choice"}, el("span", {}, "Under tube"), selector), factors),
       picture.element, sideLegend(), says)
  ];
}

function sideLegend() {
  const sample = (kind) =>
      svg("svg", {width: 34, height: 10, class: "icon", "aria-hidden": "true"},
          svg("line", {x1: 1, y1: 5, x2: 33, y2: 5, class: kind}));
  return el(
      "ul", {class: "legend"}, el("li", {}, sample("arm-rigid"), "rigid"),
      el("li", {}, sample("arm-flexible"), "deflected"),
      el("li", {}, sample("arm-shape-sample"), "body as checked for clearance"));
}

/// How far the tip moves, from the last points of the two chains.
function deflectionText({view, factor}, unit) {
  const rigid = points(view.rigid).at(-1), flexible = points(view.flexible).at(-1);
  if (!rigid || !flexible) return ["Only one of the two shapes is recorded."];
  const across = flexible[0] - rigid[0], up = flexible[1] - rigid[1];
  return [
    el("b", {}, `The tip moves ${short(Math.hypot(across, up))} ${unit}`),
    ` from the rigid to the deflected arm: ${short(Math.abs(up))} ${up <= 0 ? "down" : "up"} and ${
        short(Math.abs(across))} ` +
        `${across >= 0 ? "outward (+r)" : "inward (\u2212r)"}. `,
    factor === 1 ? "Drawn to scale." :
                   `Drawn ${factor} times larger than it is, from the rigid shape: only \u00d71 meets the hole.`
  ];
}

/// The deflected chain with its deflection magnified.
function magnifiedChain({view, factor}) {
  const rigid = points(view.rigid), flexible = points(view.flexible);
  if (factor === 1 || rigid.length !== flexible.length) return flexible;
  return rigid.map((point, i) => [0, 1].map((k) => point[k] + factor * (flexible[i][k] - point[k])));
}

/// The circle in which the arm's plane cuts the bowl, a sphere about the sheet's centre; null when it is not known.
function bowlCircle(report, view) {
  const aside = isNumber(view.centre_aside) ? view.centre_aside : 0;
  if (!isNumber(report.bowl_radius) || report.bowl_radius <= aside) return null;
  return {
    center: isPoint(view.world_centre) ? view.world_centre : [0, 0],
    radius: Math.sqrt(report.bowl_radius ** 2 - aside ** 2)
  };
}

function readShapes(view) {
  return list(view.shapes).filter((shape) => isPoint(shape.from) && isPoint(shape.to) && isNumber(shape.radius));
}

function drawSideView(report, state, width) {
  const {view} = state;
  const bowl = bowlCircle(report, view);
  const chain = magnifiedChain(state);
  const shapes = readShapes(view);
  const extent = extentOf([
    ...points(view.rigid), ...chain, ...points([view.hole]), [chain[0]?.[0] ?? 0, 0],
    ...shapes.flatMap(
        ({from, to, radius}) => [from, to].flatMap(([r, z]) => [[r - radius, z - radius], [r + radius, z + radius]])),
    ...(bowl ? [[bowl.center[0] - bowl.radius, 0], [bowl.center[0] + bowl.radius, bowl.center[1] - bowl.radius]] : [])
  ]);
  const scale = Math.min((width - 70) / (extent.right - extent.left), 460 / (extent.top - extent.bottom));
  const height = scale * (extent.top - extent.bottom) + 60;
  const at = ([r, z]) => [width / 2 + scale * (r - (extent.left + extent.right) / 2), 26 + scale * (extent.top - z)];
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, width, height, class: "chart"});
  append(drawing, [
    bowl ? bowlArc(bowl, at, scale) : null, sheetLine(extent, at),
    ...(state.factor === 1 ? shapes.map((shape) => capsule(shape, at, scale)) : []),
    ...chainLine(chain, at, "arm-flexible"), ...chainLine(points(view.rigid), at, "arm-rigid"),
    isPoint(view.hole) ? holeMark(view, at) : null, ...lengthScale(extent, scale, height, width, lengthUnit(report))
  ]);
  return drawing;
}

function bowlArc({center, radius}, at, scale) {
  const half = Math.sqrt(Math.max(0, radius * radius - center[1] * center[1]));
  const from = at([center[0] - half, 0]), to = at([center[0] + half, 0]);
  const low = at([center[0], center[1] - radius]);
  return svg(
      "g", {},
      svg("path",
          {d: `M${from[0]} ${from[1]}A${radius * scale} ${radius * scale} 0 0 0 ${to[0]} ${to[1]}`, class: "bowl"}),
      label(low[0], low[1] + 15, "bowl", {"text-anchor": "middle"}));
}

function sheetLine(extent, at) {
  const [left, y] = at([extent.left, 0]), [right] = at([extent.right, 0]);
  return svg(
      "g", {}, svg("rect", {x: left, y: y - 9, width: right - left, height: 9, class: "plate"}),
      svg("line", {x1: left, y1: y, x2: right, y2: y, class: "face"}), label(left, y - 13, "tube sheet"));
}

function capsule({from, to, radius}, at, scale) {
  const [x1, y1] = at(from), [x2, y2] = at(to);
  return svg("line", {
    x1,
    y1,
    x2: x1 === x2 && y1 === y2 ? x2 + 0.01 : x2,
    y2,
    class: "arm-shape",
    "stroke-width": 2 * radius * scale
  });
}

function chainLine(chain, at, kind) {
  if (chain.length < 2) return [];
  const pixels = chain.map(at);
  const dots = pixels.slice(0, -1).map(([cx, cy]) => svg("circle", {cx, cy, r: 3, class: `${kind}-joint`}));
  return [
    svg("polyline", {points: pixels.map((p) => p.join(",")).join(" "), class: kind}), ...dots,
    svg("path", {d: outlineOf("diamond", ...pixels.at(-1), 4).fill, class: `${kind}-joint`})
  ];
}

function holeMark(view, at) {
  const [x, y] = at(view.hole);
  return svg(
      "g", {}, svg("path", {d: `M${x} ${y - 9}v9`, class: "hole-axis"}),
      label(x, y - 13, textOf(view.label, "hole"), {"text-anchor": "middle", class: "strong"}));
}

/// A ruler of a round length in the lower left corner.
function lengthScale(extent, scale, height, width, unit) {
  const length = roundDown125(0.2 * (extent.right - extent.left));
  const y = height - 8;
  return [
    svg("path", {d: `M8 ${y - 5}v10M8 ${y}h${length * scale}m0 -5v10`, class: "ruler"}),
    label(14 + length * scale, y + 4, `${exact(length)} ${unit}`)
  ];
}
