// The moments about the arm's rows at the readings, asked of the program while errors are looked at.
import type {MomentsDocument} from "../server/documents";
import {answerTo} from "../server/answers";
import {report, state} from "../server/workbench";
import {view} from "../shell/page_state";

/** What hangs on the readings, as their comparison has them, and on the model; null while nobody looks. */
export function readingsKey(): string | null {
  const now = state.value;
  if (!now?.measurements || view.value !== "error") return null;
  return `${now.measurements.name} ${now.model} ${now.results.compare?.revision ?? -1}`;
}

export const moments = answerTo<MomentsDocument>({
  key: readingsKey,
  path: () => "/api/moments",
  keeps: true,
  onProblem: (error) => report("The moments at the readings", error),
});
