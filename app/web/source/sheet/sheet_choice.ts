// What the sheet's holes are coloured by, and the colouring where it is known.
import {computed, signal} from "@preact/signals";
import type {FieldDocument, PlanDocument, ReachDocument} from "../server/documents";
import {result} from "../server/workbench";
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
export const TITLES: Record<string, string> = {centring: "Predicted error", residual: "Residual", sag: "Sag"};

export const chosen = signal<Choice>("state");

const reach = result<ReachDocument>("reach"),
  field = result<FieldDocument>("field"),
  plan = result<PlanDocument>("plan");

export const colouring = computed<Colouring | null>(() => {
  const model = sheet.value;
  if (!model) return null;
  return madeColouring(model, chosen.value) ?? null;
});

function madeColouring(model: SheetModel, choice: Choice): Colouring | null {
  if (choice === "state") return byState(model);
  if (choice === "reach")
    return fits(reach.value.document?.reachable, model) ? byReach(model, reach.value.document!) : null;
  if (choice === "steps") return plan.value.document ? bySteps(model, plan.value.document, "predicted") : null;
  const found = field.value.document;
  return found && found.of === choice && fits(found.values, model) ? byField(model, found, TITLES[choice]) : null;
}

function fits(values: unknown[] | undefined, model: SheetModel): boolean {
  return values !== undefined && values.length === model.count;
}
