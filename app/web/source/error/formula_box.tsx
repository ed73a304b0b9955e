// A user-defined effect as a formula. Trying a formula adds it to the model, refits and shows it with the other
// effects; undo removes it.
import {signal, useSignal} from "@preact/signals";
import {effectTitle} from "../../../drawing/explanations.js";
import type {CatalogueDocument} from "../server/documents";
import {submitting, Select, TextInput} from "../drawing/fields";
import {choicesOf} from "../drawing/segments";
import {useAnswer} from "../server/answers";
import {ProblemWords} from "../shell/states";
import {cell, currentModel, runningJob, units} from "../server/workbench";
import {hasCause} from "./in_model";
import {addEffects, addFormula} from "./loop";
import {effectsTab} from "./tabs";

/** Text of the formula, kept when the view changes. */
const formulaText = signal("");

/** Opens the formula box and enters the text if the box is empty. */
export function openFormula(text: string): void {
  if (formulaText.peek().trim() === "") formulaText.value = text;
  effectsTab.value = "formula";
}

export function FormulaBox() {
  const text = formulaText;
  const joints = cell.value?.joints.map((joint) => joint.name) ?? [];
  const conditions = units.value.conditions?.map(({name}) => name) ?? [];
  const [a = "theta1", c = "theta3"] = [joints[0], joints[2] ?? joints[0]];
  const examples = [`${c} += c*sin(${a})`, `${c} += c*${c}_dir`, `tip.z += c*load`, `${c} += c*sin(k*${a}); k=3`];
  return (
    <form class="formula" onSubmit={submitting(() => text.value.trim() !== "" && addFormula(text.value.trim()))}>
      <label class="field">
        custom term: what it changes += its value
        <TextInput of={text} placeholder={examples[0]} />
      </label>
      <div class="row">
        <button class="button first" type="submit" disabled={runningJob("add") !== null || text.value.trim() === ""}>
          Try
        </button>
        {examples.map((example) => (
          <button type="button" class="link" onClick={() => (text.value = example)}>
            {example}
          </button>
        ))}
      </div>
      <p class="muted">
        Changes a joint, tip.x to tip.z, base.x to base.z or base.yaw. Knows {joints.join(", ")}, {a}_dir for the sense
        of its last motion, load, {conditions.join(", ")} and moment_ROW_z. Other names are numbers that the fit finds.
        Undo takes it back.{fileUnitsWords()}
      </p>
      <CatalogueMenu />
    </form>
  );
}

/** Returns the units of the numbers in a formula, which a cell file states too, where the page shows others. */
function fileUnitsWords(): string {
  const {length, angle} = units.value,
    file = cell.value?.file_units;
  if (!file || (file.length === length && file.angle === angle)) return "";
  return ` Numbers in it are in the units of the cell's file: ${file.length}, ${file.angle}.`;
}

/** Menu of all effects of the catalogue at all places of this arm, for adding without a proposal. */
function CatalogueMenu() {
  const isWanted = useSignal(false),
    chosen = useSignal(-1);
  const {document, problem} = useAnswer<CatalogueDocument>(isWanted.value ? "/api/catalogue" : "");
  const effects = document?.effects ?? [],
    effect = effects[chosen.value],
    isThere = effect !== undefined && hasCause(currentModel.value, effect);
  return (
    <div class="catalogue">
      <label class="field">
        or any effect of the catalogue
        <Select
          choices={choicesOf([[-1, "choose …"], ...effects.map((entry, k) => [k, effectTitle(entry)] as const)])}
          value={chosen.value}
          onChoose={(index) => (chosen.value = index)}
          onOpen={() => (isWanted.value = true)}
        />
      </label>
      <button
        type="button"
        class="button"
        disabled={!effect || isThere || runningJob("add") !== null}
        onClick={() => effect && addEffects([{effect: effect.effect, at: effect.at}])}
      >
        {isThere ? "✓ added" : "Add"}
      </button>
      {problem ? <ProblemWords problem={problem} /> : null}
      <p class="muted reserve">{effect ? `${effect.words}. ${effect.law}` : ""}</p>
    </div>
  );
}
