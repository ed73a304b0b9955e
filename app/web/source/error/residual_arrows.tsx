// The errors as arrows at the positions of the readings: over the sheet if the cell has one, otherwise seen from above
// or from a side.
import {Segments} from "../drawing/segments";
import {effect as follow, signal} from "@preact/signals";
import type {RefObject} from "preact";
import {useEffect, useRef} from "preact/hooks";
import {drawRings} from "../drawing/canvas";
import {palette, type Palette} from "../drawing/colours";
import {followLasso, isInside} from "../drawing/lasso";
import {usePainted} from "../drawing/painted";
import {nearestPlace} from "../../../drawing/frames.js";
import {plural} from "../../../drawing/numbers.js";
import {PLANES, type Plane} from "../../../drawing/planes.js";
import {MOST_ARROWS} from "../../../drawing/shares.js";
import {units} from "../server/workbench";
import {sheet} from "../shell/page_state";
import {type ArrowsLook, drawArrows, isOverSheet, type PlacesOnScreen} from "./arrow_painting";
import {readingErrors, type ReadingErrors} from "./residuals";
import {SELECTED_RADIUS, selectReadings, selectedReadings, pointed} from "./linked";
import {SeriesLegend} from "./series_legend";
import {showReading} from "./show_reading";

const plane = signal<Plane>(PLANES[0]);

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

/** Maximum distance from the pointer to a reading at which the reading is selected [pixels]. */
const NEAR = 12;

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
          aria-label={`Errors of ${plural(errors?.readings.length ?? 0, "reading")} as arrows at their places`}
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

/**
 * Draws the arrows again after every change of the errors or of the size. Returns the positions of the readings
 * [pixels].
 */
function useDrawnArrows(canvas: RefObject<HTMLCanvasElement>, errors: ReadingErrors | null) {
  const places = useRef<PlacesOnScreen>([]);
  const look: ArrowsLook = {
    errors,
    plane: plane.value,
    unit: units.value.length,
    sheet: sheet.value,
    picked: selectedReadings.value,
  };
  const paint = (element: HTMLCanvasElement) => {
    places.current = drawArrows(element, look, palette.peek());
    drawPicked(element, errors, places.current, palette.peek());
  };
  usePainted(canvas, paint, [...Object.values(look), palette.value]);
  return places;
}

/** Selects the readings whose positions are inside a lasso. */
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

/** Draws rings around the positions of the selected readings. */
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
