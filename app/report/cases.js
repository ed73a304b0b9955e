// ---- cases.js: the tables of cases and states, each with colour and shape, and how a mark is drawn.

/// How far the calibration tool went in. Okabe and Ito's colours; the shapes alone tell the cases apart in print.
const CASES = [
  {name: "0 steps", long: "no step enters", colour: "case0", shape: "cross"},
  {name: "1 step", long: "first step enters", colour: "case1", shape: "triangle"},
  {name: "2 steps", long: "two steps enter", colour: "case2", shape: "square"},
  {name: "3 steps", long: "all three steps enter", colour: "case3", shape: "disc"},
];

const UNREACHABLE = {
  name: "cannot be visited",
  colour: "unreachable",
  shape: "hatched"
};
const UNSCORED = {name: "not scored", colour: "muted", shape: "diamond"};
const NOT_VISITED = {
  name: "not on the list",
  colour: "hole",
  shape: "ring"
};

/// States of a hole's tube, by the names of the hole map; "open" needs no mark.
const STATES = {
  "plugged": {name: "plugged", colour: "ink", shape: "disc"},
  "stabilised": {name: "plugged and stabilised", colour: "ink", shape: "square"},
  "sleeved": {name: "sleeved", colour: "state", shape: "double-ring"},
  "to-plug": {name: "recommended to plug", colour: "state", shape: "half"},
  "inaccessible": {name: "reported inaccessible", colour: "ink", shape: "bar"},
  "unresolved": {name: "identity unresolved", colour: "state", shape: "diamond"},
};

function stateMark(state) {
  if (typeof state !== "string" || state === "" || state === "open") return null;
  return STATES[state] ?? {name: state, colour: "state", shape: "diamond"};
}

function circlePath(x, y, r) { return `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${- 2 * r} 0Z`; }

/// The outline of each shape about (x, y) as an SVG path; `stroked` shapes have no filled part.
const SHAPES = {
  "cross": {
    stroked: true,
    path: (x, y, r) => {
      const s = 0.85 * r;
      return `M${x - s} ${y - s}L${x + s} ${y + s}M${x - s} ${y + s}L${x + s} ${y - s}`;
    }
  },
  "triangle": {path: (x, y, r) => `M${x} ${y - 1.15 * r}L${x + 1.1 * r} ${y + 0.8 * r}L${x - 1.1 * r} ${y + 0.8 * r}Z`},
  "open-triangle": {
    stroked: true,
    thin: true,
    path: (x, y, r) => `M${x} ${y - 1.15 * r}L${x + 1.1 * r} ${y + 0.8 * r}L${x - 1.1 * r} ${y + 0.8 * r}Z`
  },
  "square": {path: (x, y, r) => `M${x - 0.85 * r} ${y - 0.85 * r}h${1.7 * r}v${1.7 * r}h${- 1.7 * r}Z`},
  "disc": {path: circlePath},
  "diamond": {path: (x, y, r) => `M${x} ${y - r}L${x + r} ${y}L${x} ${y + r}L${x - r} ${y}Z`},
  "half": {path: (x, y, r) => `M${x - r} ${y}A${r} ${r} 0 0 1 ${x + r} ${y}Z`},
  "ring": {stroked: true, path: circlePath},
  "double-ring": {stroked: true, path: (x, y, r) => circlePath(x, y, r) + circlePath(x, y, 0.5 * r)},
  "bar": {stroked: true, path: (x, y, r) => circlePath(x, y, r) + `M${x - r} ${y}L${x + r} ${y}`},
  "hatched": {
    stroked: true,
    thin: true,
    path: (x, y, r) => {
      const middle = 0.707 * r, near = 0.258 * r, far = 0.966 * r;
      return circlePath(x, y, r) + `M${x - middle} ${y + middle}L${x + middle} ${y - middle}` +
          `M${x - near} ${y + far}L${x + far} ${y - near}M${x - far} ${y + near}L${x + near} ${y - far}`;
    }
  },
};

/// Draws marks of one kind at many places ([x, y] in pixels) on a canvas.
function drawMarks(context, mark, places, radius) {
  const shape = SHAPES[mark.shape];
  const path = new Path2D(places.map(([x, y]) => shape.path(x, y, radius)).join(""));
  context.lineJoin = "round";
  if (!shape.stroked) {
    context.fillStyle = colour(mark.colour);
    context.fill(path);
  }
  context.strokeStyle = colour(shape.stroked ? mark.colour : "ink");
  context.lineWidth = shape.stroked ? Math.max(1, (shape.thin ? 0.2 : 0.35) * radius) : Math.min(0.9, 0.16 * radius);
  context.stroke(path);
}

/// The mark as a small picture for legends and tables.
function markIcon(mark, size = 14) {
  const shape = SHAPES[mark.shape];
  const middle = size / 2, radius = 0.36 * size;
  return svg(
      "svg", {width: size, height: size, viewBox: `0 0 ${size} ${size}`, class: "icon", "aria-hidden": "true"},
      svg("path", {
        d: shape.path(middle, middle, radius),
        "stroke-linejoin": "round",
        fill: shape.stroked ? "none" : `var(--${mark.colour})`,
        stroke: shape.stroked ? `var(--${mark.colour})` : "var(--ink)",
        "stroke-width": shape.stroked ? (shape.thin ? 1.1 : 1.8) : 0.8
      }));
}

/// The modes of compensation, in the order of the thesis's comparison.
const MODES = [
  {key: "none", name: "no compensation", brief: "without"},
  {key: "goal_point", name: "goal-point compensation", brief: "goal-point"},
  {key: "via_point", name: "via-point compensation", brief: "via-point"},
];

/// The number of steps (0 to 3) that enter at a centring error, by the tool's tolerances; null when it cannot be told.
function stepsAtError(error, steps) {
  const tolerances = list(steps).map((step) => step.tolerance);
  if (!isNumber(error) || tolerances.length === 0 || !tolerances.every(isNumber)) return null;
  const first = tolerances.findIndex((tolerance) => error > tolerance);
  return Math.min(3, first < 0 ? tolerances.length : first);
}

/// A tube's case in one mode against the true arm; null when it was not scored.
function scoredCase(tube, mode, steps) {
  const score = object(tube[mode]);
  if (!score) return null;
  return Number.isInteger(score.steps) ? Math.max(0, Math.min(3, score.steps)) : stepsAtError(score.error, steps);
}

/// The case that the plan expects: the likeliest by its probabilities, else by the predicted error; null where the plan
/// says that it has none, since nobody placed the base.
function predictedCase(tube, steps) {
  if (tube.probability_by_steps === null) return null;
  const chances = numbers(tube.probability_by_steps, 4);
  return chances ? chances.indexOf(Math.max(...chances)) : stepsAtError(tube.predicted_error, steps);
}

/// Tubes by case in one mode: from `counts` when given, else counted; null when nothing was scored.
function countsOf(report, mode) {
  const given = numbers(object(report.counts)?.[mode], 4);
  if (given) return given;
  const cases =
      list(report.tubes).map((tube) => scoredCase(tube, mode, report.steps)).filter((value) => value !== null);
  return cases.length === 0 ? null : CASES.map((_, index) => cases.filter((value) => value === index).length);
}
