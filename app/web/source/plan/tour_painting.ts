// The tour over the sheet: its path, a mark for each hole, holes out of reach, and the current position on the tour.
import {toPixel, type Camera, type Size} from "../../../drawing/frames.js";
import {UNREACHABLE} from "../../../drawing/kinds.js";
import {drawRings, strokeLine} from "../drawing/canvas";
import type {Palette} from "../drawing/colours";
import {drawMark, type Mark} from "../drawing/marks";
import type {Colouring} from "../sheet/colourings";
import type {SheetModel} from "../sheet/sheet_model";

interface Canvas {
  context: CanvasRenderingContext2D;
  camera: Camera;
  size: Size;
  colours: Palette;
}

interface Tour {
  model: SheetModel;
  colouring: Colouring;
  /** Indices of the holes in the order of visiting; -1 for a hole that the sheet does not have. */
  holes: readonly number[];
  /** Index of the current visit; -1 for none. */
  at: number;
  unreachable: readonly {row: number; column: number}[];
}

export function paintTour(canvas: Canvas, tour: Tour): void {
  const {model, colouring, holes, at} = tour;
  if (holes.length < 2) return;
  drawCourse(canvas, model, holes, canvas.colours.rim, 1);
  if (at >= 0) drawCourse(canvas, model, holes.slice(0, at + 1), canvas.colours.ink, 2);
  for (const hole of holes) if (hole >= 0) drawHoleMark(canvas, model, hole, colouring.kinds[colouring.of[hole]].mark);
  for (const tube of tour.unreachable) {
    const hole = model.find(tube.row, tube.column);
    if (hole >= 0) drawHoleMark(canvas, model, hole, UNREACHABLE);
  }
  if (holes[at] !== undefined) ringHole(canvas, model, holes[at]);
}

function placeOf({camera, size}: Canvas, model: SheetModel, hole: number): [number, number] {
  return toPixel(camera, size, model.u[hole], model.v[hole]);
}

function drawCourse(canvas: Canvas, model: SheetModel, holes: readonly number[], colour: string, width: number): void {
  Object.assign(canvas.context, {strokeStyle: colour, lineWidth: width});
  strokeLine(canvas.context, ...holes.map((hole) => placeOf(canvas, model, hole)));
}

function drawHoleMark(canvas: Canvas, model: SheetModel, hole: number, mark: Mark): void {
  const {context, colours} = canvas;
  context.strokeStyle = context.fillStyle = colours[mark.colour];
  const radius = Math.max(4.2, model.holeRadius * canvas.camera.scale);
  drawMark(context, mark.shape, ...placeOf(canvas, model, hole), radius);
}

function ringHole(canvas: Canvas, model: SheetModel, hole: number): void {
  const {context} = canvas;
  context.strokeStyle = canvas.colours.rose;
  context.lineWidth = 3;
  drawRings(context, [placeOf(canvas, model, hole)], 9);
}
