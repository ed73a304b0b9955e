// What a plan is asked with, and the button that asks for it.
import {signal} from "@preact/signals";
import {plural} from "../../../drawing/numbers.js";
import {cell, runJob, runningJob} from "../server/workbench";
import {selection, staysOfSelection} from "../shell/page_state";
import {StayCount, WorkListButton} from "./work_list_button";

const compensation = signal("via-point");
const isOnLines = signal(false);
const isParked = signal(false);

function startPlan(): Promise<boolean> {
  return runJob("Plan", "/api/plan", {
    tubes: [...selection.value].sort((a, b) => a - b),
    compensation: compensation.value,
    travel: isOnLines.value && compensation.value === "via-point" ? "line" : "joints",
    load: 0,
    seed: 1,
    stays: staysOfSelection.value,
    ...(isParked.value && cell.value?.has_park ? {start: "park", end: "park"} : {}),
  });
}

export function PlanOrder() {
  const count = selection.value.size,
    job = runningJob("plan");
  return (
    <>
      <select
        aria-label="Compensation"
        value={compensation.value}
        onChange={(event) => (compensation.value = event.currentTarget.value)}
      >
        <option value="via-point">via point</option>
        <option value="goal-point">goal point</option>
        <option value="none">no compensation</option>
      </select>
      {compensation.value === "via-point" ? (
        <label class="check" title="the tip straight from tube to tube, wherever that is possible and free">
          <input type="checkbox" checked={isOnLines.value} onChange={() => (isOnLines.value = !isOnLines.value)} />{" "}
          straight
        </label>
      ) : null}
      {cell.value?.has_park ? (
        <label class="check" title="set out from the park posture and come back to it">
          <input type="checkbox" checked={isParked.value} onChange={() => (isParked.value = !isParked.value)} /> park
        </label>
      ) : null}
      <WorkListButton />
      <StayCount />
      <button class="button first" disabled={count === 0 || job !== null} onClick={startPlan}>
        {job ? "Planning …" : `Plan ${plural(count, "tube")}`}
      </button>
    </>
  );
}
