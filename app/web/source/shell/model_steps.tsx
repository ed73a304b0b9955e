// The models as steps with names and errors; each step can be restored. Also switches for the effects and free
// parameters of the current model.
import {computed} from "@preact/signals";
import {Icon} from "../drawing/icons";
import {errorUnit} from "../../../drawing/error_budget.js";
import {explanationTitle} from "../../../drawing/explanations.js";
import {short} from "../../../drawing/numbers.js";
import {addEffects, addFormula, ladder, removeCauses, startCompare} from "../error/loop";
import type {EffectAt, EffectNumber, Model} from "../server/documents";
import {currentModel, order, runningJobs, state} from "../server/workbench";
import {Menu} from "./menu";

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

function keyOf({effect, at}: EffectAt): string {
  return `${effect}@${at}`;
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
  const own = new Set((currentModel.value?.effects ?? []).map(keyOf));
  const all = known(models, (model) => model.effects, keyOf);
  for (const effect of currentModel.value?.effects ?? []) all.set(keyOf(effect), effect);
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
  const numbers = Object.entries(effect.parameters ?? {}).map(
    ([name, number]) => `${name}=${(number as EffectNumber).value}`,
  );
  return {...effect, add: `${keyOf(effect)}${numbers.length > 0 ? `:${numbers.join(",")}` : ""}`};
}

async function toggle({key, isOn, effect}: Switch): Promise<void> {
  if (isOn) await removeCauses([effect ? key : `free@${key}`]);
  else if (effect?.formula) await addFormula(effect.formula);
  else await addEffects([effect ? causeOf(effect) : {effect: "free", at: key}]);
}

async function goTo(model: Model): Promise<void> {
  if (!(await order("Models", "/api/models/go", {model: model.id}))) return;
  if (state.value?.measurements && !state.value.results.compare?.models.includes(model.id)) await startCompare();
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
        <p class="muted">Switched off or on, the model is fitted again and becomes a step of its own.</p>
      </div>
    </Menu>
  );
}

/** Button that restores a model. `side`: −1 for an earlier model, 0 for the current model, 1 for an undone model. */
function StepButton({model, side, isBusy}: {model: Model; side: number; isBusy: boolean}) {
  return (
    <button
      class={side > 0 ? "undone" : ""}
      aria-current={side === 0 ? "step" : undefined}
      title={side > 0 ? "taken back; there to be done again" : model.label}
      disabled={isBusy || side === 0}
      onClick={() => void goTo(model)}
    >
      <span>{model.label}</span>
      <small>{heldOut.value.has(model.id) ? `${short(heldOut.value.get(model.id))} ${heldOutUnit.value}` : ""}</small>
    </button>
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
            <label title={hasReadings ? "" : "it takes readings to fit the model again"}>
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
