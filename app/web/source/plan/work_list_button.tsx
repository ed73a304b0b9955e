// Button that opens a work list from a file, and the number of selected tubes with an individual dwell time.
import {plural} from "../../../drawing/numbers.js";
import {openList} from "./work_list";
import {dwellTimesOfSelection} from "../shell/page_state";

export function WorkListButton() {
  return (
    <label class="button" title="a CSV of tubes, one a row: they become the selection">
      Work list …
      <input
        class="hidden"
        type="file"
        accept=".csv,.txt,.tsv,text/csv,text/plain"
        onChange={async (event) => {
          const input = event.currentTarget,
            file = input.files?.[0];
          if (file) await openList({name: file.name, text: await file.text()});
          input.value = ""; // reset, so that the same file can be opened again
        }}
      />
    </label>
  );
}

export function DwellCount() {
  const seconds = Object.values(dwellTimesOfSelection.value);
  if (seconds.length === 0) return null;
  const least = Math.min(...seconds),
    most = Math.max(...seconds);
  const words = least === most ? `${most} s each` : `${least} to ${most} s each`;
  return (
    <span class="muted" title={`${words}, as in the work list`}>
      stays at {plural(seconds.length, "tube")}
    </span>
  );
}
