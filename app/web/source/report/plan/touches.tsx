// The touched holes, their residuals and the distances between them.
import {useCallback, useMemo} from "preact/hooks";
import {chance, fixed, isNumber, MISSING, plural, short, whole} from "../../../../drawing/numbers.js";
import type {SheetModel} from "../../../../drawing/sheet_model.js";
import {MARKED, sigmasText, TOUCH_SIGMAS} from "../../../../drawing/sigma_text.js";
import {Card, Lead, Missing, type OfReport, Table} from "../parts";
import {angleUnit, lengthUnit, list, object, type Report, textOf, tubeName, vector} from "../values";
import {holeTeller, predictedMode} from "./cases";
import {magnificationFor, paintArrowScale} from "./centring";
import {type Painter, paintArrow, paintMarks, paintTag, readSheet, SheetBox} from "./sheet_box";

export function TouchesSection({report}: OfReport) {
  const sheet = useMemo(() => readSheet(report), [report]);
  const touches = list(report.touches),
    distances = list(report.distances),
    calibration = object(report.calibration);
  if (touches.length === 0 && distances.length === 0 && !calibration) return <Missing what="The calibration touches" />;
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
          {calibration ? <Calibration report={report} calibration={calibration} /> : <Missing what="The fit" />}
        </Card>
        <Card title="Residual at each touch">
          {touches.length > 0 ? <Residuals report={report} touches={touches} /> : <Missing what="Residuals" />}
        </Card>
        <Card title="Distances between the holes">
          {distances.length > 0 ? (
            <Distances report={report} distances={distances} />
          ) : (
            <Missing what="Distance checks" />
          )}
        </Card>
      </div>
    </>
  );
}

function TouchMap({report, sheet, touches}: {sheet: SheetModel; touches: Report[]} & OfReport) {
  const tell = useMemo(() => holeTeller(report, predictedMode(report)), [report]);
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
      <SheetBox
        report={report}
        sheet={sheet}
        label="The touched holes with their residuals"
        tell={tell}
        paint={paint}
        isFaint
      />
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
  context.beginPath();
  for (const place of places) context.lineTo(...at(place));
  context.closePath();
  context.strokeStyle = colours.accent;
  context.setLineDash([5, 4]);
  context.lineWidth = 1.2;
  context.stroke();
  context.setLineDash([]);
}

/** A residual over its sigma, marked where it is many. */
function InSigmas({value, sigma}: {value: unknown; sigma: unknown}) {
  if (!isNumber(value) || !isNumber(sigma) || sigma <= 0) return <>{MISSING}</>;
  const {text, isMany} = sigmasText(Math.abs(value) / sigma, TOUCH_SIGMAS);
  return isMany ? <b class="bad">{text}</b> : <>{text}</>;
}

function sigmaText(sigma: readonly number[]): string {
  const texts = sigma.map(short);
  return new Set(texts).size === 1 ? texts[0] : texts.join(", ");
}

function Residuals({report, touches}: {touches: Report[]} & OfReport) {
  const unit = lengthUnit(report);
  const rows = touches.map((touch) => {
    const residual = vector(touch.residual),
      sigma = vector(touch.sigma);
    const ratios = residual && sigma ? residual.map((value, axis) => Math.abs(value) / sigma[axis]) : [],
      worst = ratios.indexOf(Math.max(...ratios));
    return [
      textOf(touch.id),
      touchName(touch),
      ...(residual?.map(short) ?? [null, null, null]),
      sigma ? sigmaText(sigma) : null,
      worst < 0 ? null : <InSigmas value={residual![worst]} sigma={sigma![worst]} />,
    ];
  });
  const heads = ["touch", "hole", `dx, ${unit}`, `dy, ${unit}`, `dz, ${unit}`, `sigma, ${unit}`, "/\u00a0sigma"];
  return <Table heads={heads} rows={rows} text={[0, 1]} />;
}

function Distances({report, distances}: {distances: Report[]} & OfReport) {
  const unit = lengthUnit(report);
  const rows = distances.map(({from, to, by_arm, on_sheet, sigma}) => {
    const difference = isNumber(by_arm) && isNumber(on_sheet) ? by_arm - on_sheet : null;
    return [
      `${textOf(from)} – ${textOf(to)}`,
      fixed(by_arm, 4),
      fixed(on_sheet, 4),
      short(difference),
      short(sigma),
      <InSigmas value={difference} sigma={sigma} />,
    ];
  });
  const heads = ["between", `by arm, ${unit}`, `on sheet, ${unit}`, "difference", "sigma", "/\u00a0sigma"];
  return <Table heads={heads} rows={rows} />;
}

function Calibration({report, calibration}: {calibration: Report} & OfReport) {
  const unit = lengthUnit(report),
    {rms, chi2, degrees_of_freedom: freedom, p_value, verdict, verdict_words: words} = calibration;
  const base = object(calibration.base) ?? {},
    sigma = object(calibration.base_sigma) ?? {};
  const rows = (names: string[], value: unknown, spread: unknown, of: string) =>
    names.map((name, i) => [
      `base ${name}`,
      vector(value) ? `${fixed(vector(value)![i], 4)} ${of}` : MISSING,
      vector(spread) ? `± ${short(vector(spread)![i])} ${of}` : MISSING,
    ]);
  return (
    <>
      <Table
        heads={["", "value", "one sigma"]}
        rows={[
          ...rows(["x", "y", "z"], base.position, sigma.position, unit),
          ...rows(["roll", "pitch", "yaw"], base.rpy, sigma.rotation, angleUnit(report)),
        ]}
      />
      <p class="note">
        Residuals: rms {short(rms)} {unit}; chi-square {short(chi2)} on {plural(freedom, "degree")} of freedom
        {isNumber(p_value) ? `, ${chance(p_value)}` : ""}.{" "}
        {textOf(words, "") === "" ? null : verdict === "adequate" ? (
          `${words}.`
        ) : (
          <b class="bad">
            {MARKED}
            {words}.
          </b>
        )}
      </p>
    </>
  );
}
