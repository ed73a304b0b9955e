// The centring errors: as arrows on the sheet, with an arrow scale, and as landing points about the centre of a hole.
import {useCallback, useMemo} from "preact/hooks";
import {UNSCORED} from "../../../../drawing/kinds.js";
import {exact, isNumber, plural, short, whole} from "../../../../drawing/numbers.js";
import {roundDown125} from "../../../../drawing/scales.js";
import type {SheetModel} from "../../../../drawing/sheet_model.js";
import {stepCountOf, stepMark} from "../../../../drawing/steps.js";
import {MarkAt, type Mark} from "../../drawing/marks";
import {Card, Lead, Missing, type OfReport} from "../parts";
import {lengthUnit, list, object, tubeName} from "../values";
import {type CentringError, errorsOf, holeDescriber, largestError, type Mode, modesOf} from "./cases";
import {type Painter, paintArrow, paintMarks, type Place, readSheet, SheetBox} from "./sheet_box";

/** Mark at the start of an arrow. */
const PLACE: Mark = {shape: "disc", colour: "muted"};
/** Length of the longest arrow, relative to the sheet's width. */
const ARROW_SHARE = 0.06;

const widthOf = ({plate}: SheetModel) => plate.right - plate.left;

/** Returns the magnification of errors for which the longest arrow has a suitable length on the sheet. */
export function magnificationFor(largest: number, sheet: SheetModel): number {
  return largest > 0 ? roundDown125((ARROW_SHARE * widthOf(sheet)) / largest) : 1;
}

export function CentringSection({report}: OfReport) {
  const sheet = readSheet(report);
  const modes = modesOf(report).filter(({key}) => errorsOf(report, key).length > 0);
  if (!sheet || modes.length === 0)
    return (
      <>
        <Missing what="Centring errors against a true arm" />
        <PredictedError report={report} />
      </>
    );
  const before = modes.find(({key}) => key === "none"),
    after = modes.find(({key}) => key === "via_point") ?? modes.at(-1)!;
  const shared = before ? magnificationFor(largestError(errorsOf(report, "none")), sheet) : null;
  const shown = before && after !== before ? [before, after] : [after];
  return (
    <>
      <Lead>
        From each hole's centre to the true position of the tip. Each picture states how much larger than the sheet its
        arrows are drawn. Below, the same errors as landing points within one hole.
      </Lead>
      <div class="pair">
        {shown.map((mode) => (
          <ArrowMap report={report} sheet={sheet} mode={mode} shared={shared} />
        ))}
      </div>
      <div class="pair">
        {shown.map((mode) => (
          <LandingTarget report={report} mode={mode} />
        ))}
      </div>
    </>
  );
}

function PredictedError({report}: OfReport) {
  const errors = list(report.tubes)
    .map((tube) => tube.predicted_error)
    .filter(isNumber);
  if (errors.length === 0) return null;
  return (
    <p>
      By the plan's own model the tip is at most {short(Math.max(...errors))} {lengthUnit(report)} from a hole's centre
      over {plural(errors.length, "tube")}.
    </p>
  );
}

/**
 * Map of the centring errors as arrows. `shared` is the magnification of the previous map, which is used unless the
 * arrows would be too short to see; null for none.
 */
function ArrowMap({report, sheet, mode, shared}: {sheet: SheetModel; mode: Mode; shared: number | null} & OfReport) {
  const unit = lengthUnit(report),
    isBefore = mode.key === "none";
  const errors = useMemo(() => errorsOf(report, mode.key), [report, mode.key]);
  const describe = useMemo(() => holeDescriber(report, mode), [report, mode.key]);
  const own = magnificationFor(largestError(errors), sheet);
  const factor = shared !== null && own < 3 * shared ? shared : own;
  const paint = useCallback(
    (painter: Painter) => {
      const fine = errors.length > 400 ? 0.5 : 1,
        colour = painter.colours[isBefore ? "case0" : "accent"];
      const places = errors.map(({tube}): Place => [tube.x, tube.y]);
      paintMarks(painter, PLACE, places, 1.4 * fine);
      for (const {tube, dx, dy} of errors) {
        const to = painter.at([tube.x + factor * dx, tube.y + factor * dy]);
        paintArrow(painter.context, painter.at([tube.x, tube.y]), to, colour, 1.6 * fine);
      }
      paintArrowScale(painter, sheet, factor, unit);
    },
    [errors, factor],
  );
  const note = shared !== null && factor !== shared ? ` (${exact(factor / shared)} times the scale before)` : "";
  const mean = errors.reduce((sum, {error}) => sum + error, 0) / errors.length;
  return (
    <Card title={`${isBefore ? "Before" : "After"}: ${mode.name}`}>
      <SheetBox {...{report, sheet, describe, paint}} label={`Centring-error arrows, ${mode.name}`} isFaint />
      <p class="note">
        <b>
          Arrows magnified {whole(factor)} times{note}.
        </b>{" "}
        Mean error {short(mean)} {unit}, largest {short(largestError(errors))} {unit}.
      </p>
    </Card>
  );
}

/** Paints an arrow of round length in a corner, labelled with the error that it represents. */
export function paintArrowScale(painter: Painter, sheet: SheetModel, factor: number, unit: string): void {
  const {context, size, scale, colours} = painter;
  const length = roundDown125((ARROW_SHARE * widthOf(sheet)) / factor),
    y = size.height - 32;
  paintArrow(context, [42, y], [42 + length * factor * scale, y], colours.ink, 2);
  context.textAlign = "left";
  context.textBaseline = "bottom";
  context.fillText(`${exact(length)} ${unit}`, 42, y - 7);
}

// ---- landing points about a hole's centre, with the rings of the tool's steps

const TARGET = {width: 560, height: 340, rim: 158};

function LandingTarget({report, mode}: {mode: Mode} & OfReport) {
  const unit = lengthUnit(report),
    errors = errorsOf(report, mode.key);
  const tolerances = list(report.steps)
    .map((step) => step.tolerance as number)
    .filter((value) => value > 0);
  const reach = targetReach(tolerances, largestError(errors)),
    outside = errors.filter(({dx, dy}) => Math.hypot(dx, dy) > reach).length;
  const rings = tolerances.map((tolerance, i) => `step ${i + 1}: ${exact(tolerance)}`).join(", ");
  return (
    <Card title={`Within one hole: ${mode.name}`}>
      <svg
        class="drawing"
        viewBox={`0 0 ${TARGET.width} ${TARGET.height}`}
        role="img"
        aria-label={`Landing points about a hole's centre, ${mode.name}`}
      >
        <g transform={`translate(${TARGET.width / 2} ${TARGET.height / 2})`}>
          <circle r={TARGET.rim} class="rim" />
          {tolerances.map((tolerance) => (
            <circle r={(TARGET.rim * tolerance) / reach} class="tolerance" />
          ))}
          {errors.map((entry) => (
            <Landing report={report} mode={mode} entry={entry} reach={reach} />
          ))}
          <path d="M-5 0h10M0 -5v10" class="axis" />
          {tolerances.map((tolerance, i) =>
            (TARGET.rim * tolerance) / reach > 8 ? (
              <text y={(-TARGET.rim * tolerance) / reach - 3} text-anchor="middle">
                {i + 1}
              </text>
            ) : null,
          )}
        </g>
      </svg>
      <p class="note">
        A ring is the centring error up to which a step of the tool enters{rings ? ` (${rings} ${unit})` : ""}; the rim
        is at {short(reach)} {unit}.
        {outside > 0 ? ` ${plural(outside, "tube")} beyond the rim ${outside === 1 ? "is" : "are"} drawn on it.` : ""}
      </p>
    </Card>
  );
}

/**
 * Returns the error at the rim of the target: all rings with some margin, and all errors unless they are far beyond the
 * largest ring.
 */
function targetReach(tolerances: readonly number[], largest: number): number {
  if (tolerances.length === 0) return largest > 0 ? 1.1 * largest : 1;
  const ring = Math.max(...tolerances);
  return Math.max(1.25 * ring, Math.min(1.1 * largest, 3 * ring));
}

/** Landing point of one tube, seen from the same side as the sheet. A point beyond the rim is drawn on the rim. */
function Landing({report, mode, entry, reach}: {mode: Mode; entry: CentringError; reach: number} & OfReport) {
  const {tube, dx, dy, error} = entry,
    steps = mode.caseOf(tube);
  const mark = steps === null ? UNSCORED : stepMark(steps, stepCountOf(report), object(report.base));
  const mirror = object(report.sheet)?.viewed_from === "above" ? 1 : -1,
    long = Math.hypot(dx, dy) || 1,
    scale = (TARGET.rim / reach) * Math.min(1, reach / long);
  return (
    <g>
      <title>{`${tubeName(tube)}: ${short(error)} ${lengthUnit(report)}`}</title>
      <MarkAt mark={mark} x={scale * mirror * dx} y={-scale * dy} r={4.2} />
    </g>
  );
}
