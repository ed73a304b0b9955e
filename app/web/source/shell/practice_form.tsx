// Form for simulated readings of an arm with a hidden effect, for practice.
import {useSignal, type Signal} from "@preact/signals";
import {submitting, TextInput} from "../drawing/fields";
import type {CatalogueDocument} from "../server/documents";
import {useAnswer} from "../server/answers";
import {cell} from "../server/workbench";
import {simulate} from "./load";

export function PracticeForm() {
  const hide = useSignal(""),
    readings = useSignal(120),
    seed = useSignal(1);
  const start = () => {
    const hidden = hide.value.trim();
    return simulate({
      design: cell.value?.base_known ? "bench" : "bowl",
      readings: readings.value,
      seed: seed.value,
      hide: hidden === "" ? [] : [hidden],
    });
  };
  return (
    <form class="practice" onSubmit={submitting(start)}>
      <h2>Practise</h2>
      <HiddenEffect hide={hide} />
      <Count words="readings" count={readings} least={6} most={2000} />
      <Count words="seed" count={seed} least={1} />
      <button class="button" type="submit">
        Make readings
      </button>
    </form>
  );
}

/** Field for the name of the hidden effect, with the effects of the catalogue as choices. */
function HiddenEffect({hide}: {hide: Signal<string>}) {
  const effects = useAnswer<CatalogueDocument>("/api/catalogue").document?.effects ?? [];
  return (
    <>
      <label class="field">
        hidden effect
        <TextInput of={hide} list="practice-effects" placeholder="none, or one of the list" />
      </label>
      <datalist id="practice-effects">
        {[...new Set(effects.map(({effect, at}) => `${effect}@${at}`))].map((name) => (
          <option value={name} />
        ))}
      </datalist>
    </>
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
