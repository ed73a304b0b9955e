// The steps after the verdict as a numbered list: what to do, its evidence, and a button that does or shows it.
import {causeKey} from "../../../drawing/explanations.js";
import {computed} from "@preact/signals";
import {pageWords} from "../server/page_words";
import {currentModel, runningJob, state} from "../server/workbench";
import {dialog} from "../shell/page_state";
import {effectsTab, evidenceTab} from "./tabs";
import {chosenVariable, remainderFormula, suggestedFormula, variables} from "./focus";
import {openFormula} from "./formula_box";
import {type Act, adviceAfter} from "./guidance";
import {hasCause} from "./in_model";
import {selectedReadings} from "./linked";
import {addEffects, currentComparison, currentDiagnosis, removeCauses} from "./loop";

export const advice = computed(() =>
  currentDiagnosis.value
    ? adviceAfter({
        diagnosis: currentDiagnosis.value,
        comparison: currentComparison.value,
        variables: variables.value,
        missingColumns: (state.value?.measurements?.missing_columns ?? []).map(({sentence}) => sentence),
        formula: remainderFormula.value || suggestedFormula.value,
        free: currentModel.value?.free ?? [],
        model: currentModel.value,
      })
    : [],
);

function perform(act: Act): void {
  switch (act.kind) {
    case "add":
      return void addEffects(act.effects);
    case "remove":
      return void removeCauses(act.effects.map(causeKey));
    case "select":
      selectedReadings.value = new Set(act.ids);
      evidenceTab.value = "readings";
      return;
    case "plot":
      chosenVariable.value = act.variable;
      return;
    case "formula":
      return openFormula(act.text);
    case "tab":
      effectsTab.value = act.tab;
      return;
    case "evidence":
      evidenceTab.value = act.tab;
      return;
    case "open":
      dialog.value = "open";
  }
}

/** Returns the mark of a change that the model has already; empty for other actions. */
function doneMark(act: Act): string {
  if (act.kind !== "add" && act.kind !== "remove") return "";
  const isThere = act.effects.map((effect) => hasCause(currentModel.value, effect));
  if (act.kind === "add") return isThere.every(Boolean) ? "✓ added" : "";
  return isThere.some(Boolean) ? "" : "✓ removed";
}

function StepButton({words, button, hint, act}: {words: string; button: string; hint?: string; act: Act}) {
  const done = doneMark(act),
    isBusy = (act.kind === "add" || act.kind === "remove") && runningJob("add", "remove") !== null;
  return (
    <button
      class="button small"
      title={hint || undefined}
      aria-label={`${done || button}: ${words}`}
      disabled={isBusy || done !== ""}
      onClick={() => perform(act)}
    >
      {done || button}
    </button>
  );
}

export function GuidancePanel() {
  return (
    <ol class="guidance">
      {advice.value.map(({name, words, evidence, button, hint, act}) => (
        <li key={name}>
          <div>
            <b>{words}</b>
            <span class="muted">{pageWords(evidence)}</span>
          </div>
          {button && act ? <StepButton words={words} button={button} hint={hint} act={act} /> : null}
        </li>
      ))}
    </ol>
  );
}
