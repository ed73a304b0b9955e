// Readings of an arm that hides an effect, to practise on.
import {useSignal, type Signal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import type {CatalogueDocument} from "../server/documents";
import {get} from "../server/requests";
import {cell} from "../server/workbench";
import {simulate} from "./load";

export function PracticeForm() {
  const hide = useSignal(""),
    readings = useSignal(120),
    seed = useSignal(1);
  const start = (event: Event) => {
    event.preventDefault();
    const hidden = hide.value.trim();
    void simulate({
      design: cell.value?.base_known ? "bench" : "bowl",
      readings: readings.value,
      seed: seed.value,
      hide: hidden === "" ? [] : [hidden],
    });
  };
  return (
    <form class="practice" onSubmit={start}>
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

/** By name, with those of the catalogue to choose from. */
function HiddenEffect({hide}: {hide: Signal<string>}) {
  const catalogue = useSignal<string[]>([]);
  useEffect(() => {
    get<CatalogueDocument>("/api/catalogue").then(
      (found) => (catalogue.value = [...new Set(found.effects.map((entry) => `${entry.effect}@${entry.at}`))]),
      () => {},
    );
  }, []);
  return (
    <>
      <label class="field">
        hidden effect
        <input
          list="practice-effects"
          placeholder="none, or EFFECT@PLACE:SIZE"
          value={hide.value}
          onInput={(event) => (hide.value = event.currentTarget.value)}
        />
      </label>
      <datalist id="practice-effects">
        {catalogue.value.map((name) => (
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
