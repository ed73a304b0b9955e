// Legend of a colouring: the meaning of the marks, the number of holes of each kind, and switches for their visibility.
import {effect, signal} from "@preact/signals";
import {toggled} from "../drawing/fields";
import {MarkIcon} from "../drawing/marks";
import {plural, whole} from "../../../drawing/numbers.js";
import {select} from "../shell/page_state";
import type {Colouring} from "./colourings";
import {Segments} from "../drawing/segments";
import {currentModel} from "../server/workbench";
import {chosen, isBefore, modelBefore, showBefore, type Choice} from "./sheet_choice";

/** Colourings that show a field of the model. */
const FIELDS: ReadonlySet<Choice> = new Set<Choice>(["centring", "residual", "sag"]);

/** Indices of the kinds whose holes are hidden. */
export const hiddenKinds = signal<ReadonlySet<number>>(new Set());
effect(() => {
  void chosen.value;
  hiddenKinds.value = new Set();
});

export function LegendPanel({colouring: shown, isReady}: {colouring: Colouring; isReady: boolean}) {
  return (
    <section class="panel">
      <header>
        <h2>{isReady ? shown.title : "State"}</h2>
        <div class="end">
          <span class="muted">{plural(shown.of.length, "hole")}</span>
        </div>
      </header>
      <ul class="legend">
        {shown.kinds.map((kind, index) =>
          shown.counts[index] === 0 && shown.kinds.length > 6 ? null : (
            <li key={kind.name}>
              <label>
                <input
                  type="checkbox"
                  checked={!hiddenKinds.value.has(index)}
                  onChange={() => (hiddenKinds.value = toggled(hiddenKinds.value, index))}
                />
                <MarkIcon mark={kind.mark} />
                <span>{kind.name}</span>
                <b>{whole(shown.counts[index])}</b>
              </label>
              <button
                class="link"
                title={`Select ${plural(shown.counts[index], "hole")}`}
                disabled={shown.counts[index] === 0}
                onClick={() => select(holesOf(shown, index))}
              >
                select
              </button>
            </li>
          ),
        )}
      </ul>
      {FIELDS.has(chosen.value) && modelBefore.value ? (
        <div class="before-after">
          <Segments
            label="Model"
            choices={[
              {value: "before", words: "before", hint: modelBefore.value.label},
              {value: "after", words: "after", hint: currentModel.value?.label},
            ]}
            value={isBefore.value ? "before" : "after"}
            onChoose={(which) => showBefore(which === "before")}
          />
          <span class="muted">{isBefore.value ? modelBefore.value.label : currentModel.value?.label}</span>
        </div>
      ) : null}
      {shown.meaning ? <p class="meaning muted">{shown.meaning}</p> : null}
    </section>
  );
}

function* holesOf(shown: Colouring, kind: number): Generator<number> {
  for (let i = 0; i < shown.of.length; ++i) if (shown.of[i] === kind) yield i;
}
