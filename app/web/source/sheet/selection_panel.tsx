// Selection of holes by typed ranges, and actions on the selected holes.
import {useSignal} from "@preact/signals";
import {submitting, TextInput} from "../drawing/fields";
import {Panel} from "../drawing/panel";
import {plural} from "../../../drawing/numbers.js";
import {post} from "../server/requests";
import {attempt} from "../server/workbench";
import {select, selection, view} from "../shell/page_state";
import type {SheetModel} from "./sheet_model";

const EXAMPLES = ["outer:2", "spread:60", "R1-10C5-9"];

async function selectByText(text: string): Promise<void> {
  if (text.trim() === "") return select([]);
  const selectHoles = async () => select((await post<{holes: number[]}>("/api/select", {text})).holes);
  await attempt(`“${text}” selects nothing`, selectHoles);
}

export function SelectionBox() {
  const text = useSignal("");
  return (
    <form class="select-box" onSubmit={submitting(() => selectByText(text.value))}>
      <TextInput of={text} aria-label="Select holes by ranges" placeholder="R1-10C5-9  outer:2  -plugged" />
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
    <Panel title="Selection" end={<b>{plural(count, "hole")}</b>} kind="no-print">
      <SelectionBox />
      <div class="row">
        <button class="button" disabled={count === 0} onClick={() => (view.value = "plan")}>
          Plan these
        </button>
        <button class="button" disabled={count === model.count} onClick={() => select(invert(model))}>
          Invert
        </button>
      </div>
    </Panel>
  );
}

function* invert(model: SheetModel): Generator<number> {
  for (let i = 0; i < model.count; ++i) if (!selection.value.has(i)) yield i;
}
