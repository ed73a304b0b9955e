// Background of a tube sheet on a canvas: the plate, the divider, and the direction of the manway.
import {toPixel} from "./frames.js";

/** @typedef {import("./sheet_model.js").SheetModel} SheetModel */
/** @typedef {import("./frames.js").Camera} Camera */
/** @typedef {import("./frames.js").Size} Size */
/** @typedef {{plate: string, rim: string, muted: string}} GroundColours */

/**
 * @param {CanvasRenderingContext2D} context @param {SheetModel} sheet @param {Camera} camera @param {Size} size
 * @param {GroundColours} colours
 */
export function drawGround(context, sheet, camera, size, colours) {
  drawPlate(context, sheet, camera, size, colours);
  if (sheet.isOneLeg) drawDivider(context, sheet, camera, size, colours);
  if (sheet.manway) drawManway(context, sheet, camera, size, colours);
}

/**
 * @param {CanvasRenderingContext2D} context @param {SheetModel} sheet @param {Camera} camera @param {Size} size
 * @param {GroundColours} colours
 */
export function drawPlate(context, sheet, camera, size, colours) {
  const [x, y] = toPixel(camera, size, 0, 0);
  context.beginPath();
  const [from, to] = sheet.isOneLeg ? (sheet.isLower ? [0, Math.PI] : [Math.PI, 2 * Math.PI]) : [0, 2 * Math.PI];
  context.arc(x, y, sheet.radius * camera.scale, from, to);
  context.closePath();
  context.fillStyle = colours.plate;
  context.fill();
  context.strokeStyle = colours.rim;
  context.lineWidth = 1;
  context.stroke();
}

/**
 * @param {CanvasRenderingContext2D} context @param {SheetModel} sheet @param {Camera} camera @param {Size} size
 * @param {GroundColours} colours
 */
function drawDivider(context, sheet, camera, size, colours) {
  const [x, y] = toPixel(camera, size, 0, 0),
    r = sheet.radius * camera.scale;
  context.strokeStyle = colours.rim;
  context.lineWidth = 3;
  context.beginPath();
  context.moveTo(x - r, y);
  context.lineTo(x + r, y);
  context.stroke();
  context.fillStyle = colours.muted;
  context.textAlign = "center";
  context.textBaseline = sheet.isLower ? "bottom" : "top";
  context.fillText("divider plate", x, y + (sheet.isLower ? -5 : 6));
}

/**
 * Draws the manway, which lies in the bowl below the plate, as a door at the rim of the plate.
 * @param {CanvasRenderingContext2D} context @param {SheetModel} sheet @param {Camera} camera @param {Size} size
 * @param {GroundColours} colours
 */
function drawManway(context, sheet, camera, size, colours) {
  if (!sheet.manway) return;
  const angle = Math.atan2(sheet.manway.v, sheet.manway.u);
  const [x, y] = toPixel(camera, size, 0, 0),
    r = sheet.radius * camera.scale;
  context.beginPath();
  context.arc(x, y, r + 4, -angle - 0.12, -angle + 0.12);
  context.strokeStyle = colours.muted;
  context.lineWidth = 5;
  context.stroke();
  context.fillStyle = colours.muted;
  context.textAlign = Math.cos(angle) > 0.3 ? "left" : Math.cos(angle) < -0.3 ? "right" : "center";
  context.textBaseline = "middle";
  context.fillText("manway", x + (r + 12) * Math.cos(angle), y - (r + 12) * Math.sin(angle));
}
