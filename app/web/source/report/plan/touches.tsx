// The touched holes, their residuals and the distances between them.
import {useCallback, useMemo} from "preact/hooks";
import {chance, isNumber, plural, short, whole} from "../../../../drawing/numbers.js";
import type {SheetModel} from "../../../../drawing/sheet_model.js";
import {MARKED, TOUCH_SIGMAS} from "../../../../drawing/sigma_text.js";
import {strokeLine} from "../../drawing/canvas";
import {BasePose, TouchFigures} from "../../calibrate/base_figures";
import type {CalibrateDocument} from "../../server/documents";
import {Card, Lead, Missing, type OfReport} from "../parts";
import {angleUnit, lengthUnit, list, object, type Report, textOf, tubeName, vector} from "../values";
import {holeDescriber, predictedMode} from "./cases";
import {magnificationFor, paintArrowScale} from "./centring";
import {type Painter, paintArrow, paintMarks, paintTag, readSheet, SheetBox} from "./sheet_box";

export function TouchesSection({report}: OfReport) {
  const sheet = readSheet(report);
  const touches = list(report.touches),
    distances = list(report.distances),
    calibration = object(report.calibration);
  if (touches.length === 0 && distances.length === 0 && !calibration) return <Missing what="The calibration touches" />;
  // Joins the touches with the other results of the fit, which the report stores separately.
  const document = {residuals: touches, distances, sigma: calibration?.base_sigma, ...calibration} as CalibrateDocument;
  const placed = touches.filter(({x, y}) => isNumber(x) && isNumber(y));
  return (
    <>
      <Lead>
        Holes touched to calibrate the base, and the residual of each touch. A residual beyond {TOUCH_SIGMAS} sigmas is
        marked: check that touch first.
      </Lead>
      <div class="pair">
        {sheet && placed.length > 0 ? (
          <TouchMap report={report} sheet={sheet} touches={placed} />
        ) : (
          <Card>
            <Missing what="The touches' places" />
          </Card>
        )}
        <Card title="The fitted base">
          {calibration ? (
            <>
              <BasePose document={document} length={lengthUnit(report)} angle={angleUnit(report)} />
              <FitWords report={report} calibration={calibration} />
            </>
          ) : (
            <Missing what="The fit" />
          )}
        </Card>
      </div>
      {touches.length > 0 ? (
        <Card>
          <TouchFigures document={document} unit={lengthUnit(report)} hasSigmas />
        </Card>
      ) : (
        <Missing what="Residuals" />
      )}
    </>
  );
}

function TouchMap({report, sheet, touches}: {sheet: SheetModel; touches: Report[]} & OfReport) {
  const describe = useMemo(() => holeDescriber(report, predictedMode(report)), [report]);
  const residuals = touches.flatMap((touch) => {
    const residual = vector(touch.residual);
    return residual ? [{touch, residual}] : [];
  });
  const largest = residuals.reduce((most, {residual: [x, y]}) => Math.max(most, Math.hypot(x, y)), 0);
  const factor = magnificationFor(largest / 2, sheet);
  const paint = useCallback(
    (painter: Painter) => {
      const {context, at, colours} = painter,
        places = touches.map(({x, y}): [number, number] => [x, y]);
      if (new Set(places.map(String)).size === 3) paintTriangle(painter, places);
      context.lineWidth = 1.5;
      paintMarks(painter, {shape: "ring", colour: "accent"}, places, 7);
      touches.forEach((touch, i) => paintTag(painter, touchName(touch), at(places[i]), true));
      for (const {touch, residual} of residuals) {
        const to = at([touch.x + factor * residual[0], touch.y + factor * residual[1]]);
        paintArrow(context, at([touch.x, touch.y]), to, colours.case0, 2);
      }
      if (residuals.length > 0) paintArrowScale(painter, sheet, factor, lengthUnit(report));
    },
    [report],
  );
  return (
    <Card title="Touched holes">
      <SheetBox {...{report, sheet, describe, paint}} label="The touched holes with their residuals" isFaint />
      <p class="note">
        {residuals.length === 0
          ? "Residuals are not recorded."
          : `Arrows: residuals in the sheet's plane, magnified ${whole(factor)} times.`}
      </p>
    </Card>
  );
}

function touchName(touch: Report): string {
  return isNumber(touch.row) ? tubeName(touch) : textOf(touch.hole, textOf(touch.id));
}

function paintTriangle({context, at, colours}: Painter, places: readonly [number, number][]): void {
  Object.assign(context, {strokeStyle: colours.accent, lineWidth: 1.2});
  context.setLineDash([5, 4]);
  strokeLine(context, ...[...places, places[0]].map(at));
  context.setLineDash([]);
}

/** Quality of the fit as text: its chi-square and the program's verdict. */
function FitWords({report, calibration}: {calibration: Report} & OfReport) {
  const {rms, chi2, degrees_of_freedom: freedom, p_value, verdict, verdict_words: words} = calibration;
  return (
    <p class="note">
      Residuals: rms {short(rms)} {lengthUnit(report)}; chi-square {short(chi2)} on {plural(freedom, "degree")} of
      freedom
      {isNumber(p_value) ? `, ${chance(p_value)}` : ""}.{" "}
      {textOf(words, "") === "" ? null : (
        <b class={verdict === "adequate" ? "" : "bad"}>
          {verdict === "adequate" ? "" : MARKED}
          {words}.
        </b>
      )}
    </p>
  );
}
