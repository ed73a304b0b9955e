// The inputs of a plan, and the button that requests it.
import {signal} from "@preact/signals";
import {plural} from "../../../drawing/numbers.js";
import {Check, Select} from "../drawing/fields";
import {choicesOf} from "../drawing/segments";
import {cell, runJob, runningJob} from "../server/workbench";
import {dwellTimesOfSelection, selection} from "../shell/page_state";
import {DwellCount, WorkListButton} from "./work_list_button";

const WAYS = choicesOf([
  ["via-point", "via point"],
  ["goal-point", "goal point"],
  ["none", "no compensation"],
]);
const compensation = signal("via-point");
const isOnLines = signal(false);
const isParked = signal(false);

/** Plans the selected holes, or if there are none the given ones, as chosen in the order. */
export function startPlan(others: readonly number[] = []): Promise<boolean> {
  return runJob("Plan", "/api/plan", {
    tubes: [...(selection.value.size > 0 ? selection.value : others)].sort((a, b) => a - b),
    compensation: compensation.value,
    travel: isOnLines.value && compensation.value === "via-point" ? "line" : "joints",
    load: 0,
    seed: 1,
    stays: dwellTimesOfSelection.value,
    ...(isParked.value && cell.value?.has_park ? {start: "park", end: "park"} : {}),
  });
}

export function PlanOrder() {
  const count = selection.value.size,
    job = runningJob("plan");
  return (
    <>
      <Select
        label="Compensation"
        choices={WAYS}
        value={compensation.value}
        onChoose={(way) => (compensation.value = way)}
      />
      {compensation.value === "via-point" ? (
        <Check
          of={isOnLines}
          title="the tip moves straight from tube to tube, where that is possible without collision"
        >
          straight
        </Check>
      ) : null}
      {cell.value?.has_park ? (
        <Check of={isParked} title="start from the park posture and return to it">
          park
        </Check>
      ) : null}
      <WorkListButton />
      <DwellCount />
      <button class="button first" disabled={count === 0 || job !== null} onClick={() => startPlan()}>
        {job ? "Planning …" : `Plan ${plural(count, "tube")}`}
      </button>
    </>
  );
}
