// The errors as arrows at the positions of the readings, painted on a canvas with or without the sheet.
import {clearedContext, strokeLine, TYPEFACE} from "../drawing/canvas";
import type {Palette} from "../drawing/colours";
import {drawArrow, usualLargest} from "../../../drawing/arrows.js";
import {extentOf, fit, toPixel, type Camera, type Size} from "../../../drawing/frames.js";
import {exact} from "../../../drawing/numbers.js";
import {inPlane, type Plane} from "../../../drawing/planes.js";
import type {ErrorPair} from "../../../drawing/reading_errors.js";
import {roundDown125} from "../../../drawing/scales.js";
import {isInShare, MOST_ARROWS} from "../../../drawing/shares.js";
import {drawPlate} from "../../../drawing/sheet_ground.js";
import type {SheetModel} from "../../../drawing/sheet_model.js";
import type {Vector3} from "../server/documents";

export interface ArrowsLook {
  errors: ErrorPair | null;
  plane: Plane;
  /** Unit of the errors. */
  unit: string;
  /** Sheet drawn under the arrows if the picture's plane is parallel to the sheet; null if the cell has no sheet. */
  sheet: SheetModel | null;
  /** Ids of readings whose arrows are always drawn, even if there are too many arrows. */
  picked?: ReadonlySet<string>;
  /** Index of the only series to draw; undefined draws all series, on a common scale. */
  only?: number;
}

/** Position of each reading on the screen [pixels]; null if unknown. */
export type PlacesOnScreen = ([number, number] | null)[];

/** Length on the screen of a large error that few readings exceed [pixels]. */
const LONG = 42;

/** Maximum length on the screen of the ruler for positions [pixels]. */
const LONGEST_RULER = 90;

/** Returns true if the plane is parallel to the sheet, that is, normal to the world's z axis. */
export function isOverSheet({axes}: Plane): boolean {
  return axes[0] === 0 && axes[1] === 1;
}

/** Draws the arrows. Returns the position of each reading on the canvas [pixels]. */
export function drawArrows(canvas: HTMLCanvasElement, look: ArrowsLook, colours: Palette): PlacesOnScreen {
  const {errors, plane: which, unit, sheet: onPlate, picked, only} = look;
  const {clientWidth: width, clientHeight: height} = canvas.parentElement!;
  const context = clearedContext(canvas, width, height),
    canvasOf = {context, colours, width, height};
  if (!errors || width < 40 || height < 40) return [];
  const places = errors.places.filter((place): place is Vector3 => place !== null);
  if (places.length === 0) return [];
  const onSheet = isOverSheet(which) ? onPlate : null;
  const frame = makeFrame(which, places, onSheet, {width, height});
  const largest = usualLargest(errors.series[0].errors.map((error) => (error ? Math.hypot(...error) : null)));
  const grow = largest > 0 ? LONG / largest : 0;
  if (onSheet) drawPlate(context, onSheet, frame.camera, frame.size, colours);
  drawAxes(canvasOf, which, frame.sign);
  const shown = errors.places.map((place) => (place ? frame.at(place) : null));
  const onScreen = (error: Vector3): [number, number] => {
    const [u, v] = inPlane(which, error);
    return [frame.sign * grow * u, -grow * v];
  };
  const {readings} = errors;
  const isShown = (i: number) => isInShare(i, readings.length, MOST_ARROWS) || (picked?.has(readings[i].id) ?? false);
  errors.series.forEach((series, k) => {
    if (only !== undefined && only !== k) return;
    context.strokeStyle = context.fillStyle = colours[series.mark.colour];
    context.lineWidth = 1.3;
    shown.forEach((at, i) => {
      const error = series.errors[i];
      if (at && error && isShown(i)) drawError(context, at, onScreen(error), k === 0);
    });
  });
  drawScale(canvasOf, unit, largest, grow);
  drawRuler(canvasOf, frame.camera.scale, unit);
  return shown;
}

/** Draws an error as a dot at the reading's position and an arrow, whose head is hollow before and filled after. */
function drawError(
  context: CanvasRenderingContext2D,
  at: [number, number],
  way: [number, number],
  isBefore: boolean,
): void {
  context.beginPath();
  context.arc(...at, 1.5, 0, 2 * Math.PI);
  context.fill();
  drawArrow(context, ...at, ...way, isBefore);
}

interface Frame {
  camera: Camera;
  size: Size;
  /** Sign of x: -1 if the sheet is seen from below, where +x points left, as in the sheet view. */
  sign: number;
  at: (place: Vector3) => [number, number];
}

const SHEET_MARGINS = {left: 12, right: 12, top: 12, bottom: 12};
const PLACES_MARGINS = {left: 45, right: 45, top: 30, bottom: 30};

/** Returns a frame that fits the positions of the readings, or the whole sheet if there is one. */
function makeFrame(which: Plane, places: Vector3[], onSheet: SheetModel | null, size: Size): Frame {
  const sign = onSheet?.viewingSide === "below" ? -1 : 1;
  const drawn = (place: Vector3): [number, number] => {
    const [u, v] = inPlane(which, place);
    return [sign * u, v];
  };
  const camera = fit(onSheet?.plate ?? extentOf(places.map(drawn)), size, onSheet ? SHEET_MARGINS : PLACES_MARGINS);
  return {camera, size, sign, at: (place) => toPixel(camera, size, ...drawn(place))};
}

const FONT = `11px ${TYPEFACE}`;

interface Canvas {
  context: CanvasRenderingContext2D;
  colours: Palette;
  width: number;
  height: number;
}

function drawAxes({context, colours, height}: Canvas, which: Plane, sign: number): void {
  const x = sign > 0 ? 16 : 46,
    y = height - 14;
  context.strokeStyle = context.fillStyle = colours.muted;
  context.lineWidth = 1;
  drawArrow(context, x, y, sign * 26, 0);
  drawArrow(context, x, y, 0, -26);
  context.font = FONT;
  context.fillText(which.key[0], sign > 0 ? x + 30 : x - 38, y + 4);
  context.fillText(which.key[1], x - 3, y - 31);
}

function drawScale({context, colours, width, height}: Canvas, unit: string, largest: number, grow: number): void {
  if (!(largest > 0)) return;
  const size = roundDown125(largest),
    long = size * grow;
  context.strokeStyle = context.fillStyle = colours.ink;
  drawArrow(context, width - 14 - long, height - 12, long, 0);
  context.font = FONT;
  context.textAlign = "right";
  context.fillText(`${exact(size)} ${unit}`, width - 14, height - 20);
  context.textAlign = "left";
}

/** Draws a ruler of round length for the positions, next to the axes. */
function drawRuler({context, height}: Canvas, scale: number, unit: string): void {
  const length = roundDown125(LONGEST_RULER / scale),
    x = 84,
    y = height - 12;
  const [from, to] = [x, x + length * scale];
  strokeLine(context, [from, y], [to, y]);
  for (const end of [from, to]) strokeLine(context, [end, y - 4], [end, y + 4]);
  context.fillText(`${exact(length)} ${unit}`, x, y - 8);
}
