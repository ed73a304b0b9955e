// What lies under the holes: the plate, the divider, the manway's direction, row and column ticks, leg and viewing side.
import type {Palette} from "../drawing/colours";
import {toPixel, type Camera, type Size} from "./sheet_camera";
import {legWords, type SheetModel, type Tick} from "./sheet_model";

type Context = CanvasRenderingContext2D;

export function drawGround(context: Context, sheet: SheetModel, camera: Camera, size: Size, palette: Palette): void {
  context.clearRect(0, 0, size.width, size.height);
  drawPlate(context, sheet, camera, size, palette);
  drawManway(context, sheet, camera, size, palette);
}

/** A disc, or for one leg the half of it on the leg's side of the divider. */
function drawPlate(context: Context, sheet: SheetModel, camera: Camera, size: Size, palette: Palette): void {
  const [x, y] = toPixel(camera, size, 0, 0);
  const r = sheet.radius * camera.scale;
  const isBelow = sheet.extent.top <= 0.25 * Math.abs(sheet.extent.bottom);
  context.beginPath();
  if (sheet.isOneLeg) context.arc(x, y, r, isBelow ? 0 : Math.PI, isBelow ? Math.PI : 2 * Math.PI);
  else context.arc(x, y, r, 0, 2 * Math.PI);
  context.closePath();
  context.fillStyle = palette.plate;
  context.fill();
  context.strokeStyle = palette.rim;
  context.lineWidth = 1;
  context.stroke();
  if (!sheet.isOneLeg) return;
  context.beginPath();
  context.moveTo(x - r, y);
  context.lineTo(x + r, y);
  context.lineWidth = 3;
  context.stroke();
  context.fillStyle = palette.muted;
  context.font = FONT;
  context.textAlign = "center";
  context.textBaseline = isBelow ? "bottom" : "top";
  context.fillText("divider plate", x, y + (isBelow ? -5 : 6));
}

/** The manway lies in the bowl under the plate: a door at the rim in its direction. */
function drawManway(context: Context, sheet: SheetModel, camera: Camera, size: Size, palette: Palette): void {
  if (!sheet.manway) return;
  const angle = Math.atan2(sheet.manway.v, sheet.manway.u);
  const r = sheet.radius * camera.scale;
  const [x, y] = toPixel(camera, size, 0, 0);
  context.beginPath();
  context.arc(x, y, r + 4, -angle - 0.12, -angle + 0.12);
  context.strokeStyle = palette.muted;
  context.lineWidth = 5;
  context.stroke();
  const px = x + (r + 12) * Math.cos(angle),
    py = y - (r + 12) * Math.sin(angle);
  context.fillStyle = palette.muted;
  context.font = FONT;
  context.textAlign = Math.cos(angle) > 0.3 ? "left" : Math.cos(angle) < -0.3 ? "right" : "center";
  context.textBaseline = "middle";
  context.fillText("manway", px, py);
}

const FONT = "500 11px 'IBM Plex Sans Variable', system-ui, sans-serif";

/** Ticks along the picture's edges, over whatever the sheet shows there, so that they stay in sight at every zoom. */
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
  for (const {value, place} of spaced(sheet.rowTicks, camera.scale)) {
    const y = toPixel(camera, size, 0, place)[1];
    if (y < 8 || y > size.height - 24) continue;
    context.fillText(String(value), 28, y);
    context.fillRect(31, y - 0.5, 4, 1);
  }
  context.textAlign = "center";
  for (const {value, place} of spaced(sheet.columnTicks, camera.scale)) {
    const x = toPixel(camera, size, place, 0)[0];
    if (x < 44 || x > size.width - 12) continue;
    context.fillText(String(value), x, size.height - 9);
    context.fillRect(x - 0.5, size.height - 20, 1, 4);
  }
  context.textAlign = "left";
  context.fillText(sheet.rowTicks.length > 0 ? "R\u2009/\u2009C" : "", 6, size.height - 9);
}

/** One, five, ten or more apart, so that labels have about 34 pixels each. */
function spaced(ticks: readonly Tick[], scale: number): Tick[] {
  if (ticks.length < 2) return [...ticks];
  const first = ticks[0],
    last = ticks[ticks.length - 1];
  const each = Math.abs((last.place - first.place) / (last.value - first.value)) * scale;
  const every = [1, 2, 5, 10, 20, 50, 100].find((step) => step * each >= 34) ?? 200;
  return ticks.filter(({value}) => value % every === 0 || (every > 1 && value === first.value && every <= 2));
}

export function sheetWords(sheet: SheetModel): string {
  const side = sheet.viewingSide === "above" ? "seen from above" : `seen from ${sheet.viewingSide || "below"}`;
  return [legWords(sheet.leg), side].filter((text) => text !== "").join(", ");
}
