// The moments about the arm's rows at the readings, asked of the program while errors are looked at.
import {computed, effect, signal} from "@preact/signals";
import type {MomentsDocument} from "../server/documents";
import {get, isMissing} from "../server/requests";
import {report, state} from "../server/workbench";
import {view} from "../shell/page_state";

export const moments = signal<MomentsDocument | null>(null);

/** What they hang on: the readings, as their comparison has them, and the model. */
const key = computed(() => {
  const now = state.value;
  if (!now?.measurements || view.value !== "error") return "";
  return `${now.measurements.name} ${now.model} ${now.results.compare?.revision ?? -1}`;
});

let fetched = "";
effect(() => {
  const wanted = key.value;
  if (wanted === "" || wanted === fetched) return;
  fetched = wanted;
  get<MomentsDocument>("/api/moments").then(
    (found) => {
      if (fetched === wanted) moments.value = found;
    },
    (error) => {
      if (fetched !== wanted) return;
      moments.value = null;
      if (!isMissing(error)) report("The moments at the readings", error);
    },
  );
});
