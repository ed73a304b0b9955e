// Pointing at readings in the plot: the reading of the point nearest to the pointer is named, a click moves the arm to
// the reading's posture, and a lasso selects readings. Pointing does not redraw the plot.
import {useEffect, useRef} from "preact/hooks";
import {effect as follow, signal, type Signal} from "@preact/signals";
import type {RefObject} from "preact";
import uPlot from "uplot";
import {drawRings} from "../drawing/canvas";
import {palette} from "../drawing/colours";
import {Terms} from "../drawing/panel";
import {conditionsOf} from "../../../drawing/conditions.js";
import {errorText, isNumber} from "../../../drawing/numbers.js";
import {READING_SIGMAS, sigmasText} from "../../../drawing/sigma_text.js";
import {cell, units} from "../server/workbench";
import {followLasso, isInside, type Loop} from "../drawing/lasso";
import {SELECTED_RADIUS, selectReadings, selectedReadings, pointed} from "./linked";
import {paintWithin} from "./plot_painting";
import type {PlotRow} from "./error_plot";
import type {ReadingErrors} from "./residuals";
import {showReading} from "./show_reading";

/** Position in the panel [pixels]; null if no point is pointed at. */
export type Place = {x: number; y: number; width: number} | null;

const NEAR = 14;

interface Points {
  xs: Float32Array;
  ys: Float32Array;
  rows: Uint32Array;
}

/** Returns the points of all series with their positions in the plot. */
function pointsOf(plot: uPlot): Points {
  const xs: number[] = [],
    ys: number[] = [],
    rows: number[] = [];
  for (let series = 1; series < plot.data.length; ++series) {
    plot.data[series].forEach((value, row) => {
      if (!isNumber(value)) return;
      xs.push(plot.valToPos(plot.data[0][row], "x"));
      ys.push(plot.valToPos(value, "y"));
      rows.push(row);
    });
  }
  return {xs: Float32Array.from(xs), ys: Float32Array.from(ys), rows: Uint32Array.from(rows)};
}

function nearest(points: Points, x: number, y: number): number {
  let best = -1,
    least = NEAR * NEAR;
  for (let i = 0; i < points.xs.length; ++i) {
    const square = (points.xs[i] - x) ** 2 + (points.ys[i] - y) ** 2;
    if (square < least) {
      least = square;
      best = i;
    }
  }
  return best;
}

export function usePointing(box: RefObject<HTMLDivElement>, rows: PlotRow[] | null) {
  const place = useRef(signal<Place>(null)).current;
  const now = useRef({rows, plot: null as uPlot | null, points: null as Points | null});
  now.current.rows = rows;
  const onReady = useRef((plot: uPlot) => {
    const own = now.current;
    own.plot = plot;
    own.points = null;
    place.value = null;
    plot.hooks.draw = [...(plot.hooks.draw ?? []), () => (own.points = null)];
    plot.hooks.draw.push(() => paintPicked(plot, own.rows));
    const over = plot.over;
    plot.hooks.destroy = [followLasso(over, over, (loop, isMore) => pickWithin(plot, own.rows, loop, isMore))];
    over.addEventListener("pointermove", (event) => {
      own.points ??= pointsOf(plot);
      const found = nearest(own.points, event.offsetX, event.offsetY);
      pointed.value = found < 0 ? "" : (own.rows?.[own.points.rows[found]]?.id ?? "");
    });
    over.addEventListener("pointerleave", () => (pointed.value = ""));
    let down = [0, 0];
    over.addEventListener("pointerdown", (event) => (down = [event.offsetX, event.offsetY]));
    over.addEventListener("click", (event) => {
      const moved = Math.hypot(event.offsetX - down[0], event.offsetY - down[1]);
      if (moved < 5 && pointed.peek() !== "") showReading(pointed.peek());
    });
  }).current;
  // Follows the reading pointed at, in this plot or in another picture.
  useEffect(
    () =>
      follow(() => {
        const id = pointed.value,
          {plot, rows: listed} = now.current;
        const row = id === "" ? -1 : (listed?.findIndex((entry) => entry.id === id) ?? -1);
        place.value = plot && row >= 0 && box.current ? placeOf(plot, row, box.current) : null;
      }),
    [],
  );
  useEffect(
    () =>
      follow(() => {
        void selectedReadings.value;
        now.current.plot?.redraw(false);
      }),
    [],
  );
  return {place, onReady};
}

/** Paints rings around the points of the selected readings. */
function paintPicked(plot: uPlot, rows: PlotRow[] | null): void {
  if (!rows || selectedReadings.peek().size === 0) return;
  const picked = rows.flatMap(({id}, row): [number, number][] => {
    const value = plot.data[1][row] ?? plot.data[2]?.[row];
    if (!isNumber(value) || !selectedReadings.peek().has(id)) return [];
    return [[plot.valToPos(plot.data[0][row], "x", true), plot.valToPos(value, "y", true)]];
  });
  paintWithin(plot, (context) => {
    context.strokeStyle = palette.peek().ink;
    context.lineWidth = uPlot.pxRatio;
    drawRings(context, picked, SELECTED_RADIUS * uPlot.pxRatio);
  });
}

/** Returns the position of the reading's point, in the first series that has one. */
function placeOf(plot: uPlot, row: number, box: HTMLElement): Place {
  const value = plot.data[1][row] ?? plot.data[2]?.[row];
  if (!isNumber(value)) return null;
  const over = plot.over.getBoundingClientRect(),
    frame = box.getBoundingClientRect();
  return {
    x: over.left - frame.left + plot.valToPos(plot.data[0][row], "x"),
    y: over.top - frame.top + plot.valToPos(value, "y"),
    width: frame.width,
  };
}

function pickWithin(plot: uPlot, rows: PlotRow[] | null, loop: Loop, isMore: boolean): void {
  if (!rows) return;
  const picked: string[] = [];
  const {xs, ys, rows: of} = pointsOf(plot);
  for (let i = 0; i < xs.length; ++i) if (isInside(loop, xs[i], ys[i])) picked.push(rows[of[i]].id);
  selectReadings(picked, isMore);
}

/** Ring around the pointed point, with the data of its reading. */
export function PointedReading({place, errors}: {place: Signal<Place>; errors: ReadingErrors | null}) {
  const at = place.value,
    index = at ? (errors?.readings.findIndex((reading) => reading.id === pointed.value) ?? -1) : -1;
  if (!at || !errors || index < 0) return null;
  const isRight = at.x > at.width / 2;
  return (
    <>
      <i class="point-ring" style={{transform: `translate(${at.x}px, ${at.y}px)`}} />
      <div
        class="tip reading-tip"
        style={{
          top: `${Math.max(4, at.y - 40)}px`,
          ...(isRight ? {right: `${at.width - at.x + 14}px`} : {left: `${at.x + 14}px`}),
        }}
      >
        <ReadingWords errors={errors} index={index} />
      </div>
    </>
  );
}

function ReadingWords({errors, index}: {errors: ReadingErrors; index: number}) {
  const reading = errors.readings[index];
  const joints = errors.joints.map((name, k) => ({name, unit: cell.value?.joints[k]?.unit}));
  return (
    <>
      <b>
        reading {reading.id}
        {reading.point ? ` at ${reading.point}` : ""}
        {reading.held_out ? ", held out" : ""}
      </b>
      <dl>
        <Terms
          rows={[
            ...conditionsOf(reading, joints, units.value).map(
              ({name, figure, unit, sense}) => [name, `${figure} ${unit} ${sense}`] as const,
            ),
            ...errors.series.map(({errors: of}, k) => {
              const words = <ErrorWords error={of[index]} sigmas={errors.sigmas[k]?.[index]} />;
              return [k === 0 ? "before" : "after", words] as const;
            }),
          ]}
        />
      </dl>
      <span>click: the arm there</span>
    </>
  );
}

/** Error with its size in sigmas. More than five sigmas are marked, by a sign as well as by colour. */
function ErrorWords({error, sigmas}: {error: number[] | null; sigmas: number | undefined}) {
  if (!error) return <>–</>;
  const {text, isMany} = sigmasText(sigmas, READING_SIGMAS);
  return (
    <>
      {errorText(Math.hypot(...error), units.value.length)}
      {isNumber(sigmas) ? <span class={isMany ? "bad" : ""}>{` ${text} σ`}</span> : null}
    </>
  );
}
