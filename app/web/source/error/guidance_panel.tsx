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

export function GuidancePanel() {
  return (
    <ol class="guidance">
      {advice.value.map(({name, words, evidence, button, act}) => (
        <li key={name}>
          <div>
            <b>{words}</b>
            <span class="muted">{pageWords(evidence)}</span>
          </div>
          {button && act ? (
            <button
              class="button small"
              aria-label={`${button}: ${words}`}
              disabled={(act.kind === "add" || act.kind === "remove") && runningJob("add", "remove") !== null}
              onClick={() => perform(act)}
            >
              {button}
            </button>
          ) : null}
        </li>
      ))}
    </ol>
  );
}
