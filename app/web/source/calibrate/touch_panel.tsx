// The touches: those made, those proposed, and the chosen hole, whose joint values are entered or simulated.
import {signal} from "@preact/signals";
import {Icon} from "../drawing/icons";
import {Panel} from "../drawing/panel";
import {fixed, jointDecimals, plural} from "../../../drawing/numbers.js";
import type {CalibrateDocument, TouchList} from "../server/documents";
import {get} from "../server/requests";
import {cell, runJob, runningJob, state} from "../server/workbench";
import {markReadings} from "../error/reading_marks";
import {picked} from "../shell/page_state";
import {holeName, type SheetModel} from "../sheet/sheet_model";
import {removeTouch, TouchForm} from "./touch_form";
import {holeOf, proposals, touches, touchReadings} from "./touches";

/** Id of the touch whose joint values are being corrected; empty if none is. */
const edited = signal("");

function jointsText(values: readonly number[]): string {
  return values.map((value, k) => fixed(value, jointDecimals(cell.value?.joints[k]?.unit ?? ""))).join("  ");
}

export function TouchPanel({model}: {model: SheetModel}) {
  const done = touches.value,
    areReadings = touchReadings.value.length > 0;
  const isDone = (hole: number) => hole < 0 || done.some((touch) => touch.hole === hole);
  const open = (proposals.value.document?.next_readings ?? [])
    .map(({point}) => holeOf(model, point))
    .filter((hole) => !isDone(hole));
  if (!isDone(picked.value) && !open.includes(picked.value)) open.push(picked.value);
  const suggest = (
    <button
      class="button"
      disabled={runningJob("touches") !== null}
      onClick={() => runJob("Which holes to touch", "/api/touches", {goal: "base"})}
    >
      Suggest
    </button>
  );
  return (
    <Panel
      title={done.length === 0 ? "Three holes to touch" : `${done.length} touched`}
      end={suggest}
      body="touch-list"
    >
      {areReadings ? <p class="muted">The touches of {state.value?.measurements?.name}, which are readings.</p> : null}
      {done.map((touch, index) =>
        edited.value === touch.id ? (
          <TouchForm
            key={touch.id}
            name={holeName(model, touch.hole)}
            hole={touch.hole}
            old={{...touch, index}}
            onDone={() => (edited.value = "")}
          />
        ) : (
          <DoneTouch key={touch.id} model={model} touch={touch} index={index} isReading={areReadings} />
        ),
      )}
      {open.map((hole) => (
        <TouchForm key={hole} name={holeName(model, hole)} hole={hole} />
      ))}
      {done.length + open.length === 0 ? (
        <p class="muted">Suggest marks the three most informative holes, or pick one on the sheet.</p>
      ) : null}
      <button
        class="button first"
        disabled={done.length < 3 || runningJob("calibrate") !== null}
        onClick={() => void calibrate()}
      >
        {done.length < 3 ? `Calibrate (needs ${plural(3 - done.length, "more touch", "more touches")})` : "Calibrate"}
      </button>
    </Panel>
  );
}

interface DoneTouchProps {
  model: SheetModel;
  touch: TouchList["touches"][number];
  index: number;
  /** True for a touch of a file, which is set aside instead of removed, and corrected in its file. */
  isReading: boolean;
}

function DoneTouch({model, touch, index, isReading}: DoneTouchProps) {
  return (
    <div class="touch-row done">
      <b>{touch.id}</b>
      <span>{touch.hole < 0 ? touch.name : holeName(model, touch.hole)}</span>
      <button
        class="joint-list"
        title={isReading ? "Joint values of the file" : "Correct the joint values"}
        disabled={isReading}
        onClick={() => (edited.value = touch.id)}
      >
        {jointsText(touch.joints)}
        {touch.simulated ? <small class="muted"> simulated</small> : null}
      </button>
      <button
        class="tool"
        title={isReading ? "Set this touch aside" : "Remove this touch"}
        onClick={() => (isReading ? markReadings("aside", [touch.id], true) : removeTouch(index))}
      >
        <Icon name="close" size={14} />
      </button>
    </div>
  );
}

/** Calibrates the base and, if that succeeds, computes the centring error at each hole with the new base. */
async function calibrate(): Promise<void> {
  if (!(await runJob("Calibrate", "/api/calibrate"))) return;
  const {status} = await get<CalibrateDocument>("/api/results/calibrate");
  if (status === "done") await runJob("Predicted error", "/api/field", {of: "centring"});
}
