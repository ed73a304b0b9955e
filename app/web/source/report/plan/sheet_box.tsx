// The sheet in a report: the workbench's sheet picture, over whose holes a section paints its own content.
import {useCallback, useMemo} from "preact/hooks";
import {drawArrow} from "../../../../drawing/arrows.js";
import {distance, toPixel, type Camera, type Size} from "../../../../drawing/frames.js";
import {stateMark} from "../../../../drawing/kinds.js";
import {isNumber} from "../../../../drawing/numbers.js";
import {makeSheetModel, type SheetModel} from "../../../../drawing/sheet_model.js";
import {TYPEFACE} from "../../drawing/canvas";
import type {Palette} from "../../drawing/colours";
import {drawMark, type Mark} from "../../drawing/marks";
import {byState, type Colouring} from "../../sheet/colourings";
import {MARGIN} from "../../sheet/sheet_camera";
import {SheetPicture} from "../../sheet/sheet_picture";
import {lengthUnit, numbers, object, type Report, textOf} from "../values";

export type Place = [number, number];

const signOf = (report: Report) => (object(report.sheet)?.viewed_from === "above" ? 1 : -1);

const known = new WeakMap<Report, SheetModel | null>();

/** Returns the model of the sheet, computed once for all sections; null if the report lists no holes. */
export function readSheet(report: Report): SheetModel | null {
  const made = known.has(report) ? known.get(report)! : makeSheet(report);
  known.set(report, made);
  return made;
}

function makeSheet(report: Report): SheetModel | null {
  const given = object(report.sheet) ?? {},
    sign = signOf(report);
  const holes = (Array.isArray(given.holes) ? given.holes : []).filter(
    (hole: unknown) => Array.isArray(hole) && isNumber(hole[2]) && isNumber(hole[3]),
  ) as [number, number, number, number, unknown][];
  if (holes.length === 0) return null;
  const words = object(given.state_words) ?? {},
    manway = numbers(given.manway, 2),
    of = holes.map((hole) => textOf(hole[4], "open")),
    states = [...new Set(of)];
  const [row, column, x, y] = [0, 1, 2, 3].map((k) => holes.map((hole) => hole[k] as number));
  return makeSheetModel({
    name: textOf(given.name, ""),
    pitch: given.pitch,
    hole_diameter: given.hole_diameter,
    leg: textOf(given.leg, ""),
    leg_words: textOf(given.leg_words, textOf(given.leg, "leg not recorded")),
    viewing_side: textOf(given.viewed_from, "below"),
    view_words: `${textOf(given.view_words, "")} (+x to the ${sign < 0 ? "left" : "right"})`.trim(),
    manway: manway ? {u: sign * manway[0], v: manway[1]} : null,
    holes: {
      ...{row, column, x, y, v: y},
      z: holes.map(() => 0),
      u: x.map((across) => sign * across),
      state: of.map((state) => states.indexOf(state)),
      states,
      state_words: states.map((state) => textOf(words[state], state)),
    },
  } as Parameters<typeof makeSheetModel>[0]);
}

/** Returns the name, mark and number of holes for each state other than open. */
export function stateGroups(sheet: SheetModel): {name: string; mark: Mark; count: number}[] {
  const {counts} = byState(sheet);
  return sheet.states.flatMap((state, k) =>
    state === "open" ? [] : [{name: sheet.stateWords[k], mark: stateMark(state), count: counts[k]}],
  );
}

/**
 * Canvas on which a section paints over the sheet: `at` maps a position on the sheet to pixels; `scale` is the number
 * of pixels per unit of length.
 */
export interface Painter {
  context: CanvasRenderingContext2D;
  at: (place: ArrayLike<number>) => Place;
  scale: number;
  size: Size;
  colours: Palette;
}

interface SheetBoxProps {
  report: Report;
  sheet: SheetModel;
  label: string;
  describe: (row: number, column: number) => string[];
  paint: (painter: Painter) => void;
  /** True if the holes are drawn faintly behind the section's painting. */
  isFaint?: boolean;
}

export function SheetBox({report, sheet, label, describe, paint, isFaint = false}: SheetBoxProps) {
  const colouring = useMemo<Colouring>(() => {
    const states = byState(sheet),
      words = (hole: number) => describe(sheet.row[hole], sheet.column[hole]);
    const kinds = isFaint ? states.kinds.map((kind) => ({...kind, mark: FAINT})) : states.kinds;
    return {...states, kinds, words};
  }, [sheet, describe, isFaint]);
  const paintOver = useCallback(
    (context: CanvasRenderingContext2D, camera: Camera, size: Size, colours: Palette) => {
      const sign = signOf(report);
      const at = (place: ArrayLike<number>) => toPixel(camera, size, sign * place[0], place[1]);
      context.font = FONT;
      paint({context, at, scale: camera.scale, size, colours});
      drawAxes(context, sign, size, colours);
    },
    [report, paint],
  );
  const {left, right, top, bottom} = sheet.plate,
    tall = `calc((100% - ${MARGIN.left + MARGIN.right}px) * ${(top - bottom) / (right - left)} + ${MARGIN.top + MARGIN.bottom}px)`;
  return (
    <div class="sheet-box" role="img" aria-label={label} style={{paddingBottom: tall}}>
      <SheetPicture sheet={sheet} unit={lengthUnit(report)} colouring={colouring} paintOver={paintOver} isInText />
    </div>
  );
}

const FAINT: Mark = {shape: "ring", colour: "faint"};
const FONT = `11px ${TYPEFACE}`;

/** Draws the x and y axes in a corner outside the round sheet. */
function drawAxes(context: CanvasRenderingContext2D, sign: number, size: Size, colours: Palette): void {
  const x = size.width - 24 - (sign > 0 ? 26 : 0),
    y = size.height - 24;
  context.fillStyle = context.strokeStyle = colours.muted;
  context.lineWidth = 1.2;
  drawArrow(context, x, y, 20 * sign, 0);
  drawArrow(context, x, y, 0, -16);
  context.textBaseline = "middle";
  context.textAlign = sign > 0 ? "left" : "right";
  context.fillText("x", x + 23 * sign, y);
  context.textAlign = "center";
  context.fillText("y", x + 9 * sign, y - 14);
}

/** Paints equal marks at positions on the sheet. */
export function paintMarks(
  {context, at, colours}: Painter,
  mark: Mark,
  places: readonly Place[],
  radius: number,
): void {
  context.fillStyle = context.strokeStyle = colours[mark.colour];
  for (const place of places) drawMark(context, mark.shape, ...at(place), radius);
}

/** Equal marks with their name and positions. */
export interface MarkGroup {
  mark: Mark;
  name: string;
  places: Place[];
}

/** Paints all groups whose names are not in `hidden`, with the largest mark size that fits all of them. */
export function paintGroups(painter: Painter, groups: readonly MarkGroup[], hidden: ReadonlySet<string> = new Set()) {
  const radius = markRadius(
    painter,
    groups.flatMap(({places}) => places),
  );
  for (const {mark, name, places} of groups) if (!hidden.has(name)) paintMarks(painter, mark, places, radius);
}

/** Paints an arrow between two points in pixels, in a single colour. */
export function paintArrow(
  context: CanvasRenderingContext2D,
  from: Place,
  to: Place,
  colour: string,
  width = 1.6,
): void {
  context.strokeStyle = context.fillStyle = colour;
  context.lineWidth = width;
  drawArrow(context, from[0], from[1], to[0] - from[0], to[1] - from[1], false, 5 + width);
}

/** Paints a short label next to a point in pixels, on a background. */
export function paintTag({context, size, colours}: Painter, text: string, [x, y]: Place, isStrong = false): void {
  context.font = isStrong ? `bold ${FONT}` : FONT;
  const wide = context.measureText(text).width;
  const left = x + 7 + wide > size.width - 2 ? x - 7 - wide : x + 7;
  context.globalAlpha = 0.82;
  context.fillStyle = colours.panel;
  context.fillRect(left - 2, y - 15, wide + 4, 13);
  context.globalAlpha = 1;
  context.fillStyle = colours.ink;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(text, left, y - 8);
  context.font = FONT;
}

/**
 * Returns a radius in pixels for marks at these positions, limited by the distance of nearest neighbours and by
 * `largest`.
 */
export function markRadius({at}: Painter, places: readonly Place[], largest = 5.5): number {
  if (places.length < 2) return largest;
  const sorted = places.map(at).sort((a, b) => a[0] - b[0]);
  const nearest = sorted.map((_, i) => nearestDistance(sorted, i, 2.4 * largest)).sort((a, b) => a - b);
  return Math.max(1.6, Math.min(largest, 0.46 * nearest[Math.floor(0.1 * nearest.length)]));
}

/**
 * Returns the distance from position `index` to its nearest neighbour, or `limit` if none is nearer; positions are
 * sorted by x.
 */
function nearestDistance(sorted: readonly Place[], index: number, limit: number): number {
  let best = limit;
  for (const step of [-1, 1])
    for (let i = index + step; sorted[i] && Math.abs(sorted[i][0] - sorted[index][0]) < best; i += step)
      best = Math.min(best, distance(sorted[i], sorted[index]));
  return best;
}
