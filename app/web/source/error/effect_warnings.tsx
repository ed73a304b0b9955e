// Warnings about the effects of the diagnosed model, one line for each kind, with the effects that can be removed.
import {causeKey, explanationTitle, formulaTexts} from "../../../drawing/explanations.js";
import {plural} from "../../../drawing/numbers.js";
import type {EffectAt, EffectWarning, Model} from "../server/documents";
import {pageWords} from "../server/page_words";
import {currentModel, runningJob} from "../server/workbench";
import {hasCause, ofModel} from "./in_model";
import {removeCauses} from "./loop";
import {type WarningGroup, warningGroups} from "./warning_groups";

/** Kinds of warnings that one line states for all their effects; the sentences of other kinds are listed one by one. */
const TOGETHER: Record<string, {words: (count: number) => string; isRemovable?: boolean}> = {
  "not-needed": {
    words: (count) =>
      count === 1
        ? "These readings do not need one effect of the model:"
        : `These readings need none of ${count} effects of the model, each tested with the others in it:`,
    isRemovable: true,
  },
  "beyond-plausible": {
    words: (count) =>
      `${count === 1 ? "One effect is" : `${count} effects are`} larger than in real machines, so that something else is compensated for:`,
  },
  "misfit-remains": {
    words: (count) =>
      `${count === 1 ? "One effect leaves" : `${count} effects leave`} the error above the noise floor, so that something else is missing:`,
  },
};

interface EffectWarningsProps {
  warnings: readonly (string | EffectWarning)[];
  /** Model that the warnings are about; undefined if it no longer exists. */
  model: Model | undefined;
}

export function EffectWarnings({warnings, model}: EffectWarningsProps) {
  return (
    <>
      {warningGroups(warnings)
        .sort((a, b) => isFirst(b) - isFirst(a))
        .map((group) => (
          <Group key={group.kind} {...group} model={model} />
        ))}
    </>
  );
}

/** Returns 1 for warnings with an action, which come first, otherwise 0. */
function isFirst({kind}: WarningGroup): number {
  return TOGETHER[kind]?.isRemovable ? 1 : 0;
}

function Group({kind, warnings, model}: WarningGroup & Pick<EffectWarningsProps, "model">) {
  const together = TOGETHER[kind];
  if (!together)
    return (
      <>
        {warnings.map(({sentence}) => (
          <p class="warning" key={sentence}>
            {pageWords(sentence)}
          </p>
        ))}
      </>
    );
  const effects = warnings.map(({effect = "", at = ""}) => ofModel(model, {effect, at}));
  return (
    <div class="warning">
      {together.words(warnings.length)}{" "}
      <span title={warnings.map(({sentence}) => pageWords(sentence)).join("\n")}>{explanationTitle({effects})}</span>
      {together.isRemovable ? <RemoveButton named={effects} /> : null}
    </div>
  );
}

function RemoveButton({named}: {named: readonly EffectAt[]}) {
  const effects = named.filter((effect) => hasCause(currentModel.value, effect));
  if (effects.length === 0)
    return (
      <button class="button small" title="The model does not have them any more" disabled>
        ✓ removed
      </button>
    );
  return (
    <button
      class="button small"
      title={["The model is fitted without them; Undo restores them", formulaTexts(effects)].join("\n").trim()}
      disabled={runningJob("remove", "add") !== null}
      onClick={() => removeCauses(effects.map(causeKey))}
    >
      Remove {effects.length === 1 ? explanationTitle({effects}) : `the ${plural(effects.length, "effect")} not needed`}
    </button>
  );
}
