// The list of touches: made, proposed, and the hole that is picked; joints are entered or simulated.
import {Icon} from "../drawing/icons";
import {fixed, jointDecimals} from "../../../drawing/numbers.js";
import type {CalibrateDocument} from "../server/documents";
import {get, remove} from "../server/requests";
import {cell, order, report, runJob, runningJob} from "../server/workbench";
import {picked} from "../shell/page_state";
import {holeName, type SheetModel} from "../sheet/sheet_model";
import {holeOf, proposals, touches} from "./touches";

function jointsText(values: readonly number[]): string {
  return values.map((value, k) => fixed(value, jointDecimals(cell.value?.joints[k]?.unit ?? ""))).join("  ");
}

export function TouchPanel({model}: {model: SheetModel}) {
  const suggested = (proposals.value.document?.next_readings ?? []).map((reading) => ({
    hole: holeOf(model, reading.point),
    joints: reading.joints,
  }));
  const done = touches.value;
  const open = suggested.filter((entry) => entry.hole >= 0 && !done.some((touch) => touch.hole === entry.hole));
  const own =
    picked.value >= 0 &&
    !done.some((touch) => touch.hole === picked.value) &&
    !open.some((entry) => entry.hole === picked.value);
  return (
    <section class="panel">
      <header>
        <h2>{done.length === 0 ? "Three holes to touch" : `${done.length} touched`}</h2>
        <div class="end">
          <button
            class="button"
            disabled={runningJob("touches") !== null}
            onClick={() => runJob("Which holes to touch", "/api/touches", {goal: "base"})}
          >
            Suggest
          </button>
        </div>
      </header>
      <div class="panel-body touch-list">
        {done.map((touch, index) => (
          <div class="touch-row done" key={touch.id}>
            <b>{touch.id}</b>
            <span>{holeName(model, touch.hole)}</span>
            <span class="joint-list">
              {jointsText(touch.joints)}
              {touch.simulated ? <small class="muted"> simulated</small> : null}
            </span>
            <button class="tool" title="Take this touch away" onClick={() => takeAway(index)}>
              <Icon name="close" size={14} />
            </button>
          </div>
        ))}
        {open.map((entry) => (
          <TouchForm key={entry.hole} name={holeName(model, entry.hole)} hole={entry.hole} />
        ))}
        {own ? <TouchForm key={picked.value} name={holeName(model, picked.value)} hole={picked.value} /> : null}
        {done.length + open.length === 0 && !own ? (
          <p class="muted">Suggest marks the three most informative holes, or pick one on the sheet.</p>
        ) : null}
        <button
          class="button first"
          disabled={done.length < 3 || runningJob("calibrate") !== null}
          onClick={() => void calibrate()}
        >
          {done.length < 3 ? `Calibrate (${3 - done.length} more)` : "Calibrate"}
        </button>
      </div>
    </section>
  );
}

/** The base once found, the error that its doubt leaves is worked out anew. */
async function calibrate(): Promise<void> {
  if (!(await runJob("Calibrate", "/api/calibrate"))) return;
  const {status} = await get<CalibrateDocument>("/api/results/calibrate");
  if (status === "done") await runJob("Predicted error", "/api/field", {of: "centring"});
}

function takeAway(index: number): void {
  remove(`/api/touch/${index}`).catch((error) => report("The touch stays", error));
}

function TouchForm({name, hole}: {name: string; hole: number}) {
  const joints = cell.value?.joints ?? [];
  const touch = (body: object) => order(`Touch of ${name}`, "/api/touch", {hole, ...body});
  return (
    <form
      class="touch-row"
      onSubmit={(event) => {
        event.preventDefault();
        const values = joints.map((joint) => Number(new FormData(event.currentTarget).get(joint.name)));
        void touch({joints: values});
      }}
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
        <button class="button" type="button" onClick={() => touch({simulate: true})}>
          Simulate
        </button>
      </span>
    </form>
  );
}
