// Possibly missing effects, readings that would distinguish explanations, the user's own formula, and the fitted
// parameters.
import {signal} from "@preact/signals";
import {plural} from "../../../drawing/numbers.js";
import {Panel} from "../drawing/panel";
import {choicesOf} from "../drawing/segments";
import {Tabs} from "../drawing/tabs";
import {pageWords} from "../server/page_words";
import {runningJob, state} from "../server/workbench";
import {OtherModel} from "../shell/other_model";
import {ProblemWords, Waiting} from "../shell/states";
import {EffectRanking} from "./effect_ranking";
import {FormulaBox} from "./formula_box";
import {diagnose, identify} from "./loop";
import {ParameterTable} from "./parameter_table";
import {runSheet} from "./run_sheet";
import {Splitting} from "./splitting";

type Tab = "effects" | "split" | "formula" | "numbers";
export const effectsTab = signal<Tab>("effects");

export function EffectsPanel() {
  const document = diagnose.value.document;
  const splits = document ? document.next_readings.length : 0;
  const tabs = choicesOf<Tab>([
    ["effects", "What is missing"],
    ["split", document && document.explanations.length > 1 ? `A or B${splits > 0 ? ` · ${splits}` : ""}` : "A or B"],
    ["formula", "Formula"],
    ["numbers", "Numbers"],
  ]);
  const choice = (
    <Tabs label="What is missing" tabs={tabs} value={effectsTab.value} onChoose={(next) => (effectsTab.value = next)} />
  );
  return (
    <Panel head={choice} end={<OtherModel name="diagnose" />} role="tabpanel">
      <TabBody />
    </Panel>
  );
}

function TabBody() {
  const found = diagnose.value;
  if (effectsTab.value === "formula") return <FormulaBox />;
  if (effectsTab.value === "numbers") {
    return identify.value.document ? (
      <ParameterTable parameters={identify.value.document.parameters} />
    ) : (
      <p class="muted">The fitted numbers stand here once an effect is added or the model is identified.</p>
    );
  }
  if (effectsTab.value === "split" && (found.document || runSheet.value))
    return <Splitting document={found.document} />;
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
      {found.document.warnings.map((entry) => (
        <p class="warning">{pageWords(typeof entry === "string" ? entry : entry.sentence)}</p>
      ))}
      <EffectRanking document={found.document} />
    </>
  );
}
