// ---- sheet_frame.js: from the sheet's coordinates to the picture's pixels, and the sheet's rows and columns.

/// What every picture of one sheet shares: its holes as objects, its extent, its numbering. Null without holes.
function readSheet(report) {
  const sheet = object(report.sheet);
  const holes = (Array.isArray(sheet?.holes) ? sheet.holes : [])
                    .filter((hole) => Array.isArray(hole) && isNumber(hole[2]) && isNumber(hole[3]))
                    .map(([row, column, x, y, state]) => ({row, column, x, y, state}));
  if (holes.length === 0) return null;
  const extent = extentOf(holes.map((hole) => [hole.x, hole.y]));
  const pitch =
      isNumber(sheet.pitch) && sheet.pitch > 0 ? sheet.pitch : (extent.right - extent.left) / Math.sqrt(holes.length);
  const diameter = isNumber(sheet.hole_diameter) && sheet.hole_diameter > 0 ? sheet.hole_diameter : 0.7 * pitch;
  const oneLeg = extent.bottom >= 0 || extent.top <= 0;
  if (oneLeg) {
    // The divider plate lies at y = 0: keep it in the picture.
    extent.bottom = Math.min(extent.bottom, 0);
    extent.top = Math.max(extent.top, 0);
  }
  return {
    holes,
    extent,
    pitch,
    diameter,
    oneLeg,
    fromBelow: sheet.viewed_from !== "above",
    leg: sheet.leg,
    manway: Array.isArray(sheet.manway) && sheet.manway.every(isNumber) ? sheet.manway : null,
    rows: ticksOf(holes, "row", "y", pitch),
    columns: ticksOf(holes, "column", "x", pitch),
    find: holeFinder(holes)
  };
}

function extentOf(places) {
  const extent = {left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
  for (const [x, y] of places) {
    extent.left = Math.min(extent.left, x);
    extent.right = Math.max(extent.right, x);
    extent.bottom = Math.min(extent.bottom, y);
    extent.top = Math.max(extent.top, y);
  }
  return extent;
}

/// Every tenth row or column with its place; none where one number is not one place (tubes numbered within each row).
function ticksOf(holes, number, coordinate, pitch) {
  const places = new Map();
  for (const hole of holes) {
    const known = places.get(hole[number]);
    if (known === undefined)
      places.set(hole[number], hole[coordinate]);
    else if (Math.abs(known - hole[coordinate]) > 0.1 * pitch)
      return [];
  }
  const every = places.size > 200 ? 50 : places.size > 130 ? 20 : 10;
  return [...places].filter(([value]) => value % every === 0).map(([value, place]) => ({value, place}));
}

function holeFinder(holes) {
  const byName = new Map(holes.map((hole) => [`${hole.row} ${hole.column}`, hole]));
  return (row, column) => byName.get(`${row} ${column}`) ?? null;
}

function legName(sheet) {
  const names = {hot: "hot leg", cold: "cold leg", full: "full sheet"};
  return names[sheet.leg] ?? textOf(sheet.leg, "leg not recorded");
}

/// "hot leg, seen from below (+x to the left)".
function viewName(sheet) {
  return sheet.fromBelow ? `${legName(sheet)}, seen from below (+x to the left)` :
                           `${legName(sheet)}, seen from above (+x to the right)`;
}

const MARGIN = {
  left: 40,
  right: 26,
  top: 24,
  bottom: 34
};

/// The scale and place of the sheet in a picture `width` pixels wide. Seen from below with +y up, +x points left.
function sheetFrame(sheet, width) {
  const {left, right, bottom, top} = sheet.extent;
  const rim = 0.8 * sheet.pitch;
  const scale = (width - MARGIN.left - MARGIN.right) / (right - left + 2 * rim);
  const margin = {...MARGIN};
  if (top <= 0) [margin.top, margin.bottom] = [MARGIN.bottom, MARGIN.top];
  const sign = sheet.fromBelow ? -1 : 1;
  const middle = MARGIN.left + (width - MARGIN.left - MARGIN.right) / 2;
  return {
    width,
    scale,
    sign,
    margin,
    height: margin.top + margin.bottom + scale * (top - bottom + 2 * rim),
    x: (x) => middle + sign * scale * (x - (left + right) / 2),
    y: (y) => margin.top + scale * (top + rim - y),
    place(point) {
      return [this.x(point[0]), this.y(point[1])];
    },
    /// The sheet's point under a pixel.
    point: (px, py) => [(left + right) / 2 + sign * (px - middle) / scale, top + rim - (py - margin.top) / scale],
  };
}

/// A radius in pixels for marks at these places: as large as their nearest neighbours allow, within reason.
function markRadius(places, largest = 5.5) {
  if (places.length < 2) return largest;
  const sorted = [...places].sort((a, b) => a[0] - b[0]);
  const nearest = sorted.map((place, i) => nearestDistance(sorted, i, 2.4 * largest)).sort((a, b) => a - b);
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
