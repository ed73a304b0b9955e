// Under the hole, magnified: the hole's rim, the steps of the calibration tool where the tool stands, and how far off it
// is.
import {useEffect, useRef} from "preact/hooks";
import {palette, type Palette} from "../drawing/colours";
import {fixed, jointDecimals, lengthAndUnit} from "../../../drawing/numbers.js";
import {stepKinds} from "../../../drawing/steps.js";
import type {PoseDocument} from "../server/documents";
import {currentModel, sheetDocument, units} from "../server/workbench";
import {sheet} from "../shell/page_state";
import {clearedContext} from "../drawing/canvas";
import {MarkIcon} from "../drawing/marks";
import {holeName} from "../sheet/sheet_model";
import {poseRequest} from "./pose_link";

/** The tool's steps as shares of the hole; none where the cell does not say. */
function stepShares(): number[] {
  const document = sheetDocument.peek().document;
  const diameters = document?.tool?.diameters;
  return diameters && document.hole_diameter > 0 ? diameters.map((diameter) => diameter / document.hole_diameter) : [];
}

export function ToolInset() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const centring = poseRequest.answer.value?.centring ?? null;
  useEffect(() => {
    if (canvas.current) draw(canvas.current, centring, palette.value);
  }, [centring, palette.value]);
  const hole = poseRequest.hole.value;
  const name = hole >= 0 && sheet.value ? holeName(sheet.value, hole) : "no hole picked";
  const base = currentModel.value?.base;
  const kind = stepKinds({...sheetDocument.value.document?.tool, base})[centring?.steps ?? -1];
  return (
    <section class="inset" aria-label="The tool under the hole">
      <header>
        <b>{name}</b>
        <span class="muted">from below</span>
      </header>
      <canvas ref={canvas} width={2} height={2} />
      <dl class="figures">
        <dt>off centre</dt>
        <dd>{lengthAndUnit(centring?.distance, units.value.length, 4)}</dd>
        <dt>tilt</dt>
        <dd>{centring ? `${fixed(centring.tilt, jointDecimals(units.value.angle))} ${units.value.angle}` : "–"}</dd>
        <dt>height</dt>
        <dd>{lengthAndUnit(centring?.height, units.value.length, 4)}</dd>
      </dl>
      <p class="inset-case">
        {kind ? (
          <>
            <MarkIcon mark={kind.mark} /> {kind.name}
            {base ? <span class={base.placed ? "muted" : "bad"}> {base.words}</span> : null}
          </>
        ) : (
          "pick a hole on the sheet"
        )}
      </p>
    </section>
  );
}

function draw(canvas: HTMLCanvasElement, centring: PoseDocument["centring"], colours: Palette): void {
  const side = canvas.clientWidth;
  const context = clearedContext(canvas, side, side);
  const r = 0.36 * side,
    middle = side / 2;
  const radius = sheet.peek()?.holeRadius ?? 0.38;
  circle(context, middle, middle, r, colours.ink, 2);
  cross(context, middle, middle, 5, colours.muted);
  if (!centring) return;
  const most = 0.62 * side;
  const x = middle + clamp((centring.offset[0] / radius) * r, most),
    y = middle - clamp((centring.offset[1] / radius) * r, most);
  stepShares().forEach((share, index) => {
    const isIn = (centring.steps ?? 0) > index;
    circle(context, x, y, share * r, isIn ? colours.accent : colours.case0, 1.3, isIn ? [] : [4, 3]);
  });
  cross(context, x, y, 4, colours.accent);
  context.strokeStyle = colours.accent;
  context.beginPath();
  context.moveTo(middle, middle);
  context.lineTo(x, y);
  context.stroke();
}

function clamp(value: number, most: number): number {
  return Math.max(-most, Math.min(most, value));
}

function circle(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  r: number,
  colour: string,
  width: number,
  dash: number[] = [],
): void {
  context.beginPath();
  context.arc(x, y, r, 0, 2 * Math.PI);
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
}

function cross(context: CanvasRenderingContext2D, x: number, y: number, r: number, colour: string): void {
  context.beginPath();
  context.moveTo(x - r, y);
  context.lineTo(x + r, y);
  context.moveTo(x, y - r);
  context.lineTo(x, y + r);
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.stroke();
}
