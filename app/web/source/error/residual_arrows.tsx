// The errors as arrows at the readings' places: over the sheet where the cell has one, else in plan or from a side.
import {Segments} from "../drawing/segments";
import {effect as follow, signal} from "@preact/signals";
import type {RefObject} from "preact";
import {useEffect, useRef} from "preact/hooks";
import {clearedContext, drawRings, TYPEFACE} from "../drawing/canvas";
import {palette, type Palette} from "../drawing/colours";
import {followLasso, isInside} from "../drawing/lasso";
import {drawArrow, usualLargest} from "../../../drawing/arrows.js";
import {extentOf, fit, nearestPlace, toPixel, type Camera, type Size} from "../../../drawing/frames.js";
import {exact} from "../../../drawing/numbers.js";
import {inPlane, PLANES, type Plane} from "../../../drawing/planes.js";
import {roundDown125} from "../../../drawing/scales.js";
import {isInShare, MOST_ARROWS} from "../../../drawing/shares.js";
import type {Vector3} from "../server/documents";
import {units} from "../server/workbench";
import {sheet} from "../shell/page_state";
import {drawPlate} from "../../../drawing/sheet_ground.js";
import type {SheetModel} from "../../../drawing/sheet_model.js";
import {readingErrors, type ReadingErrors} from "./residuals";
import {SELECTED_RADIUS, selectReadings, selectedReadings, pointed} from "./linked";
import {SeriesLegend} from "./series_legend";
import {showReading} from "./show_reading";

const plane = signal<Plane>(PLANES[0]);

/** The length on screen of an error that few are beyond, in pixels. */
const LONG = 42;

/** The sheet lies across the world's z. */
function isOverSheet({axes}: Plane): boolean {
  return axes[0] === 0 && axes[1] === 1;
}

export function PlaneChoice() {
  return (
    <Segments
      label="Seen"
      value={plane.value.key}
      onChoose={(next) => (plane.value = PLANES.find(({key}) => key === next)!)}
      choices={PLANES.map((entry) => ({
        value: entry.key,
        words: isOverSheet(entry) && sheet.value?.viewingSide === "below" ? "from below" : entry.words,
      }))}
    />
  );
}

/** Within so many pixels a place is pointed at. */
const NEAR = 12;

type PlacesOnScreen = ([number, number] | null)[];

export function ResidualArrows() {
  const canvas = useRef<HTMLCanvasElement>(null),
    ring = useRef<HTMLElement>(null);
  const errors = readingErrors.value;
  const places = useDrawnArrows(canvas, errors);
  useLassoOnArrows(canvas, places, errors);
  useRingAtPointed(ring, places, errors);
  const pointAt = (event: PointerEvent) => {
    const index = nearestPlace(places.current, event.offsetX, event.offsetY, NEAR);
    pointed.value = index < 0 ? "" : (errors?.readings[index]?.id ?? "");
  };
  return (
    <div class="panel-body flush with-legend">
      <div class="fill">
        <canvas
          ref={canvas}
          role="img"
          aria-label={`Errors of ${errors?.readings.length ?? 0} readings as arrows at their places`}
          onPointerMove={pointAt}
          onPointerLeave={() => (pointed.value = "")}
          onClick={() => pointed.value !== "" && showReading(pointed.value)}
        />
        <i class="point-ring" ref={ring} hidden />
      </div>
      <SeriesLegend errors={errors} most={MOST_ARROWS} />
    </div>
  );
}

/** Draws the arrows with every change and at every size; where the readings' places are, in pixels. */
function useDrawnArrows(canvas: RefObject<HTMLCanvasElement>, errors: ReadingErrors | null) {
  const places = useRef<PlacesOnScreen>([]);
  useEffect(() => {
    const element = canvas.current!;
    const draw = () => {
      places.current = drawArrows(element, errors, plane.value, palette.value);
      drawPicked(element, errors, places.current, palette.value);
    };
    const observer = new ResizeObserver(draw);
    observer.observe(element.parentElement!);
    draw();
    return () => observer.disconnect();
  }, [errors, plane.value, palette.value, sheet.value, units.value, selectedReadings.value]);
  return places;
}

/** A loop about places selects their readings. */
function useLassoOnArrows(
  canvas: RefObject<HTMLCanvasElement>,
  places: {current: PlacesOnScreen},
  errors: ReadingErrors | null,
): void {
  useEffect(() => {
    const element = canvas.current!;
    return followLasso(element, element.parentElement!, (loop, isMore) =>
      selectReadings(
        (errors?.readings ?? []).flatMap(({id}, i) => {
          const place = places.current[i];
          return place && isInside(loop, ...place) ? [id] : [];
        }),
        isMore,
      ),
    );
  }, [errors]);
}

function useRingAtPointed(
  ring: RefObject<HTMLElement>,
  places: {current: PlacesOnScreen},
  errors: ReadingErrors | null,
): void {
  useEffect(
    () =>
      follow(() => {
        const index = pointed.value === "" ? -1 : (errors?.readings.findIndex(({id}) => id === pointed.value) ?? -1);
        const at = places.current[index];
        ring.current!.hidden = !at;
        if (at) ring.current!.style.transform = `translate(${at[0]}px, ${at[1]}px)`;
      }),
    [errors],
  );
}

/** Readings that are selected have a ring. */
function drawPicked(
  canvas: HTMLCanvasElement,
  errors: ReadingErrors | null,
  places: PlacesOnScreen,
  colours: Palette,
): void {
  const context = canvas.getContext("2d")!;
  context.strokeStyle = colours.ink;
  context.lineWidth = 1;
  const picked = (errors?.readings ?? []).flatMap(({id}, i) => {
    const place = selectedReadings.peek().has(id) ? places[i] : null;
    return place ? [place] : [];
  });
  drawRings(context, picked, SELECTED_RADIUS);
}

/** Draws them; where each reading's place is, in pixels. */
function drawArrows(
  canvas: HTMLCanvasElement,
  errors: ReadingErrors | null,
  which: Plane,
  colours: Palette,
): PlacesOnScreen {
  const {clientWidth: width, clientHeight: height} = canvas.parentElement!;
  const context = clearedContext(canvas, width, height);
  if (!errors || width < 40 || height < 40) return [];
  const places = errors.places.filter((place): place is Vector3 => place !== null);
  if (places.length === 0) return [];
  const onSheet = isOverSheet(which) ? sheet.peek() : null;
  const frame = makeFrame(which, places, onSheet, {width, height});
  const largest = usualLargest(errors.series[0].errors.map((error) => (error ? Math.hypot(...error) : null)));
  const grow = largest > 0 ? LONG / largest : 0;
  if (onSheet) drawPlate(context, onSheet, frame.camera, frame.size, colours);
  drawAxes(context, colours, which, frame.sign, height);
  const shown = errors.places.map((place) => (place ? frame.at(place) : null));
  const onScreen = (error: Vector3): [number, number] => {
    const [u, v] = inPlane(which, error);
    return [frame.sign * grow * u, -grow * v];
  };
  const {readings} = errors,
    picked = selectedReadings.peek();
  const isShown = (i: number) => isInShare(i, readings.length, MOST_ARROWS) || picked.has(readings[i].id);
  errors.series.forEach((series, k) => drawSeries(context, series, k === 0, shown, isShown, colours, onScreen));
  drawScale(context, colours, largest, grow, width, height);
  return shown;
}

/** Each error of a series as a dot at its place and an arrow from there; hollow before, full after, as marks are. */
function drawSeries(
  context: CanvasRenderingContext2D,
  series: ReadingErrors["series"][number],
  isBefore: boolean,
  places: PlacesOnScreen,
  isShown: (reading: number) => boolean,
  colours: Palette,
  onScreen: (error: Vector3) => [number, number],
): void {
  context.strokeStyle = context.fillStyle = colours[series.mark.colour];
  context.lineWidth = 1.3;
  places.forEach((at, i) => {
    const error = series.errors[i];
    if (!at || !error || !isShown(i)) return;
    context.beginPath();
    context.arc(...at, 1.5, 0, 2 * Math.PI);
    context.fill();
    drawArrow(context, ...at, ...onScreen(error), isBefore);
  });
}

interface Frame {
  camera: Camera;
  size: Size;
  /** -1 where the sheet is seen from below: +x points left, as in the sheet's own picture. */
  sign: number;
  at: (place: Vector3) => [number, number];
}

const BESIDE_SHEET = {left: 12, right: 12, top: 12, bottom: 12};
const BESIDE_PLACES = {left: 45, right: 45, top: 30, bottom: 30};

/** Fits the places, or the whole sheet where the cell has one. */
function makeFrame(which: Plane, places: Vector3[], onSheet: SheetModel | null, size: Size): Frame {
  const sign = onSheet?.viewingSide === "below" ? -1 : 1;
  const drawn = (place: Vector3): [number, number] => {
    const [u, v] = inPlane(which, place);
    return [sign * u, v];
  };
  const camera = fit(onSheet?.plate ?? extentOf(places.map(drawn)), size, onSheet ? BESIDE_SHEET : BESIDE_PLACES);
  return {camera, size, sign, at: (place) => toPixel(camera, size, ...drawn(place))};
}

const FONT = `11px ${TYPEFACE}`;

function drawAxes(
  context: CanvasRenderingContext2D,
  colours: Palette,
  which: Plane,
  sign: number,
  height: number,
): void {
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

function drawScale(
  context: CanvasRenderingContext2D,
  colours: Palette,
  largest: number,
  grow: number,
  width: number,
  height: number,
): void {
  if (!(largest > 0)) return;
  const size = roundDown125(largest),
    long = size * grow;
  context.strokeStyle = context.fillStyle = colours.ink;
  drawArrow(context, width - 14 - long, height - 12, long, 0);
  context.font = FONT;
  context.textAlign = "right";
  context.fillText(`${exact(size)} ${units.value.length}`, width - 14, height - 20);
  context.textAlign = "left";
}
