// The path of the tip in the order of visiting, with a slider along it.
import {useSignal} from "@preact/signals";
import {useCallback, useEffect, useMemo} from "preact/hooks";
import {distance} from "../../../../drawing/frames.js";
import {isNumber, plural} from "../../../../drawing/numbers.js";
import type {SheetModel} from "../../../../drawing/sheet_model.js";
import {strokeLine} from "../../drawing/canvas";
import {Card, Lead, Missing, type OfReport} from "../parts";
import {list, points, type Report, tubeName} from "../values";
import {holeDescriber, modesOf, predictedMode, visitOf} from "./cases";
import {markRadius, type Painter, paintArrow, paintMarks, paintTag, type Place, readSheet, SheetBox} from "./sheet_box";

/** Trace of the tip with the path length at each point, and the index of the point at which each tube is reached. */
interface Tour {
  trace: Place[];
  lengths: number[];
  total: number;
  stops: {tube: Report; index: number}[];
}

const placed = (report: Report) => list(report.tubes).filter((tube) => isNumber(tube.x) && isNumber(tube.y));

function readTour(report: Report, pitch: number): Tour {
  const trace = points(report.tour),
    lengths = [0];
  for (let i = 1; i < trace.length; ++i) lengths.push(lengths[i - 1] + distance(trace[i - 1], trace[i]));
  const stops: Tour["stops"] = [];
  let next = 0;
  for (const tube of placed(report)) {
    const index = trace.findIndex((point, i) => i >= next && distance(point, [tube.x, tube.y]) < 0.1 * pitch);
    if (index < 0) continue;
    stops.push({tube, index});
    next = index;
  }
  return {trace, lengths, total: lengths.at(-1)!, stops};
}

export function TourSection({report}: OfReport) {
  const sheet = readSheet(report);
  if (!sheet || points(report.tour).length < 2) return <Missing what="The tour" />;
  return (
    <>
      <Lead>
        {plural(list(report.tubes).length, "tube")} in visiting order; the trace runs from blue (start) to orange (end),
        arrows give the direction, numbers the order.
      </Lead>
      <Card>
        <TourMap report={report} sheet={sheet} />
      </Card>
    </>
  );
}

function TourMap({report, sheet}: {sheet: SheetModel} & OfReport) {
  const tour = useMemo(() => readTour(report, sheet.pitch), [report]);
  const describe = useMemo(() => {
    const modes = modesOf(report);
    return holeDescriber(report, modes.find(({key}) => key === "via_point") ?? predictedMode(report));
  }, [report]);
  const part = useSignal<number | null>(null);
  const at = part.value === null ? null : placeAlong(tour, part.value);
  const paint = useCallback(
    (painter: Painter) => {
      paintTrace(painter, tour);
      paintStops(painter, report);
      if (at) paintMarks(painter, {shape: "ring", colour: "rose"}, [at.place], 9);
    },
    [tour, part.value],
  );
  return (
    <>
      <SheetBox {...{report, sheet, describe, paint}} label="The tour of the tip over the sheet" isFaint />
      <Walk part={part.value ?? 0} onMove={(next) => (part.value = next)} />
      <p class="note">
        {at === null
          ? "Press Play or move the slider to walk along the tour."
          : at.reached
            ? `Last reached: ${tubeName(at.reached)} (${visitOf(report, at.reached)})`
            : "Before the first tube"}
      </p>
    </>
  );
}

/** Slider along the tour, with a button that moves it; `part` is the fraction of the tour's length. */
function Walk({part, onMove}: {part: number; onMove: (part: number) => void}) {
  const isPlaying = useSignal(false);
  useEffect(() => {
    if (!isPlaying.value) return;
    if (part >= 1) isPlaying.value = false;
    const timer = setTimeout(() => onMove(Math.min(1, part + 0.002)), 40);
    return () => clearTimeout(timer);
  }, [isPlaying.value, part]);
  const toggle = () => {
    if (part >= 1) onMove(0);
    isPlaying.value = !isPlaying.value;
  };
  return (
    <div class="walk">
      <button type="button" class="button small" onClick={toggle}>
        {isPlaying.value ? "Pause" : "Play"}
      </button>
      <input
        type="range"
        min={0}
        max={1}
        step={0.001}
        value={part}
        aria-label="Place along the tour"
        onInput={(event) => onMove(event.currentTarget.valueAsNumber)}
      />
    </div>
  );
}

/** Returns the position at a fraction `part` (0 to 1) of the tour's length, and the last tube reached there. */
function placeAlong({trace, lengths, total, stops}: Tour, part: number): {place: Place; reached: Report | null} {
  const run = part * total;
  const found = lengths.findIndex((length, i) => i > 0 && length >= run),
    i = found < 0 ? trace.length - 1 : found;
  const span = lengths[i] - lengths[i - 1],
    share = span > 0 ? Math.min(1, (run - lengths[i - 1]) / span) : 1;
  const [x, y] = [0, 1].map((k) => trace[i - 1][k] + share * (trace[i][k] - trace[i - 1][k]));
  const reached = stops.findLast(({index}) => lengths[index] <= run + 1e-9 * total);
  return {place: [x, y], reached: reached?.tube ?? null};
}

/** Distance between arrow heads on the trace [pixels]. */
const BETWEEN_HEADS = 70;

function paintTrace(painter: Painter, {trace, lengths, total}: Tour): void {
  const {context, at, scale} = painter;
  let due = BETWEEN_HEADS / 2 / scale;
  for (let i = 1; i < trace.length; ++i) {
    const [from, to] = [at(trace[i - 1]), at(trace[i])],
      colour = tourColour(lengths[i] / (total || 1));
    context.lineWidth = 1.6;
    context.strokeStyle = colour;
    strokeLine(context, from, to);
    if (lengths[i] < due) continue;
    due = lengths[i] + BETWEEN_HEADS / scale;
    const long = distance(from, to),
      middle: Place = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    const back: Place = [middle[0] - (7 * (to[0] - from[0])) / long, middle[1] - (7 * (to[1] - from[1])) / long];
    if (long > 0.5) paintArrow(context, back, middle, colour, 1.8);
  }
}

/**
 * Returns a colour from blue to orange through a grey violet; its ends are distinguishable with colour blindness.
 */
function tourColour(part: number): string {
  const stops = [
    [0, 114, 178],
    [150, 105, 150],
    [213, 94, 0],
  ];
  const k = part < 0.5 ? 0 : 1,
    share = 2 * part - k;
  return `rgb(${stops[k].map((value, i) => Math.round(value + share * (stops[k + 1][i] - value))).join(",")})`;
}

/** Paints a dot at each tube, with visit numbers at the first tube, the last tube and every few tubes between. */
function paintStops(painter: Painter, report: Report): void {
  const places = placed(report).map(({x, y}): Place => [x, y]),
    last = places.length - 1;
  const every = places.length <= 80 ? 5 : Math.ceil(places.length / 160) * 10;
  paintMarks(painter, {shape: "disc", colour: "ink"}, places, 0.4 * markRadius(painter, places));
  places.forEach((place, i) => {
    const isEnd = i === 0 || i === last;
    if (isEnd) paintMarks(painter, {shape: "square", colour: "ink"}, [place], 4.5);
    if (isEnd) paintTag(painter, i === 0 ? "1 start" : `${i + 1} end`, painter.at(place), true);
    else if ((i + 1) % every === 0) paintTag(painter, String(i + 1), painter.at(place));
  });
}
