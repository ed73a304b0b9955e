// Choice of the sheet's colouring, and the resulting colouring if its data are known.
import {computed, effect, signal} from "@preact/signals";
import type {FieldDocument, Model, PlanDocument, ReachDocument} from "../server/documents";
import {answerTo} from "../server/answers";
import {reporting, result, runJob, state} from "../server/workbench";
import {sheet} from "../shell/page_state";
import {byField, byReach, byState, bySteps, type Colouring} from "./colourings";
import type {SheetModel} from "./sheet_model";

export type Choice = "state" | "reach" | "steps" | "centring" | "residual" | "sag";

export const CHOICES: [Choice, string][] = [
  ["state", "State"],
  ["reach", "Reach"],
  ["steps", "Steps"],
  ["centring", "Predicted error"],
  ["residual", "Residual"],
  ["sag", "Sag"],
];
const TITLES: Record<string, string> = {centring: "Predicted error", residual: "Residual", sag: "Sag"};

export const chosen = signal<Choice>("state");

const reach = result<ReachDocument>("reach"),
  field = result<FieldDocument>("field"),
  plan = result<PlanDocument>("plan");

// ---- before and after: the field of the model below the current model, on a common scale

/** Model below the current model on the stack; null if there is none. */
export const modelBefore = computed<Model | null>(() => {
  const now = state.value;
  const at = now?.models.findIndex((model) => model.id === now.model) ?? -1;
  return at > 0 ? now!.models[at - 1] : null;
});

/** True if the sheet shows the field of the model before instead of the current model. */
export const isBefore = signal(false);
const modelNow = computed(() => state.value?.model);
effect(() => {
  void modelNow.value;
  isBefore.value = false;
});

const fieldBefore = answerTo<FieldDocument>({
  key: () => {
    const id = modelBefore.value?.id,
      mark = state.value?.results.field;
    return id !== undefined && mark?.models.includes(id) ? `${id} ${mark.revision} ${state.value?.revision}` : "";
  },
  path: () => `/api/results/field?model=${modelBefore.peek()!.id}`,
  keeps: true,
  onProblem: reporting("The model before"),
});

/** Computes the field of a colouring for the model that is shown. */
export async function computeField(choice: Choice): Promise<void> {
  const model = isBefore.peek() ? modelBefore.peek()?.id : undefined;
  await runJob(TITLES[choice], "/api/field", {of: choice, model});
}

/**
 * Shows the field of the model before (true) or of the current model (false), and computes the field if it is missing.
 */
export function showBefore(before: boolean): void {
  isBefore.value = before;
  if (colouring.peek() === null) void computeField(chosen.peek());
}

export const colouring = computed<Colouring | null>(() => {
  return sheet.value ? madeColouring(sheet.value, chosen.value) : null;
});

function madeColouring(model: SheetModel, choice: Choice): Colouring | null {
  if (choice === "state") return byState(model);
  if (choice === "reach")
    return fits(reach.value.document?.reachable, model) ? byReach(model, reach.value.document!) : null;
  if (choice === "steps") return plan.value.document ? bySteps(model, plan.value.document, "predicted") : null;
  const [own, before] = [field, fieldBefore].map(({value: {document}}) =>
    isOf(document, choice, model) ? document : null,
  );
  const now = own?.model === state.value?.model ? own : null,
    shown = isBefore.value ? before : now;
  const both = [now, before].filter((document) => document !== null);
  return shown ? byField(model, shown, TITLES[choice], both) : null;
}

function isOf(document: FieldDocument | null, choice: Choice, model: SheetModel): boolean {
  return document !== null && document.of === choice && fits(document.values, model);
}

function fits(values: unknown[] | undefined, model: SheetModel): boolean {
  return values !== undefined && values.length === model.count;
}
