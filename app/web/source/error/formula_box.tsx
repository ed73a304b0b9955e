// An effect of one's own as a formula: tried means added, fitted and set beside the others; undo takes it back.
import {signal, useSignal} from "@preact/signals";
import {effectTitle} from "../../../drawing/explanations.js";
import type {CatalogueDocument} from "../server/documents";
import {get} from "../server/requests";
import {cell, report, runningJob, units} from "../server/workbench";
import {addEffects, addFormula} from "./loop";

/** Kept over changes of view. */
export const formulaText = signal("");

export function FormulaBox() {
  const text = formulaText;
  const joints = cell.value?.joints.map((joint) => joint.name) ?? [];
  const conditions = units.value.conditions?.map(({name}) => name) ?? [];
  const [a = "theta1", c = "theta3"] = [joints[0], joints[2] ?? joints[0]];
  const examples = [`${c} += c*sin(${a})`, `${c} += c*${c}_dir`, `tip.z += c*load`, `${c} += c*sin(k*${a}); k=3`];
  return (
    <form
      class="formula"
      onSubmit={(event) => {
        event.preventDefault();
        if (text.value.trim() !== "") void addFormula(text.value.trim());
      }}
    >
      <label class="field">
        a law of your own: what it changes += its value
        <input
          value={text.value}
          spellcheck={false}
          placeholder={examples[0]}
          onInput={(event) => (text.value = event.currentTarget.value)}
        />
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
        Undo takes it back.
      </p>
      <CatalogueMenu />
    </form>
  );
}

/** Every effect of the catalogue at every place of this arm, to add without being asked. */
function CatalogueMenu() {
  const catalogue = useSignal<CatalogueDocument["effects"] | null>(null);
  const chosen = useSignal(-1);
  const load = () => {
    if (!catalogue.value)
      get<CatalogueDocument>("/api/catalogue").then(
        (found) => (catalogue.value = found.effects),
        (error) => report("The catalogue", error),
      );
  };
  const effect = catalogue.value?.[chosen.value];
  return (
    <div class="catalogue">
      <label class="field">
        or any effect of the catalogue
        <select
          onFocus={load}
          onPointerDown={load}
          value={chosen.value}
          onChange={(event) => (chosen.value = Number(event.currentTarget.value))}
        >
          <option value={-1}>choose …</option>
          {(catalogue.value ?? []).map((entry, index) => (
            <option value={index}>{effectTitle(entry)}</option>
          ))}
        </select>
      </label>
      <button
        type="button"
        class="button"
        disabled={!effect || runningJob("add") !== null}
        onClick={() => effect && addEffects([{effect: effect.effect, at: effect.at}])}
      >
        Add
      </button>
      <p class="muted reserve">{effect ? `${effect.words}. ${effect.law}` : ""}</p>
    </div>
  );
}
