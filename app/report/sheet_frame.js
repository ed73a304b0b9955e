// The sheet of a report: its model, and the frame from its coordinates to a picture's pixels.
import {distance, fit, heightFor, toPixel} from "../drawing/frames.js";
import {isNumber} from "../drawing/numbers.js";
import {makeSheetModel} from "../drawing/sheet_model.js";
import {numbers, object, textOf} from "./values.js";

/// What every picture of one sheet shares: the model, its holes as objects, the side that it is seen from. Null without
/// holes.
export function readSheet(report) {
  const given = object(report.sheet);
  const holes = (Array.isArray(given?.holes) ? given.holes : [])
                    .filter((hole) => Array.isArray(hole) && isNumber(hole[2]) && isNumber(hole[3]))
                    .map(([row, column, x, y, state]) => ({row, column, x, y, state}));
  if (holes.length === 0) return null;
  const sign = given.viewed_from === "above" ? 1 : -1, words = object(given.state_words) ?? {};
  const manway = numbers(given.manway, 2);
  const states = [...new Set(holes.map((hole) => textOf(hole.state, "open")))];
  const model = makeSheetModel({
    name: textOf(given.name, ""),
    pitch: given.pitch,
    hole_diameter: given.hole_diameter,
    leg: textOf(given.leg, ""),
    leg_words: textOf(given.leg_words, textOf(given.leg, "leg not recorded")),
    viewing_side: textOf(given.viewed_from, "below"),
    view_words: `${textOf(given.view_words, "")} (+x to the ${sign < 0 ? "left" : "right"})`.trim(),
    manway: manway ? {u: sign * manway[0], v: manway[1]} : null,
    holes: {
      row: holes.map((hole) => hole.row),
      column: holes.map((hole) => hole.column),
      x: holes.map((hole) => hole.x),
      y: holes.map((hole) => hole.y),
      z: holes.map(() => 0),
      u: holes.map((hole) => sign * hole.x),
      v: holes.map((hole) => hole.y),
      state: holes.map((hole) => states.indexOf(textOf(hole.state, "open"))),
      states,
      state_words: states.map((state) => textOf(words[state], state))
    }
  });
  return {model, holes, sign, width: model.extent.right - model.extent.left};
}

const SHEET_MARGIN = {left: 40, right: 26, top: 24, bottom: 40};

/// Room for the numbers of the columns: above a sheet whose holes lie below the divider plate.
function marginOf({model}) {
  const {top, bottom} = SHEET_MARGIN;
  return model.isOneLeg && model.isLower ? {...SHEET_MARGIN, top: bottom, bottom: top} : SHEET_MARGIN;
}

/// The sheet in a picture `width` pixels wide.
export function sheetFrame(sheet, width) {
  const margin = marginOf(sheet), {plate} = sheet.model;
  const size = {width, height: heightFor(plate, width, margin)};
  const camera = fit(plate, size, margin);
  return {
    ...size,
    size,
    camera,
    margin,
    scale: camera.scale,
    isAbove: margin.top > margin.bottom,
    /// The pixels of a place in the sheet's own coordinates, +x as the sheet has it.
    place: ([x, y]) => toPixel(camera, size, sheet.sign * x, y),
    /// The hole under a pixel, or null.
    holeAt: (px, py) => {
      const index = sheet.model.nearest(...fromPixel(camera, size, px, py), 0.75 * sheet.model.pitch);
      return index < 0 ? null : sheet.holes[index];
    },
  };
}

/// A radius in pixels for marks at these places: as large as their nearest neighbours allow, within reason.
export function markRadius(places, largest = 5.5) {
  if (places.length < 2) return largest;
  const sorted = [...places].sort((a, b) => a[0] - b[0]);
  const nearest = sorted.map((_, i) => nearestDistance(sorted, i, 2.4 * largest)).sort((a, b) => a - b);
  return Math.max(1.6, Math.min(largest, 0.46 * nearest[Math.floor(0.1 * nearest.length)]));
}

/// The distance to the nearest other place, or `limit` if none is nearer; places are sorted by x.
function nearestDistance(sorted, index, limit) {
  let best = limit;
  for (const step of [-1, 1]) {
    for (let i = index + step; i >= 0 && i < sorted.length && Math.abs(sorted[i][0] - sorted[index][0]) < best;
         i += step) {
      best = Math.min(best, distance(sorted[i], sorted[index]));
    }
  }
  return best;
}
