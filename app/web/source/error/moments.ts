// The moments about the frame axes of the arm's rows at the readings, requested while errors are shown.
import type {MomentsDocument} from "../server/documents";
import {answerTo} from "../server/answers";
import {reporting, state} from "../server/workbench";
import {view} from "../shell/page_state";

/** Returns a key that changes with the compared readings and with the model; null while the view is closed. */
export function readingsKey(): string | null {
  const now = state.value;
  if (!now?.measurements || view.value !== "error") return null;
  return `${now.measurements.name} ${now.model} ${now.results.compare?.revision ?? -1}`;
}

export const moments = answerTo<MomentsDocument>({
  key: readingsKey,
  path: () => "/api/moments",
  keeps: true,
  onProblem: reporting("The moments at the readings"),
});
