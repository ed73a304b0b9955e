// The touches: those made, those proposed, and the chosen hole, whose joint values are entered or simulated.
import {submitting, withPoint} from "../drawing/fields";
import {Icon} from "../drawing/icons";
import {Panel} from "../drawing/panel";
import {fixed, jointDecimals, plural} from "../../../drawing/numbers.js";
import type {CalibrateDocument} from "../server/documents";
import {get, remove} from "../server/requests";
import {attempt, cell, order, runJob, runningJob, state, units} from "../server/workbench";
import {joinReadings} from "../error/run_sheet";
import {markReadings} from "../error/reading_marks";
import {picked} from "../shell/page_state";
import {holeName, type SheetModel} from "../sheet/sheet_model";
import {touchTable} from "./touch_readings";
import {holeOf, proposals, touches, touchReadings} from "./touches";

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
      {done.map((touch, index) => (
        <div class="touch-row done" key={touch.id}>
          <b>{touch.id}</b>
          <span>{holeName(model, touch.hole)}</span>
          <span class="joint-list">
            {jointsText(touch.joints)}
            {touch.simulated ? <small class="muted"> simulated</small> : null}
          </span>
          <button
            class="tool"
            title={areReadings ? "Set this touch aside" : "Remove this touch"}
            onClick={() => (areReadings ? markReadings("aside", [touch.id], true) : takeAway(index))}
          >
            <Icon name="close" size={14} />
          </button>
        </div>
      ))}
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

/** Calibrates the base and, if that succeeds, computes the centring error at each hole with the new base. */
async function calibrate(): Promise<void> {
  if (!(await runJob("Calibrate", "/api/calibrate"))) return;
  const {status} = await get<CalibrateDocument>("/api/results/calibrate");
  if (status === "done") await runJob("Predicted error", "/api/field", {of: "centring"});
}

function takeAway(index: number): Promise<boolean> {
  return attempt("The touch stays", () => remove(`/api/touch/${index}`));
}

function TouchForm({name, hole}: {name: string; hole: number}) {
  const joints = cell.value?.joints ?? [];
  const touch = (body: object) => order(`Touch of ${name}`, "/api/touch", {hole, ...body});
  const others = touchReadings.value;
  return (
    <form
      class="touch-row"
      onSubmit={submitting((form) => {
        const typed = new FormData(form);
        const values = joints.map((joint) => Number(withPoint(String(typed.get(joint.name)))));
        return others.length > 0
          ? joinReadings(touchTable({point: name, values}, others, joints, units.value.force))
          : touch({joints: values});
      })}
    >
      <span>{name}</span>
      <span class="joint-inputs">
        {joints.map((joint) => (
          <input
            name={joint.name}
            inputMode="decimal"
            placeholder={joint.name}
            aria-label={`${joint.name} at ${name}`}
            required
          />
        ))}
      </span>
      <span class="touch-buttons">
        <button class="button" type="submit">
          Enter
        </button>
        {others.length === 0 ? (
          <button class="button" type="button" onClick={() => touch({simulate: true})}>
            Simulate
          </button>
        ) : null}
      </span>
    </form>
  );
}
