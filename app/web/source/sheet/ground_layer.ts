// Background of the sheet picture, and the row and column numbers along its edges.
import {TYPEFACE} from "../drawing/canvas";
import type {Palette} from "../drawing/colours";
import {toPixel, type Camera, type Size} from "../../../drawing/frames.js";
import {drawGround as paintGround} from "../../../drawing/sheet_ground.js";
import {spacedTicks, type SheetModel} from "../../../drawing/sheet_model.js";

type Context = CanvasRenderingContext2D;

export function drawGround(context: Context, sheet: SheetModel, camera: Camera, size: Size, palette: Palette): void {
  context.clearRect(0, 0, size.width, size.height);
  context.font = FONT;
  paintGround(context, sheet, camera, size, palette);
}

const FONT = `500 11px ${TYPEFACE}`;

/** Draws ticks along the edges of the picture, over the sheet, so that they are visible at every zoom. */
export function drawTicks(context: Context, sheet: SheetModel, camera: Camera, size: Size, palette: Palette): void {
  context.font = FONT;
  context.fillStyle = palette.panel;
  context.globalAlpha = 0.94;
  context.fillRect(0, size.height - 20, size.width, 20);
  context.fillRect(0, 0, 34, size.height);
  context.globalAlpha = 1;
  context.fillStyle = palette.muted;
  context.strokeStyle = palette.line;
  context.textBaseline = "middle";
  context.textAlign = "right";
  for (const {value, place} of spacedTicks(sheet.rowTicks, camera.scale)) {
    const y = toPixel(camera, size, 0, place)[1];
    if (y < 8 || y > size.height - 24) continue;
    context.fillText(String(value), 28, y);
    context.fillRect(31, y - 0.5, 4, 1);
  }
  context.textAlign = "center";
  for (const {value, place} of spacedTicks(sheet.columnTicks, camera.scale)) {
    const x = toPixel(camera, size, place, 0)[0];
    if (x < 44 || x > size.width - 12) continue;
    context.fillText(String(value), x, size.height - 9);
    context.fillRect(x - 0.5, size.height - 20, 1, 4);
  }
  context.textAlign = "left";
  context.fillText(sheet.rowTicks.length > 0 ? "R\u2009/\u2009C" : "", 6, size.height - 9);
}
