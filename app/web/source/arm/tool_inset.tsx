// Magnified view of the hole from below: the rim of the hole, the steps of the calibration tool at their position, and
// the centring error.
import {useEffect, useRef} from "preact/hooks";
import {Figures} from "../drawing/panel";
import {palette, type Palette} from "../drawing/colours";
import {fixed, jointDecimals, lengthAndUnit, MISSING} from "../../../drawing/numbers.js";
import {stepKinds} from "../../../drawing/steps.js";
import type {PoseDocument} from "../server/documents";
import {currentModel, sheetDocument, units} from "../server/workbench";
import {sheet} from "../shell/page_state";
import {clearedContext, drawRings, strokeLine} from "../drawing/canvas";
import {MarkIcon} from "../drawing/marks";
import {holeName} from "../sheet/sheet_model";
import {poseRequest} from "./pose_link";

/** Returns the diameters of the tool's steps relative to the hole's diameter; empty if the cell states no tool. */
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
  const base = currentModel.value?.base,
    {length, angle} = units.value;
  const kind = stepKinds({...sheetDocument.value.document?.tool, base})[centring?.steps ?? -1];
  return (
    <section class="inset" aria-label="The tool under the hole">
      <header>
        <b>{name}</b>
        <span class="muted">from below</span>
      </header>
      <canvas ref={canvas} width={2} height={2} />
      <Figures
        rows={[
          ["off centre", lengthAndUnit(centring?.distance, length, 4)],
          ["tilt", centring ? `${fixed(centring.tilt, jointDecimals(angle))} ${angle}` : MISSING],
          ["height", lengthAndUnit(centring?.height, length, 4)],
        ]}
      />
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
  circle(context, middle, middle, r, {colour: colours.ink, width: 2});
  cross(context, middle, middle, 5, colours.muted);
  if (!centring) return;
  const most = 0.62 * side;
  const x = middle + clamp((centring.offset[0] / radius) * r, most),
    y = middle - clamp((centring.offset[1] / radius) * r, most);
  stepShares().forEach((share, index) => {
    const isIn = (centring.steps ?? 0) > index;
    const look = {colour: isIn ? colours.accent : colours.case0, width: 1.3, dash: isIn ? [] : [4, 3]};
    circle(context, x, y, share * r, look);
  });
  cross(context, x, y, 4, colours.accent);
  strokeLine(context, [middle, middle], [x, y]);
}

interface Look {
  colour: string;
  width: number;
  dash?: number[];
}

function clamp(value: number, most: number): number {
  return Math.max(-most, Math.min(most, value));
}

function circle(context: CanvasRenderingContext2D, x: number, y: number, r: number, look: Look): void {
  Object.assign(context, {strokeStyle: look.colour, lineWidth: look.width});
  context.setLineDash(look.dash ?? []);
  drawRings(context, [[x, y]], r);
  context.setLineDash([]);
}

function cross(context: CanvasRenderingContext2D, x: number, y: number, r: number, colour: string): void {
  Object.assign(context, {strokeStyle: colour, lineWidth: 1});
  strokeLine(context, [x - r, y], [x + r, y]);
  strokeLine(context, [x, y - r], [x, y + r]);
}
