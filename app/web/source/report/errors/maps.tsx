// The error at the position of every reading as an arrow, seen from above and from the side; and the errors plotted
// against all variables of the readings.
import {useSignal} from "@preact/signals";
import {useMemo, useRef} from "preact/hooks";
import {nearestPlace} from "../../../../drawing/frames.js";
import {short} from "../../../../drawing/numbers.js";
import {PLANES, type Plane} from "../../../../drawing/planes.js";
import type {ErrorPair} from "../../../../drawing/reading_errors.js";
import {rangeOf} from "../../../../drawing/scales.js";
import {MOST_ARROWS, MOST_MARKS, shareText} from "../../../../drawing/shares.js";
import {palette} from "../../drawing/colours";
import {usePainted} from "../../drawing/painted";
import {choicesOf, Segments} from "../../drawing/segments";
import {drawArrows, type PlacesOnScreen} from "../../error/arrow_painting";
import {SeriesLegend} from "../../error/series_legend";
import {Card, Lead, Missing, type OfReport} from "../parts";
import {type Lines, Pointed} from "../pointed";
import {lengthText, lengthUnit, type Report} from "../values";
import {ErrorPlotBox} from "./error_plot_box";
import {conditionsText, errorsOf, readingName, rootMeanSquare, sizeOf} from "./pairs";

/** The two planes that fit on a page: seen from above and from one side. */
const VIEWS = PLANES.slice(0, 2);

export function MapsSection({report}: OfReport) {
  const [errors] = errorsOf(report).pairs;
  if (!errors.places.some((place) => place !== null)) return <Missing what="The errors at the readings" />;
  const rows = VIEWS.map((view) => errors.series.map((_, k) => ({view, k})));
  return (
    <>
      <Lead>
        From where the model puts the tip towards where it was measured, at every reading's place in the world. Arrows
        that point the same way, or turn with the position, are a pattern; noise is random.
      </Lead>
      {(errors.series.length === 1 ? [rows.flat()] : rows).map((row) => (
        <div class="pair">
          {row.map(({view, k}) => (
            <ArrowMap report={report} errors={errors} view={view} only={k} />
          ))}
        </div>
      ))}
    </>
  );
}

interface ArrowMapProps {
  report: Report;
  errors: ErrorPair;
  view: Plane;
  /** Index of the only series drawn. */
  only: number;
}

function ArrowMap({report, errors, view, only}: ArrowMapProps) {
  const canvas = useRef<HTMLCanvasElement>(null),
    places = useRef<PlacesOnScreen>([]);
  const look = {errors, plane: view, unit: lengthUnit(report), sheet: null, only};
  usePainted(canvas, (element) => (places.current = drawArrows(element, look, palette.peek())), [palette.value]);
  const find = (event: PointerEvent) => {
    const index = nearestPlace(places.current, event.offsetX, event.offsetY, 12);
    return index < 0 ? null : describeErrors(report, errors, index);
  };
  const {name, errors: shown} = errors.series[only];
  const sizes = shown.map(sizeOf).filter((size) => size !== null),
    share = shareText(sizes.length, MOST_ARROWS);
  return (
    <Card title={`${name}, seen ${view.words}`}>
      <Pointed find={find} class="arrow-map fill">
        <canvas ref={canvas} role="img" aria-label={`Errors seen ${view.words}, ${name}`} />
      </Pointed>
      <p class="note">
        Root mean square {lengthText(rootMeanSquare(sizes), report)}, largest {lengthText(rangeOf(sizes)[1], report)}.
        {share ? ` ${share}.` : ""}
      </p>
    </Card>
  );
}

function describeErrors(report: Report, errors: ErrorPair, index: number): Lines {
  const unit = lengthUnit(report);
  return [
    readingName(errors.readings[index]),
    ...errors.series.map(({name, errors: of}) => {
      const error = of[index];
      return error && `${name.split(":")[0]} ${short(sizeOf(error))} ${unit}: ${error.map(short).join(", ")}`;
    }),
    conditionsText(report, errors.readings[index]),
  ];
}

/**
 * Kinds of variables that are omitted here: moments, which follow from the joints, positions, which have separate maps,
 * and the labels and order of the readings.
 */
const ELSEWHERE = ["moment", "position", "set-up", "point", "order"];

export function ChartsSection({report}: OfReport) {
  const part = useSignal("size");
  const {errors, variables, parts} = useMemo(() => {
    const {pairs, axes} = errorsOf(report),
      [errors] = pairs,
      {variables, parts} = axes;
    const drawn = variables.filter(({kind}) => !ELSEWHERE.includes(kind));
    const rank = ({kind}: {kind: string}) => Number(kind === "sense");
    return {errors, variables: drawn.sort((a, b) => rank(a) - rank(b)), parts: parts.slice(0, 4)};
  }, [report]);
  const views = useMemo(() => {
    const chosen = parts.find(({key}) => key === part.value)!;
    return variables.map((variable) => ({variable, part: chosen}));
  }, [report, part.value]);
  if (views.length === 0) return <Missing what="What the errors could be drawn against" />;
  return (
    <>
      <Lead>
        Where the errors follow one of these, the missing effect depends on it. An effect with a direction shows in x, y
        or z rather than in the size.
      </Lead>
      <div class="card-head">
        <SeriesLegend errors={errors} most={MOST_MARKS} />
        <Segments
          label="Part of the error"
          choices={choicesOf(parts.map(({key}) => [key, key] as const))}
          value={part.value}
          onChoose={(next) => (part.value = next)}
        />
      </div>
      <div class="few">
        {views.map((view) => (
          <Card>
            <ErrorPlotBox report={report} errors={errors} view={view} isSmall />
          </Card>
        ))}
      </div>
    </>
  );
}
