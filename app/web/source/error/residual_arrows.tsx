// The errors as arrows at the readings' places: over the sheet where the cell has one, else in plan or from a side.
import {Segments} from "../drawing/segments";
import {effect as follow, signal} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {palette, type Palette} from "../drawing/colours";
import {followLasso, isInside} from "../drawing/lasso";
import {short, roundDown125} from "../drawing/numbers";
import type {Vector3} from "../server/documents";
import {units} from "../server/workbench";
import {sheet} from "../shell/page_state";
import type {SheetModel} from "../sheet/sheet_model";
import {readingErrors, type ReadingErrors} from "./residuals";
import {pickOut, pickedOut, pointed} from "./linked";
import {SeriesLegend} from "./residual_plot";
import {showReading} from "./show_reading";

type Plane = "xy" | "xz" | "yz";
const PLANES: [Plane, string][] = [
  ["xy", "above"],
  ["xz", "along y"],
  ["yz", "along x"],
];
const plane = signal<Plane>("xy");

/** The length on screen of a typical error, in pixels. */
const TYPICAL = 22;

export function PlaneChoice() {
  return (
    <Segments
      label="Seen"
      value={plane.value}
      onChoose={(next) => (plane.value = next)}
      choices={PLANES.map(([value, words]) => ({
        value,
        words: value === "xy" && sheet.value?.viewingSide === "below" ? "below" : words,
      }))}
    />
  );
}

/** Within so many pixels a place is pointed at. */
const NEAR = 12;

export function ResidualArrows() {
  const canvas = useRef<HTMLCanvasElement>(null),
    ring = useRef<HTMLElement>(null);
  const places = useRef<([number, number] | null)[]>([]);
  const errors = readingErrors.value;
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
  }, [errors, plane.value, palette.value, sheet.value, units.value, pickedOut.value]);
  useEffect(() => {
    const element = canvas.current!;
    return followLasso(element, element.parentElement!, (loop, isMore) =>
      pickOut(
        (errors?.readings ?? []).flatMap(({id}, i) => {
          const place = places.current[i];
          return place && isInside(loop, ...place) ? [id] : [];
        }),
        isMore,
      ),
    );
  }, [errors]);
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
  const pointAt = (event: PointerEvent) => {
    const index = nearestPlace(places.current, event.offsetX, event.offsetY);
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
      <SeriesLegend errors={errors} />
    </div>
  );
}

/** Readings that are picked out have a ring. */
function drawPicked(
  canvas: HTMLCanvasElement,
  errors: ReadingErrors | null,
  places: ([number, number] | null)[],
  colours: Palette,
): void {
  const context = canvas.getContext("2d")!;
  context.strokeStyle = colours.ink;
  context.lineWidth = 1;
  context.beginPath();
  errors?.readings.forEach(({id}, i) => {
    const place = pickedOut.peek().has(id) ? places[i] : null;
    if (!place) return;
    context.moveTo(place[0] + 5, place[1]);
    context.arc(...place, 5, 0, 2 * Math.PI);
  });
  context.stroke();
}

function nearestPlace(places: ([number, number] | null)[], x: number, y: number): number {
  let best = -1,
    least = NEAR * NEAR;
  places.forEach((place, i) => {
    const square = place ? (place[0] - x) ** 2 + (place[1] - y) ** 2 : Infinity;
    if (square < least) [best, least] = [i, square];
  });
  return best;
}

function axesOf(which: Plane): [number, number] {
  return which === "xy" ? [0, 1] : which === "xz" ? [0, 2] : [1, 2];
}

/** Draws them; where each reading's place is, in pixels. */
function drawArrows(
  canvas: HTMLCanvasElement,
  errors: ReadingErrors | null,
  which: Plane,
  colours: Palette,
): ([number, number] | null)[] {
  const box = canvas.parentElement!,
    ratio = Math.min(2, devicePixelRatio || 1);
  const width = box.clientWidth,
    height = box.clientHeight;
  canvas.width = Math.max(1, Math.round(width * ratio));
  canvas.height = Math.max(1, Math.round(height * ratio));
  const context = canvas.getContext("2d")!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  if (!errors || width < 40 || height < 40) return [];
  const places = errors.places.filter((place): place is Vector3 => place !== null);
  if (places.length === 0) return [];
  const onSheet = which === "xy" ? sheet.peek() : null;
  const frame = makeFrame(which, places, onSheet, width, height);
  const typical = typicalSize(errors.series[0].errors);
  const grow = typical > 0 ? TYPICAL / typical : 0;
  if (onSheet) drawPlate(context, colours, onSheet, frame);
  drawAxes(context, colours, which, frame.sign, height);
  for (const series of errors.series) {
    context.strokeStyle = context.fillStyle = colours[series.mark.colour];
    context.lineWidth = 1.3;
    errors.places.forEach((place, i) => {
      const error = series.errors[i];
      if (place && error)
        drawArrow(context, ...frame.at(place), frame.sign * grow * error[frame.a], -grow * error[frame.b]);
    });
  }
  drawScale(context, colours, typical, grow, width, height);
  return errors.places.map((place) => (place ? frame.at(place) : null));
}

interface Frame {
  a: number;
  b: number;
  /** -1 where the sheet is seen from below: +x points left, as in the sheet's own picture. */
  sign: number;
  scale: number;
  at: (place: Vector3) => [number, number];
}

/** Fits the places, or the whole sheet where the cell has one. */
function makeFrame(which: Plane, places: Vector3[], onSheet: SheetModel | null, width: number, height: number): Frame {
  const [a, b] = axesOf(which),
    sign = onSheet?.viewingSide === "below" ? -1 : 1;
  const range = (of: (place: Vector3) => number) =>
    places.reduce(([low, high], place) => [Math.min(low, of(place)), Math.max(high, of(place))], [Infinity, -Infinity]);
  const r = onSheet?.radius ?? 0;
  const [left, right] = onSheet ? [-r, r] : range((place) => place[a]);
  const [bottom, top] = onSheet
    ? [onSheet.isOneLeg && onSheet.extent.top > 0 ? 0 : -r, onSheet.isOneLeg && onSheet.extent.top <= 0 ? 0 : r]
    : range((place) => place[b]);
  const [besideX, besideY] = onSheet ? [24, 24] : [90, 60];
  const scale = Math.min((width - besideX) / (right - left || 1), (height - besideY) / (top - bottom || 1));
  return {
    a,
    b,
    sign,
    scale,
    at: (place) => [
      width / 2 + sign * scale * (place[a] - (left + right) / 2),
      height / 2 - scale * (place[b] - (bottom + top) / 2),
    ],
  };
}

function drawPlate(context: CanvasRenderingContext2D, colours: Palette, onSheet: SheetModel, frame: Frame): void {
  const [x, y] = frame.at([0, 0, 0]),
    isBelow = onSheet.extent.top <= 0;
  context.beginPath();
  if (onSheet.isOneLeg)
    context.arc(x, y, onSheet.radius * frame.scale, isBelow ? 0 : Math.PI, isBelow ? Math.PI : 2 * Math.PI);
  else context.arc(x, y, onSheet.radius * frame.scale, 0, 2 * Math.PI);
  context.closePath();
  context.fillStyle = colours.plate;
  context.strokeStyle = colours.rim;
  context.lineWidth = 1;
  context.fill();
  context.stroke();
}

function typicalSize(errors: (Vector3 | null)[]): number {
  const known = errors.filter((error): error is Vector3 => error !== null);
  return Math.sqrt(
    known.reduce((sum, error) => sum + error[0] ** 2 + error[1] ** 2 + error[2] ** 2, 0) / Math.max(1, known.length),
  );
}

function drawArrow(context: CanvasRenderingContext2D, x: number, y: number, dx: number, dy: number): void {
  const long = Math.hypot(dx, dy);
  context.beginPath();
  context.arc(x, y, 1.5, 0, 2 * Math.PI);
  context.fill();
  if (long < 1) return;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + dx, y + dy);
  context.stroke();
  const head = Math.min(6, 0.4 * long),
    ux = dx / long,
    uy = dy / long;
  context.beginPath();
  context.moveTo(x + dx, y + dy);
  context.lineTo(x + dx - head * (ux + 0.45 * uy), y + dy - head * (uy - 0.45 * ux));
  context.lineTo(x + dx - head * (ux - 0.45 * uy), y + dy - head * (uy + 0.45 * ux));
  context.closePath();
  context.fill();
}

const FONT = "11px 'IBM Plex Sans Variable', system-ui, sans-serif";

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
  context.fillText(which[0], sign > 0 ? x + 30 : x - 38, y + 4);
  context.fillText(which[1], x - 3, y - 31);
}

function drawScale(
  context: CanvasRenderingContext2D,
  colours: Palette,
  typical: number,
  grow: number,
  width: number,
  height: number,
): void {
  if (!(typical > 0)) return;
  const size = roundDown125(1.6 * typical),
    long = size * grow;
  context.strokeStyle = context.fillStyle = colours.ink;
  drawArrow(context, width - 14 - long, height - 12, long, 0);
  context.font = FONT;
  context.textAlign = "right";
  context.fillText(`${short(size)} ${units.value.length}`, width - 14, height - 20);
  context.textAlign = "left";
}
