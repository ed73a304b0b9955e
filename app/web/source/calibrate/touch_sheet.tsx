// The sheet with rings at the holes to touch, drawn over the model's error at each hole.
import {signal} from "@preact/signals";
import {useCallback, useMemo} from "preact/hooks";
import {drawRings, strokeLine, TYPEFACE} from "../drawing/canvas";
import type {Palette} from "../drawing/colours";
import {Check} from "../drawing/fields";
import {MarkIcon} from "../drawing/marks";
import {cell, runJob, runningJob} from "../server/workbench";
import {picked} from "../shell/page_state";
import {byField, byState} from "../sheet/colourings";
import {toPixel} from "../../../drawing/frames.js";
import type {PaintOver} from "../sheet/sheet_drawing";
import {holeName, type SheetModel} from "../sheet/sheet_model";
import {SheetPanel} from "../sheet/with_sheet";
import {suspicionOf} from "./suspicion";
import {field, holeOf, outcome, proposals, touches} from "./touches";

type Place = readonly [number, number];

const isHeat = signal(true);

export function TouchSheet({model}: {model: SheetModel}) {
  const found = field.value.document;
  const isField = isHeat.value && found?.of === "centring" && found.values.length === model.count;
  const colouring = useMemo(
    () => (isField ? byField(model, found!, "Predicted error") : byState(model)),
    [model, isField, found],
  );
  const calibrated = outcome.value.document;
  const suggested = useMemo(
    () => (proposals.value.document?.next_readings ?? []).map((reading) => holeOf(model, reading.point)),
    [model, proposals.value.document],
  );
  const paintOver = useCallback<PaintOver>(
    (context, camera, size, colours) => {
      const ring = (hole: number, colour: string, words: string, dash: number[]) => {
        if (hole < 0) return;
        const place = toPixel(camera, size, model.u[hole], model.v[hole]);
        context.setLineDash(dash);
        context.strokeStyle = colour;
        context.lineWidth = 3;
        drawRings(context, [place], 12);
        context.setLineDash([]);
        label(context, words, place, size.width, colours);
      };
      const done = touches.peek().map((touch) => touch.hole);
      suggested.forEach((hole, i) => {
        if (!done.includes(hole)) ring(hole, colours.accent, `best ${i + 1}: ${holeName(model, hole)}`, [5, 4]);
      });
      for (const {id, hole} of touches.peek()) {
        const suspicion = suspicionOf(calibrated, id);
        const name = `${id}: ${holeName(model, hole)}`;
        if (!suspicion) ring(hole, colours.good, name, []);
        else {
          ring(hole, suspicion.isOutlier ? colours.bad : colours.case1, `${name} ${suspicion.words}`, [2, 3]);
          crossOver(context, toPixel(camera, size, model.u[hole], model.v[hole]));
        }
      }
    },
    [model, suggested, touches.value, calibrated],
  );
  return (
    <SheetPanel
      head={<TouchHead />}
      foot={
        isField ? (
          colouring.kinds.map((kind) => (
            <span title={colouring.meaning}>
              <MarkIcon mark={kind.mark} size={12} /> {kind.name}
            </span>
          ))
        ) : (
          <span class="muted">
            Predict shows how far off each hole{" "}
            {cell.value?.has_truth ? "the true arm is, sent by this model" : "the tool is without compensation"}.
          </span>
        )
      }
      sheet={model}
      colouring={colouring}
      picked={picked}
      paintOver={paintOver}
      onPick={(hole) => (picked.value = hole)}
    />
  );
}

/** Draws a cross over the ring of a suspected touch, in the ring's colour; the cross is recognizable without colour. */
function crossOver(context: CanvasRenderingContext2D, [x, y]: Place): void {
  const reach = 15;
  for (const side of [-reach, reach]) strokeLine(context, [x - side, y - reach], [x + side, y + reach]);
}

function TouchHead() {
  return (
    <>
      <h2>Touches</h2>
      <div class="end">
        <Check of={isHeat}>predicted error</Check>
        <button
          class="button"
          disabled={runningJob("field") !== null}
          onClick={() => {
            isHeat.value = true;
            void runJob("Predicted error", "/api/field", {of: "centring"});
          }}
        >
          Predict
        </button>
      </div>
    </>
  );
}

function label(context: CanvasRenderingContext2D, words: string, [x, y]: Place, width: number, colours: Palette): void {
  context.font = `600 12px ${TYPEFACE}`;
  const long = context.measureText(words).width;
  const left = x + 18 + long > width - 8 ? x - 18 - long : x + 18;
  Object.assign(context, {textAlign: "left", textBaseline: "middle", fillStyle: colours.panel, globalAlpha: 0.85});
  context.fillRect(left - 4, y - 10, long + 8, 20);
  Object.assign(context, {fillStyle: colours.ink, globalAlpha: 1});
  context.fillText(words, left, y);
}
