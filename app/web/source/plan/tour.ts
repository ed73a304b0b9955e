// The planned holes in the order of visiting, and selected holes that are not planned.
import {computed} from "@preact/signals";
import {selection, sheet} from "../shell/page_state";
import {plan} from "./playback";

export const tour = computed<number[]>(() => {
  const model = sheet.value,
    document = plan.value.document;
  return model && document ? document.tubes.map((tube) => model.find(tube.row, tube.column)) : [];
});

/** Selected holes that are not in the plan yet. */
export const unplanned = computed<ReadonlySet<number>>(() => {
  const planned = new Set(tour.value);
  return new Set([...selection.value].filter((hole) => !planned.has(hole)));
});
