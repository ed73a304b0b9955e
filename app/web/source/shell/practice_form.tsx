// Form for simulated readings of an arm with a hidden effect, for practice.
import {useSignal, type Signal} from "@preact/signals";
import {Select, submitting, withPoint} from "../drawing/fields";
import {choicesOf} from "../drawing/segments";
import {causeText, plainName} from "../../../drawing/explanations.js";
import {exact, plainUnit} from "../../../drawing/numbers.js";
import {useAnswer} from "../server/answers";
import type {CatalogueDocument} from "../server/documents";
import {cell} from "../server/workbench";
import {simulate} from "./load";

type Effect = CatalogueDocument["effects"][number];

/** Hidden effect of the form: kind, place and sizes as typed, keyed by parameter; no effect if the kind is empty. */
interface Hidden {
  effect: string;
  at: string;
  sizes: Record<string, string>;
  units: Record<string, string>;
}

const NONE: Hidden = {effect: "", at: "", sizes: {}, units: {}};

export function PracticeForm() {
  const hidden = useSignal(NONE),
    readings = useSignal(120),
    seed = useSignal(1);
  const start = () =>
    simulate({
      design: cell.value?.base_known ? "bench" : "bowl",
      readings: readings.value,
      seed: seed.value,
      hide: hidden.value.effect === "" ? [] : [hiddenText(hidden.value)],
    });
  return (
    <form class="practice" onSubmit={submitting(start)}>
      <h2>Practise</h2>
      <HiddenEffect hidden={hidden} />
      <Count words="readings" count={readings} least={6} most={2000} />
      <Count words="seed" count={seed} least={1} />
      <button class="button" type="submit">
        Make readings
      </button>
    </form>
  );
}

/** Returns the effect in the notation of the request. */
function hiddenText({sizes, units, ...effect}: Hidden): string {
  const typed = Object.entries(sizes).filter(([, size]) => size.trim() !== "");
  return causeText(
    effect,
    typed.map(([name, size]) => ({name, value: withPoint(size), unit: units[name]})),
  );
}

/**
 * Returns the sizes with which an effect is proposed: the first parameter at half its usual largest value, the others
 * empty.
 */
export function proposedSizes({parameters}: Effect): Record<string, string> {
  return Object.fromEntries(
    parameters.map(({name, plausible}, k) => [
      name,
      k === 0 && plausible ? String(Number((plausible / 2).toPrecision(2))) : "",
    ]),
  );
}

function unitsOf({parameters}: Effect): Record<string, string> {
  return Object.fromEntries(parameters.map(({name, unit}) => [name, unit]));
}

/** Choices of the hidden effect, of its place and of its sizes, from the catalogue of this arm. */
function HiddenEffect({hidden}: {hidden: Signal<Hidden>}) {
  const effects = useAnswer<CatalogueDocument>("/api/catalogue").document?.effects ?? [];
  const kinds = [...new Map(effects.map((entry) => [entry.effect, entry])).values()];
  const places = effects.filter(({effect}) => effect === hidden.value.effect);
  const chosen = places.find(({at}) => at === hidden.value.at);
  const choose = (entry: Effect | undefined) => {
    hidden.value = entry
      ? {effect: entry.effect, at: entry.at, sizes: proposedSizes(entry), units: unitsOf(entry)}
      : NONE;
  };
  return (
    <>
      <label class="field">
        hidden effect
        <Select
          choices={choicesOf([["", "none"], ...kinds.map(({effect}) => [effect, plainWords(effect)] as const)])}
          value={hidden.value.effect}
          onChoose={(name) => choose(effects.find(({effect}) => effect === name))}
        />
      </label>
      {chosen ? (
        <label class="field">
          at
          <Select
            choices={choicesOf(places.map(({at}) => [at, at] as const))}
            value={hidden.value.at}
            onChoose={(name) => choose(places.find(({at}) => at === name))}
          />
        </label>
      ) : null}
      {chosen?.parameters.map((parameter) => (
        <Size key={`${chosen.effect} ${parameter.name}`} parameter={parameter} hidden={hidden} />
      ))}
    </>
  );
}

function plainWords(effect: string): string {
  return effect.replaceAll("-", " ");
}

function Size({
  parameter: {name, unit, plausible},
  hidden,
}: {
  parameter: Effect["parameters"][number];
  hidden: Signal<Hidden>;
}) {
  const text = hidden.value.sizes[name] ?? "";
  return (
    <label class="field narrow" title={plausible ? `usually up to ${exact(plausible)} ${plainUnit(unit)}` : ""}>
      <span class="clip">
        {plainName(name)}
        {unit === "1" ? "" : `, ${plainUnit(unit)}`}
      </span>
      <input
        inputMode="decimal"
        value={text}
        onInput={({currentTarget: {value}}) =>
          (hidden.value = {...hidden.value, sizes: {...hidden.value.sizes, [name]: value}})
        }
      />
    </label>
  );
}

function Count({words, count, least, most}: {words: string; count: Signal<number>; least: number; most?: number}) {
  return (
    <label class="field narrow">
      {words}
      <input
        type="number"
        min={least}
        max={most}
        value={count.value}
        onInput={(event) => (count.value = Number(event.currentTarget.value))}
      />
    </label>
  );
}
