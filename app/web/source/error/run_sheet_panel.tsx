// The run sheet on the page: printed or taken along as CSV, ticked off, filled in or dropped back.
import {Icon} from "../drawing/icons";
import {fixed, isNumber, jointDecimals, plural, short} from "../../../drawing/numbers.js";
import {senseArrow} from "../../../drawing/conditions.js";
import {poseRequest} from "../arm/pose_link";
import {cell} from "../server/workbench";
import {view} from "../shell/page_state";
import {change, freshRows, joinReadings, putRunSheetAway, runSheet, takenIds} from "./run_sheet";
import {openColumns, tableOf, withTyped, type RunSheet, type RunSheetTable} from "./run_sheet_table";

export function RunSheetPanel() {
  const sheet = runSheet.value;
  if (!sheet) return null;
  const table = tableOf(sheet.text);
  const taken = table.rows.filter(([id]) => takenIds.value.has(id)).length;
  const ready = freshRows(withTyped(sheet), takenIds.value);
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
        <SheetTable sheet={sheet} table={table} />
      </div>
      <p class="muted no-print">
        Fill in the coordinates here, or in the file and drop it on the page: what is filled in joins the readings.
      </p>
    </section>
  );
}

function csvAddress(text: string): string {
  return `data:text/csv;charset=utf-8,${encodeURIComponent(text)}`;
}

/** What a column of joints is for. */
function jointOf(column: string): {name: string; unit: string; isSense: boolean} | null {
  const joint = cell.value?.joints.find(({name}) => column === name || column.startsWith(`${name}_`));
  return joint ? {name: joint.name, unit: joint.unit, isSense: column === `${joint.name}_dir`} : null;
}

function SheetTable({sheet, table}: {sheet: RunSheet; table: RunSheetTable}) {
  const {columns, rows} = table;
  const open = openColumns(table);
  const joints = columns.flatMap((column, k) => {
    const joint = jointOf(column);
    return joint && !joint.isSense ? [{...joint, k, sense: columns.indexOf(`${joint.name}_dir`)}] : [];
  });
  const load = columns.findIndex((column) => column.startsWith("load"));
  return (
    <table>
      <thead>
        <tr>
          <th>taken</th>
          <th>id</th>
          {joints.map(({name, unit}) => (
            <th class="number">{unit === "" ? name : `${name}, ${unit}`}</th>
          ))}
          {load >= 0 ? <th class="number">load</th> : null}
          {sheet.separations.length > 0 ? (
            <th class="number" title="how far it sets the explanations apart, in sigmas">
              σ apart
            </th>
          ) : null}
          {open.map((column) => (
            <th class="number">{column.replace("_", ", ")}</th>
          ))}
          <th class="no-print" />
        </tr>
      </thead>
      <tbody>
        {rows.map((row, r) => {
          const isHere = takenIds.value.has(row[0]);
          return (
            <tr key={row[0]} class={isHere ? "here" : ""}>
              <td>
                <input
                  type="checkbox"
                  aria-label={`Reading ${row[0]} is taken`}
                  checked={isHere || sheet.ticked.includes(row[0])}
                  disabled={isHere}
                  onChange={(event) => tick(sheet, row[0], event.currentTarget.checked)}
                />
              </td>
              <td>{row[0]}</td>
              {joints.map(({k, unit, sense}) => (
                <td class="number" title={row[k]}>
                  {fixed(Number(row[k]), jointDecimals(unit))}
                  {sense >= 0 ? senseArrow(Number(row[sense])) : ""}
                </td>
              ))}
              {load >= 0 ? <td class="number">{row[load]}</td> : null}
              {sheet.separations.length > 0 ? <td class="number">{short(sheet.separations[r])}</td> : null}
              {open.map((column) => (
                <td class="number">
                  {isHere ? (
                    "✓"
                  ) : (
                    <input
                      inputMode="decimal"
                      aria-label={`${column} of ${row[0]}`}
                      value={sheet.typed[row[0]]?.[column] ?? ""}
                      onInput={(event) => type(sheet, row[0], column, event.currentTarget.value)}
                    />
                  )}
                </td>
              ))}
              <td class="number no-print">
                <button
                  class="button small"
                  aria-label={`Show reading ${row[0]} on the arm`}
                  onClick={() => show(joints, row, load)}
                >
                  Arm
                </button>
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function tick(sheet: RunSheet, id: string, isTaken: boolean): void {
  change({ticked: isTaken ? [...sheet.ticked, id] : sheet.ticked.filter((other) => other !== id)});
}

/** A coordinate that is typed in ticks its reading off. */
function type(sheet: RunSheet, id: string, column: string, value: string): void {
  const typed = {...sheet.typed, [id]: {...sheet.typed[id], [column]: value.replace(",", ".")}};
  change({typed, ticked: sheet.ticked.includes(id) ? sheet.ticked : [...sheet.ticked, id]});
}

function show(joints: {name: string; k: number}[], row: string[], load: number): void {
  const own = new Map(joints.map(({name, k}) => [name, Number(row[k])]));
  poseRequest.joints.value = (cell.value?.joints ?? []).map(
    (joint, i) => own.get(joint.name) ?? poseRequest.joints.value[i],
  );
  if (load >= 0 && isNumber(Number(row[load]))) poseRequest.load.value = Number(row[load]);
  view.value = "arm";
}
