// Possibly missing effects, readings that would distinguish explanations, the user's own formula, and the fitted
// parameters.
import {plural} from "../../../drawing/numbers.js";
import {Panel} from "../drawing/panel";
import {choicesOf} from "../drawing/segments";
import {Tabs} from "../drawing/tabs";
import type {Model} from "../server/documents";
import {runningJob, state} from "../server/workbench";
import {OtherModel} from "../shell/other_model";
import {ProblemWords, Waiting} from "../shell/states";
import {baseRows} from "./base_rows";
import {EffectRanking} from "./effect_ranking";
import {EffectWarnings} from "./effect_warnings";
import {FormulaBox} from "./formula_box";
import {advice, GuidancePanel} from "./guidance_panel";
import {diagnose, identify} from "./loop";
import {ParameterTable} from "./parameter_table";
import {withFormulas} from "./in_model";
import {runSheet} from "./run_sheet";
import {Splitting} from "./splitting";
import {effectsTab, type EffectsTab} from "./tabs";

export function EffectsPanel() {
  const document = diagnose.value.document;
  const splits = document ? document.next_readings.length : 0;
  const tabs = choicesOf<EffectsTab>([
    ["effects", "What is missing"],
    ...(advice.value.length > 0 ? [["steps", `Next steps · ${advice.value.length}`] as const] : []),
    ["split", document && document.explanations.length > 1 ? `A or B${splits > 0 ? ` · ${splits}` : ""}` : "A or B"],
    ["formula", "Formula"],
    ["numbers", "Numbers"],
  ]);
  const choice = (
    <Tabs label="What is missing" tabs={tabs} value={openTab()} onChoose={(next) => (effectsTab.value = next)} />
  );
  return (
    <Panel head={choice} end={<OtherModel name={openTab() === "numbers" ? "identify" : "diagnose"} />} role="tabpanel">
      <TabBody />
    </Panel>
  );
}

/** Returns the open tab: the chosen one, or the first if the verdict with the steps of that tab is gone. */
function openTab(): EffectsTab {
  return effectsTab.value === "steps" && advice.value.length === 0 ? "effects" : effectsTab.value;
}

/** Returns the model with this id; undefined if it no longer exists. */
function modelOf(id: number): Model | undefined {
  return state.value?.models.find((model) => model.id === id);
}

function TabBody() {
  const found = diagnose.value,
    tab = openTab();
  if (tab === "steps") return <GuidancePanel />;
  if (tab === "formula") return <FormulaBox />;
  if (tab === "numbers") {
    const fitted = identify.value.document;
    return fitted ? (
      <ParameterTable parameters={[...withFormulas(fitted.parameters, modelOf(fitted.model)), ...baseRows(fitted)]} />
    ) : (
      <p class="muted">Fitted numbers appear here after an effect is added.</p>
    );
  }
  if (tab === "split" && (found.document || runSheet.value)) return <Splitting document={found.document} />;
  if (runningJob("diagnose")) return <Waiting words="Trying every effect at every place" isBusy />;
  if (found.problem) return <ProblemWords problem={found.problem} />;
  if (!found.document) {
    return (
      <div class="nothing">
        <p>
          {plural(state.value?.measurements?.readings ?? 0, "reading")} here. Diagnose tries every effect of the
          catalogue at every place of the arm.
        </p>
      </div>
    );
  }
  return (
    <>
      <EffectWarnings warnings={found.document.warnings} model={modelOf(found.document.model)} />
      <EffectRanking document={found.document} />
    </>
  );
}
