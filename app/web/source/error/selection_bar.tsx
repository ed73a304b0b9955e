// Actions on readings selected in a picture or in the table: set aside, hold out, fit again, and undo of the last
// action.
import {plural} from "../../../drawing/numbers.js";
import {selectedReadings} from "./linked";
import {areChangeable} from "./loop";
import {lastMarking, markReadings, markingWords} from "./reading_marks";
import {canUndo, undo} from "../shell/undo";
import {readingErrors} from "./residuals";

export function SelectionBar() {
  const last = lastMarking.value;
  if (selectedReadings.value.size === 0 && !last) return null;
  return (
    <div class="selection-bar" role="status">
      {selectedReadings.value.size > 0 ? <SelectionTools ids={[...selectedReadings.value]} /> : null}
      {selectedReadings.value.size === 0 && last ? (
        <>
          <b>{markingWords(last)}</b>
          <button class="button small" title="Undo (Ctrl+Z)" disabled={!canUndo.value} onClick={() => void undo()}>
            Undo
          </button>
        </>
      ) : null}
    </div>
  );
}

function SelectionTools({ids}: {ids: string[]}) {
  const isBusy = !areChangeable.value;
  const heldOut = new Set(
    (readingErrors.value?.readings ?? []).filter((reading) => reading.held_out).map((reading) => reading.id),
  );
  const fitted = ids.filter((id) => !heldOut.has(id)),
    kept = ids.filter((id) => heldOut.has(id));
  return (
    <>
      <b>{plural(ids.length, "reading")} selected</b>
      <button class="button small first" disabled={isBusy} onClick={() => void markReadings("aside", ids, true)}>
        Set aside
      </button>
      {fitted.length > 0 ? (
        <button
          class="button small"
          disabled={isBusy}
          title="Not used in the fit: they judge it"
          onClick={() => void markReadings("held_out", fitted, true)}
        >
          Hold out{kept.length > 0 ? ` ${fitted.length}` : ""}
        </button>
      ) : null}
      {kept.length > 0 ? (
        <button class="button small" disabled={isBusy} onClick={() => void markReadings("held_out", kept, false)}>
          Take {fitted.length > 0 ? `${kept.length} ` : ""}into the fit
        </button>
      ) : null}
      <button class="button small" title="Esc" onClick={() => (selectedReadings.value = new Set())}>
        Clear selection
      </button>
    </>
  );
}
