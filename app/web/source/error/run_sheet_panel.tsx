// The run sheet on the page: it can be printed, saved as CSV, ticked off, filled in, or returned by dropping a file.
import {Icon} from "../drawing/icons";
import {plural} from "../../../drawing/numbers.js";
import {freshRows, joinReadings, putRunSheetAway, runSheet, takenIds} from "./run_sheet";
import {RunSheetRows} from "./run_sheet_rows";
import {tableOf, withTyped} from "./run_sheet_table";

export function RunSheetPanel() {
  const sheet = runSheet.value;
  if (!sheet) return null;
  const table = tableOf(sheet.text);
  const taken = table.rows.filter(([id]) => takenIds.value.has(id)).length;
  const ready = freshRows(withTyped(sheet), takenIds.value, "whole");
  const isReady = ready !== "" && Object.keys(sheet.typed).length > 0;
  return (
    <section class="run-sheet">
      <header>
        <h2>
          Run sheet{" "}
          <small class="muted">
            {taken > 0 ? `${taken} of ${table.rows.length} are here` : plural(table.rows.length, "reading")}
          </small>
        </h2>
        <div class="row no-print">
          {isReady ? (
            <button class="button small first" onClick={() => void joinReadings(ready)}>
              Add {plural(tableOf(ready).rows.length, "reading")}
            </button>
          ) : null}
          <a class="button small" download="run-sheet.csv" href={csvAddress(withTyped(sheet))}>
            CSV
          </a>
          <button class="button small" onClick={() => window.print()}>
            <Icon name="print" size={14} /> Print
          </button>
          <button class="button small" onClick={putRunSheetAway}>
            Dismiss
          </button>
        </div>
      </header>
      <div class="run-sheet-rows">
        <RunSheetRows sheet={sheet} table={table} />
      </div>
      <p class="muted no-print">
        Fill in what was measured here, or in the file and drop it on the page: rows that are filled in join the
        readings, the others are left for later.
      </p>
    </section>
  );
}

function csvAddress(text: string): string {
  return `data:text/csv;charset=utf-8,${encodeURIComponent(text)}`;
}
