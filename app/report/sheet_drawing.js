// A sharp canvas with a sheet: its plate and manway, holes with their states, numbers of rows and columns, axes.
import {drawArrow} from "../drawing/arrows.js";
import {toPixel} from "../drawing/frames.js";
import {stateMark} from "../drawing/kinds.js";
import {drawGround} from "../drawing/sheet_ground.js";
import {spacedTicks} from "../drawing/sheet_model.js";
import {colour, el} from "./elements.js";
import {drawMarks} from "./mark_drawing.js";
import {sheetFrame} from "./sheet_frame.js";

export const FONT = "11px system-ui, sans-serif";

/// A canvas of this size in CSS pixels, with at least two device pixels each so that it prints sharply.
function sharpCanvas(width, height) {
  const ratio = Math.max(2, window.devicePixelRatio || 1);
  const canvas = el("canvas", {width: Math.round(width * ratio), height: Math.round(height * ratio)});
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  context.font = FONT;
  return {canvas, context};
}

/// Returns {canvas, context, frame}; `faint` holes without their states are what else is drawn on.
export function drawSheet(sheet, width, {faint = false} = {}) {
  const frame = sheetFrame(sheet, width);
  const {canvas, context} = sharpCanvas(width, frame.height);
  const colours = {plate: colour("plate"), rim: colour("rim"), muted: colour("muted")};
  drawGround(context, sheet.model, frame.camera, frame.size, colours);
  drawHoles(context, sheet, frame, faint);
  drawNumbers(context, sheet, frame);
  drawAxes(context, sheet, frame);
  return {canvas, context, frame};
}

function drawHoles(context, sheet, frame, faint) {
  const radius = Math.max(0.9, sheet.model.holeRadius * frame.scale);
  context.beginPath();
  for (const hole of sheet.holes) {
    const [x, y] = frame.place([hole.x, hole.y]);
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.strokeStyle = colour(faint ? "faint" : "hole");
  context.lineWidth = Math.min(0.9, 0.4 * radius);
  context.stroke();
  if (faint) return;
  for (const {mark, holes} of stateGroups(sheet))
    drawMarks(context, mark, holes.map((hole) => frame.place([hole.x, hole.y])), Math.max(2.2, radius));
}

/// The holes of each state that needs a mark: [{state, name, mark, holes}].
export function stateGroups({model, holes}) {
  return model.states
      .map((state, k) => ({
             state,
             name: model.stateWords[k],
             mark: stateMark(state),
             holes: holes.filter((_, i) => model.state[i] === k)
           }))
      .filter(({state}) => state !== "open");
}

/// What a hole's state is in words; null where it is open.
export function stateText({model}, hole) {
  const k = model.states.indexOf(hole.state);
  return k < 0 || hole.state === "open" ? null : `State: ${model.stateWords[k]}`;
}

/// Numbers of rows at the left, of columns where the sheet has no divider.
function drawNumbers(context, {model}, frame) {
  const edge = frame.isAbove ? 18 : frame.height - 18;
  const side = frame.margin.left - 4, outward = frame.isAbove ? -1 : 1;
  context.fillStyle = context.strokeStyle = colour("muted");
  context.lineWidth = 1;
  context.beginPath();
  context.textAlign = "center";
  context.textBaseline = frame.isAbove ? "bottom" : "top";
  for (const {value, place} of spacedTicks(model.columnTicks, frame.scale)) {
    const [x] = toPixel(frame.camera, frame.size, place, 0);
    context.moveTo(x, edge);
    context.lineTo(x, edge + 4 * outward);
    context.fillText(`C${value}`, x, edge + 6 * outward);
  }
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const {value, place} of spacedTicks(model.rowTicks, frame.scale)) {
    const [, y] = toPixel(frame.camera, frame.size, 0, place);
    context.moveTo(side, y);
    context.lineTo(side - 4, y);
    context.fillText(`R${value}`, side - 6, y);
  }
  context.stroke();
}

/// The directions of x and y in a corner that the round sheet leaves free.
function drawAxes(context, {sign}, frame) {
  const x = frame.width - 22, y = frame.isAbove ? frame.height - 12 : 44;
  const start = sign > 0 ? x - 26 : x;
  context.fillStyle = context.strokeStyle = colour("muted");
  context.lineWidth = 1.2;
  drawArrow(context, start, y, 26 * sign, 0);
  drawArrow(context, start, y, 0, -26);
  context.textBaseline = "middle";
  context.textAlign = sign > 0 ? "left" : "right";
  context.fillText("x", start + 29 * sign, y);
  context.textAlign = "center";
  context.fillText("y", start, y - 32);
}

/// An arrow between two places in pixels, in one colour.
export function drawArrowTo(context, from, to, paint, lineWidth = 1.6) {
  context.strokeStyle = context.fillStyle = paint;
  context.lineWidth = lineWidth;
  drawArrow(context, from[0], from[1], to[0] - from[0], to[1] - from[1], false, 5 + lineWidth);
}
