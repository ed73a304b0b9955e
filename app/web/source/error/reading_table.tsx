// Table of all readings with their errors: sortable by any column, filtered, with actions to set readings aside or use
// them again.
import {signal} from "@preact/signals";
import {useEffect, useMemo, useRef} from "preact/hooks";
import {TextInput} from "../drawing/fields";
import {useWindow} from "../drawing/window";
import {senseArrow} from "../../../drawing/conditions.js";
import {exact, fixed, jointDecimals, plural, short, whole} from "../../../drawing/numbers.js";
import {READING_SIGMAS, sigmasText} from "../../../drawing/sigma_text.js";
import type {MeasurementsDocument} from "../server/documents";
import {answerTo} from "../server/answers";
import {reporting, state, units} from "../server/workbench";
import {selectReadings, selectedReadings, pointed} from "./linked";
import {areChangeable} from "./loop";
import {markReadings} from "./reading_marks";
import {columnsOf, filtered, rowsOf, sizeUnitOf, sorted, wrongWord, type Column, type ReadingRow} from "./reading_rows";
import {readingErrors} from "./residuals";
import {showReading} from "./show_reading";

const ROW = 26;

const isWanted = signal(false);
const measured = answerTo<MeasurementsDocument>({
  key: () => {
    const {measurements, cell, model} = state.value ?? {};
    return measurements && isWanted.value ? `${cell?.file} ${measurements.name} ${measurements.change} ${model}` : null;
  },
  path: () => "/api/measurements",
  keeps: true,
  onProblem: reporting("The readings"),
});

const order = signal({column: "sigma", isDown: true});
const filter = signal("");

export function ReadingTable() {
  useEffect(() => {
    isWanted.value = true;
    return () => (isWanted.value = false);
  }, []);
  const joints = measured.value.document?.joints ?? [];
  const all = useMemo(
    () => rowsOf(measured.value.document?.rows ?? [], readingErrors.value, units.value.length),
    [measured.value.document, readingErrors.value, units.value],
  );
  const sizeUnit = useMemo(() => sizeUnitOf(all, units.value.length), [all, units.value]);
  const columns = useMemo(
    () => columnsOf(joints, units.value, sizeUnit),
    [joints.map(({name, unit}) => `${name} ${unit}`).join(), units.value, sizeUnit],
  );
  const rows = useMemo(() => {
    const column = columns.find((entry) => entry.key === order.value.column) ?? columns[0];
    return sorted(filtered(all, filter.value, columns), column, order.value.isDown);
  }, [all, columns, filter.value, order.value]);
  const wrong = wrongWord(filter.value, columns);
  const aside = all.filter((row) => row.isAside).map((row) => row.id);
  const isBusy = !areChangeable.value;
  return (
    <div class="reading-table">
      <div class="reading-tools">
        <TextInput
          of={filter}
          aria-label="Filter the readings"
          placeholder="P12   sigma>3   theta3<40   aside   held-out"
        />
        <span class="muted">
          {wrong !== null
            ? `${wrong} is not understood`
            : measured.value.document === null
              ? "loading"
              : rows.length === all.length
                ? plural(all.length, "reading")
                : `${whole(rows.length)} of ${whole(all.length)}`}
        </span>
        <button class="button small" title="Ctrl+A in the table" disabled={isBusy} onClick={() => pickRows(rows)}>
          Select these
        </button>
        {aside.length > 0 ? (
          <button class="button small" disabled={isBusy} onClick={() => void markReadings("aside", aside, false)}>
            Take all {aside.length} back
          </button>
        ) : null}
      </div>
      <Rows rows={rows} columns={columns} isBusy={isBusy} />
    </div>
  );
}

/** Selects all filtered readings that are not set aside yet. */
function pickRows(rows: ReadingRow[]): void {
  selectReadings(
    rows.filter((row) => !row.isAside).map((row) => row.id),
    false,
  );
}

function Rows({rows, columns, isBusy}: {rows: ReadingRow[]; columns: readonly Column[]; isBusy: boolean}) {
  const box = useRef<HTMLDivElement>(null);
  const {first, last} = useWindow(box, rows.length, ROW);
  const layout = {gridTemplateColumns: `26px ${columns.map(({width}) => width).join(" ")}`};
  return (
    <div
      class="reading-rows"
      ref={box}
      tabIndex={0}
      role="table"
      aria-label="Readings"
      aria-rowcount={rows.length}
      onKeyDown={(event) => {
        if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "a") return;
        event.preventDefault();
        pickRows(rows);
      }}
    >
      <div class="reading-row head" role="row" style={layout}>
        <span role="columnheader" title="In use">
          use
        </span>
        {columns.map((column) => (
          <ColumnHead key={column.key} column={column} />
        ))}
      </div>
      <div class="reading-space" style={{height: `${ROW * rows.length}px`}}>
        {rows.slice(first, last).map((row, k) => (
          <Row key={row.id} row={row} columns={columns} top={ROW * (first + k)} layout={layout} isBusy={isBusy} />
        ))}
      </div>
    </div>
  );
}

/** Head of a column. A click sorts by the column, largest first; a second click reverses the order. */
function ColumnHead({column}: {column: Column}) {
  const isSorted = order.value.column === column.key,
    {isDown} = order.value;
  return (
    <button
      role="columnheader"
      aria-sort={!isSorted ? "none" : isDown ? "descending" : "ascending"}
      onClick={() => (order.value = {column: column.key, isDown: isSorted ? !isDown : true})}
    >
      {column.words}
      {column.unit ? <small> {column.unit}</small> : null}
      {isSorted ? (isDown ? " ↓" : " ↑") : ""}
    </button>
  );
}

/** Returns the size of a reading's error, with its unit if the column's head states none. */
function sizeText(size: number | null, row: ReadingRow, columns: readonly Column[]): string {
  const isOfOneUnit = columns.find(({key}) => key === "before")!.unit !== "";
  return size === null || isOfOneUnit ? short(size) : `${short(size)} ${row.sizeUnit}`;
}

interface RowPlace {
  row: ReadingRow;
  columns: readonly Column[];
  top: number;
  layout: object;
  isBusy: boolean;
}

function Row({row, columns, top, layout, isBusy}: RowPlace) {
  const joints = columns.slice(columns.length - row.joints.length);
  const {text, isMany} = sigmasText(row.sigmas, READING_SIGMAS);
  const isMarked = pointed.value === row.id || selectedReadings.value.has(row.id);
  return (
    <div
      class={`reading-row ${row.isAside ? "aside" : ""}`}
      role="row"
      aria-selected={isMarked}
      style={{...layout, top: `${top}px`}}
      onPointerEnter={() => (pointed.value = row.id)}
      onPointerLeave={() => (pointed.value = "")}
    >
      <span role="cell">
        <input
          type="checkbox"
          checked={!row.isAside}
          disabled={isBusy}
          aria-label={`Use reading ${row.id}`}
          onChange={() => void markReadings("aside", [row.id], !row.isAside)}
        />
      </span>
      <span role="cell">
        <button
          class="link"
          aria-label={`The arm at reading ${row.id}`}
          disabled={row.isAside}
          onClick={() => showReading(row.id)}
        >
          {row.id}
          {row.isHeldOut ? <small title="held out: not used in the fit"> ◇</small> : null}
        </button>
      </span>
      <span role="cell" class={`number ${isMany ? "bad" : ""}`}>
        {row.isAside ? "aside" : text}
      </span>
      <span role="cell" class="number">
        {sizeText(row.before, row, columns)}
      </span>
      <span role="cell" class="number">
        {sizeText(row.after, row, columns)}
      </span>
      <span role="cell" class="reading-point">
        {row.name}
      </span>
      <span role="cell" class="number" title={`${exact(row.load)} ${units.value.force}`}>
        {exact(row.load)}
      </span>
      {row.joints.map((value, k) => (
        <span role="cell" class="number">
          {fixed(value, jointDecimals(joints[k].unit))}
          {senseArrow(row.senses[k])}
        </span>
      ))}
    </div>
  );
}
