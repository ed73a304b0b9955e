// Selecting holes by ranges, and what can be done with those that are selected.
import {useSignal} from "@preact/signals";
import {plural} from "../../../drawing/numbers.js";
import {post} from "../server/requests";
import {report} from "../server/workbench";
import {select, selection, view} from "../shell/page_state";
import type {SheetModel} from "./sheet_model";

const EXAMPLES = ["outer:2", "spread:60", "R1-10C5-9"];

export async function selectByText(text: string): Promise<void> {
  if (text.trim() === "") return select([]);
  try {
    select((await post<{holes: number[]}>("/api/select", {text})).holes);
  } catch (error) {
    report(`“${text}” selects nothing`, error);
  }
}

export function SelectionBox() {
  const text = useSignal("");
  return (
    <form
      class="select-box"
      onSubmit={(event) => {
        event.preventDefault();
        void selectByText(text.value);
      }}
    >
      <input
        aria-label="Select holes by ranges"
        placeholder="R1-10C5-9  outer:2  -plugged"
        value={text.value}
        spellcheck={false}
        onInput={(event) => (text.value = event.currentTarget.value)}
      />
      <button class="button" type="submit">
        Select
      </button>
      <div class="examples">
        {EXAMPLES.map((example) => (
          <button
            key={example}
            type="button"
            class="link"
            onClick={() => {
              text.value = example;
              void selectByText(example);
            }}
          >
            {example}
          </button>
        ))}
        {selection.value.size > 0 ? (
          <button type="button" class="link" onClick={() => select([])}>
            none
          </button>
        ) : null}
      </div>
    </form>
  );
}

export function SelectionPanel({model}: {model: SheetModel}) {
  const count = selection.value.size;
  return (
    <section class="panel no-print">
      <header>
        <h2>Selection</h2>
        <div class="end">
          <b>{plural(count, "hole")}</b>
        </div>
      </header>
      <div class="panel-body">
        <SelectionBox />
        <div class="row">
          <button class="button" disabled={count === 0} onClick={() => (view.value = "plan")}>
            Plan these
          </button>
          <button class="button" disabled={count === model.count} onClick={() => select(invert(model))}>
            Invert
          </button>
        </div>
      </div>
    </section>
  );
}

function* invert(model: SheetModel): Generator<number> {
  for (let i = 0; i < model.count; ++i) if (!selection.value.has(i)) yield i;
}
