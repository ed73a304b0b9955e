// The models as steps with names and errors; each step can be restored. Also switches for the effects and free
// parameters of the current model.
import {computed, useSignal} from "@preact/signals";
import {submitting, TextInput} from "../drawing/fields";
import {Icon} from "../drawing/icons";
import {errorUnit} from "../../../drawing/error_budget.js";
import {causeKey, causeText, explanationTitle, FREED} from "../../../drawing/explanations.js";
import {short} from "../../../drawing/numbers.js";
import {addEffects, addFormula, ladder, removeCauses} from "../error/loop";
import type {EffectAt, EffectNumber, Model, WorkbenchState} from "../server/documents";
import {post} from "../server/requests";
import {attempt, currentModel, runningJobs, state, takeState} from "../server/workbench";
import {Menu} from "./menu";
import {changeAndCompare} from "./undo";

/**
 * Held-out error of each model, keyed by model id, from the newest ladder; the last models of the ladder are the stack.
 */
const heldOut = computed<Map<number, number | null>>(() => {
  const now = state.value,
    document = ladder.value.document;
  if (!now || !document) return new Map();
  const top = now.models.findIndex((model) => model.id === document.model);
  const first = document.models.length - 1 - top;
  return new Map(
    now.models.slice(0, top + 1).map((model, k) => [model.id, document.models[first + k]?.rms.heldout ?? null]),
  );
});

const heldOutUnit = computed(() => (ladder.value.document ? errorUnit(ladder.value.document) : ""));

interface Switch {
  key: string;
  title: string;
  isOn: boolean;
  /** Effect that the switch adds again; null for a parameter. */
  effect: EffectAt | null;
}

function known<T>(
  models: readonly Model[],
  of: (model: Model) => readonly T[],
  key: (entry: T) => string,
): Map<string, T> {
  // The newest model that has an effect determines the effect's parameters.
  return new Map(models.flatMap((model) => of(model).map((entry): [string, T] => [key(entry), entry])));
}

const effectSwitches = computed<Switch[]>(() => {
  const models = state.value?.models ?? [];
  const own = new Set((currentModel.value?.effects ?? []).map(causeKey));
  const all = known(models, (model) => model.effects, causeKey);
  for (const effect of currentModel.value?.effects ?? []) all.set(causeKey(effect), effect);
  return [...all].map(([key, effect]) => ({
    key,
    title: explanationTitle({effects: [effect]}),
    isOn: own.has(key),
    effect,
  }));
});

/** Fitted parameters of the arm; parameters of effects are switched with their effects. */
const freeSwitches = computed<Switch[]>(() => {
  const models = state.value?.models ?? [];
  const own = new Set(currentModel.value?.free ?? []);
  const all = known(
    models,
    (model) => model.free.filter((name) => !name.includes("@")),
    (name) => name,
  );
  return [...all.keys()].map((name) => ({key: name, title: name, isOn: own.has(name), effect: null}));
});

/** Returns the effect with the text that requests its addition with its former sizes. */
function causeOf(effect: EffectAt): EffectAt {
  const sizes = Object.entries(effect.parameters ?? {}).map(([name, number]) => {
    const {value, unit} = number as EffectNumber;
    return {name, value, unit};
  });
  return {...effect, add: causeText(effect, sizes)};
}

async function toggle({key, isOn, effect}: Switch): Promise<void> {
  if (isOn) await removeCauses([effect ? key : `free@${key}`]);
  else if (effect?.formula) await addFormula(effect.formula);
  else await addEffects([effect ? causeOf(effect) : {effect: FREED, at: key}]);
}

function goTo({id}: Model): Promise<void> {
  return changeAndCompare("Models", () => post<WorkbenchState>("/api/models/go", {model: id}));
}

export function ModelSteps() {
  const now = state.value;
  if (!now) return null;
  const at = now.models.findIndex((model) => model.id === now.model);
  const isBusy = runningJobs.value.length > 0;
  const button = (
    <>
      <span class="label">model</span>
      <b class="model-name">{now.models[at]?.label ?? "as given"}</b>
      <Icon name="chevron" size={14} />
    </>
  );
  return (
    <Menu kind="model-steps" title="The models as steps; effects and free numbers on and off" button={button}>
      <div class="model-panel">
        <h2>Steps</h2>
        <ol>
          {now.models.map((model, k) => (
            <li key={model.id}>
              <StepButton model={model} side={Math.sign(k - at)} isBusy={isBusy} />
            </li>
          ))}
        </ol>
        <Switches title="Effects" none="none in this model" switches={effectSwitches.value} isBusy={isBusy} />
        <Switches title="Fitted numbers" none="none: all are held" switches={freeSwitches.value} isBusy={isBusy} />
        <p class="muted">
          A click on the present step renames it. Switched off or on, the model is fitted again and becomes a step of
          its own.
        </p>
      </div>
    </Menu>
  );
}

/** Button that restores a model. `side`: −1 for an earlier model, 0 for the current model, 1 for an undone model. */
function StepButton({model, side, isBusy}: {model: Model; side: number; isBusy: boolean}) {
  const isNamed = useSignal(false);
  if (side === 0 && isNamed.value) return <NameField model={model} onEnd={() => (isNamed.value = false)} />;
  return (
    <button
      class={side > 0 ? "undone" : ""}
      aria-current={side === 0 ? "step" : undefined}
      title={side > 0 ? "undone; can be redone" : side === 0 ? "Rename" : model.label}
      disabled={isBusy}
      onClick={() => (side === 0 ? (isNamed.value = true) : void goTo(model))}
    >
      <span>{model.label}</span>
      <small>{heldOut.value.has(model.id) ? `${short(heldOut.value.get(model.id))} ${heldOutUnit.value}` : ""}</small>
    </button>
  );
}

/** Field for another name of a model: Enter or leaving the field takes the name, Esc keeps the former one. */
function NameField({model, onEnd}: {model: Model; onEnd: () => void}) {
  const label = useSignal(model.label);
  const take = async () => {
    onEnd();
    const name = label.value.trim();
    if (name !== "" && name !== model.label) await rename(model, name);
  };
  return (
    <form class="model-naming" onSubmit={submitting(take)}>
      <TextInput
        of={label}
        aria-label="Name of the model"
        autofocus
        maxLength={60}
        onBlur={take}
        onKeyDown={(event) => {
          if (event.key !== "Escape") return;
          event.stopPropagation();
          onEnd();
        }}
      />
    </form>
  );
}

function rename({id}: Model, label: string): Promise<boolean> {
  return attempt("The name stays", async () =>
    takeState(await post<WorkbenchState>("/api/models/rename", {model: id, label})),
  );
}

function Switches({title, none, switches, isBusy}: {title: string; none: string; switches: Switch[]; isBusy: boolean}) {
  const hasReadings = state.value?.measurements !== null;
  return (
    <>
      <h2>{title}</h2>
      {switches.length === 0 ? <p class="muted">{none}</p> : null}
      <ul>
        {switches.map((entry) => (
          <li key={entry.key}>
            <label title={hasReadings ? (entry.effect?.formula ?? "") : "readings are needed to fit the model again"}>
              <input
                type="checkbox"
                checked={entry.isOn}
                disabled={isBusy || !hasReadings}
                onChange={() => void toggle(entry)}
              />
              {entry.title}
            </label>
          </li>
        ))}
      </ul>
    </>
  );
}
