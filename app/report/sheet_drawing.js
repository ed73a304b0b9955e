// ---- sheet_drawing.js: a sharp canvas with the sheet's holes, numbering, divider plate and manway.

const FONT = "11px system-ui, sans-serif";

/// A canvas of this size in CSS pixels, with at least two device pixels each so that it prints sharply.
function sharpCanvas(width, height) {
  const ratio = Math.max(2, window.devicePixelRatio || 1);
  const canvas = el("canvas", {width: Math.round(width * ratio), height: Math.round(height * ratio)});
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  context.font = FONT;
  return {canvas, context};
}

/// The canvas of a sheet: all holes, their states, row and column ticks, divider plate, manway and axes. Returns {canvas,
/// context, frame}.
function drawSheet(sheet, width, {faint = false} = {}) {
  const frame = sheetFrame(sheet, width);
  const {canvas, context} = sharpCanvas(width, frame.height);
  drawHoles(context, sheet, frame, faint);
  drawTicks(context, sheet, frame);
  if (sheet.oneLeg) drawDivider(context, sheet, frame);
  if (sheet.manway) drawManway(context, sheet, frame);
  drawAxes(context, sheet, frame);
  return {canvas, context, frame};
}

function drawHoles(context, sheet, frame, faint) {
  const radius = Math.max(0.9, 0.5 * sheet.diameter * frame.scale);
  context.beginPath();
  for (const hole of sheet.holes) {
    const x = frame.x(hole.x), y = frame.y(hole.y);
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.strokeStyle = colour(faint ? "faint-hole" : "hole");
  context.lineWidth = Math.min(0.9, 0.4 * radius);
  context.stroke();
  if (!faint) drawStates(context, sheet, frame, radius);
}

function drawStates(context, sheet, frame, radius) {
  for (const [state, holes] of holesByState(sheet)) {
    drawMarks(context, stateMark(state), holes.map((hole) => frame.place([hole.x, hole.y])), Math.max(2.2, radius));
  }
}

/// Holes with a state that needs a mark, by the state's name.
function holesByState(sheet) {
  const groups = new Map();
  for (const hole of sheet.holes) {
    if (!stateMark(hole.state)) continue;
    if (!groups.has(hole.state)) groups.set(hole.state, []);
    groups.get(hole.state).push(hole);
  }
  return groups;
}

function drawTicks(context, sheet, frame) {
  const above = frame.margin.top > frame.margin.bottom;
  const edge = above ? frame.y(sheet.extent.top) - 3 : frame.y(sheet.extent.bottom) + 3;
  const side = MARGIN.left - 4;
  context.fillStyle = context.strokeStyle = colour("muted");
  context.lineWidth = 1;
  context.beginPath();
  context.textAlign = "center";
  context.textBaseline = above ? "bottom" : "top";
  for (const {value, place} of sheet.columns) {
    const x = frame.x(place), outward = above ? -1 : 1;
    context.moveTo(x, edge);
    context.lineTo(x, edge + 4 * outward);
    context.fillText(`C${value}`, x, edge + 6 * outward);
  }
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const {value, place} of sheet.rows) {
    context.moveTo(side, frame.y(place));
    context.lineTo(side - 4, frame.y(place));
    context.fillText(`R${value}`, side - 6, frame.y(place));
  }
  context.stroke();
}

function drawDivider(context, sheet, frame) {
  const y = frame.y(0);
  const above = frame.margin.top > frame.margin.bottom;
  context.strokeStyle = colour("ink");
  context.lineWidth = 2.5;
  context.beginPath();
  context.moveTo(MARGIN.left - 4, y);
  context.lineTo(frame.width - MARGIN.right + 4, y);
  context.stroke();
  context.fillStyle = colour("ink");
  context.textAlign = "center";
  context.textBaseline = above ? "top" : "bottom";
  context.fillText("divider plate", frame.width / 2, above ? 1 : frame.height - 1);
}

/// A door outside the rim, in the direction in which the manway lies from the sheet's middle.
function drawManway(context, sheet, frame) {
  const angle = Math.atan2(-sheet.manway[1], frame.sign * sheet.manway[0]);
  const rim = frame.scale * Math.max(...sheet.holes.map((hole) => Math.hypot(hole.x, hole.y))) + 8;
  const [x, y] = frame.place([0, 0]);
  context.strokeStyle = context.fillStyle = colour("muted");
  context.lineWidth = 4;
  context.beginPath();
  context.arc(x, y, rim, angle - 0.1, angle + 0.1);
  context.stroke();
  context.textAlign = Math.cos(angle) > 0.3 ? "left" : Math.cos(angle) < -0.3 ? "right" : "center";
  context.textBaseline = "middle";
  context.fillText("manway", x + (rim + 7) * Math.cos(angle), y + (rim + 7) * Math.sin(angle));
}

/// The directions of x and y in a corner that the round sheet leaves free.
function drawAxes(context, sheet, frame) {
  const x = frame.width - 22, y = frame.margin.top > frame.margin.bottom ? frame.height - 12 : 44;
  const start = frame.sign > 0 ? x - 26 : x;
  drawArrow(context, [start, y], [start + 26 * frame.sign, y], colour("muted"), 1.2);
  drawArrow(context, [start, y], [start, y - 26], colour("muted"), 1.2);
  context.fillStyle = colour("muted");
  context.textBaseline = "middle";
  context.textAlign = frame.sign > 0 ? "left" : "right";
  context.fillText("x", start + 29 * frame.sign, y);
  context.textAlign = "center";
  context.fillText("y", start, y - 32);
}

/// An arrow in pixels; its head never exceeds its length.
function drawArrow(context, from, to, paint, lineWidth = 1.6) {
  const length = distance(from, to);
  if (length < 0.3) return;
  const head = Math.min(5 + lineWidth, 0.8 * length);
  const [ux, uy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const neck = [to[0] - head * ux, to[1] - head * uy];
  context.strokeStyle = context.fillStyle = paint;
  context.lineWidth = lineWidth;
  context.beginPath();
  context.moveTo(from[0], from[1]);
  context.lineTo(neck[0], neck[1]);
  context.stroke();
  context.beginPath();
  context.moveTo(to[0], to[1]);
  context.lineTo(neck[0] - 0.42 * head * uy, neck[1] + 0.42 * head * ux);
  context.lineTo(neck[0] + 0.42 * head * uy, neck[1] - 0.42 * head * ux);
  context.closePath();
  context.fill();
}
