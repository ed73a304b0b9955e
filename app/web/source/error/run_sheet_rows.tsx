// The rows of the run sheet: posture and load of each reading, ticks, and typed values.
import {senseArrow} from "../../../drawing/conditions.js";
import {fixed, isNumber, jointDecimals, short} from "../../../drawing/numbers.js";
import {poseRequest} from "../arm/pose_link";
import {inUnit} from "../server/unit_table";
import {cell, unitTable} from "../server/workbench";
import {view} from "../shell/page_state";
import {change, takenIds} from "./run_sheet";
import {openColumns, type RunSheet, type RunSheetTable} from "./run_sheet_table";
import type {FillIn} from "../server/documents";

interface JointColumn {
  name: string;
  unit: string;
  /**
   * Column indices of the joint's value in a row, of its approximate value in a row where the joint is read off, and of
   * the sense of arrival; -1 if there is no such column.
   */
  k: number;
  near: number;
  sense: number;
}

interface Layout {
  joints: JointColumn[];
  /** Column index of the load; -1 if there is no such column. */
  load: number;
  open: string[];
  hasSeparations: boolean;
}

function layoutOf(sheet: RunSheet, table: RunSheetTable): Layout {
  const {columns} = table;
  return {
    joints: columns.flatMap((column, k) => jointColumn(columns, column, k)),
    load: columns.findIndex((column) => column.startsWith("load")),
    open: openColumns(sheet),
    hasSeparations: sheet.separations.length > 0,
  };
}

function jointColumn(columns: readonly string[], column: string, k: number): JointColumn[] {
  const joint = cell.value?.joints.find(({name}) => column === name || column.startsWith(`${name}_`));
  if (!joint || column === `${joint.name}_dir`) return [];
  const near = columns.indexOf(`near_${column}`);
  // The heading names the unit of the file, which the page may show in another one.
  const unit = column.slice(joint.name.length + 1) || joint.unit;
  return [{name: joint.name, unit, k, near, sense: columns.indexOf(`${joint.name}_dir`)}];
}

/** Returns the proposed value of the joint. */
function proposedJoint(row: readonly string[], {k, near}: JointColumn): number {
  return Number(row[k] || row[near]);
}

export function RunSheetRows({sheet, table}: {sheet: RunSheet; table: RunSheetTable}) {
  const layout = layoutOf(sheet, table);
  return (
    <table>
      <RunSheetHead layout={layout} />
      <tbody>
        {table.rows.map((row, r) => (
          <RunSheetRow
            key={row[0]}
            sheet={sheet}
            row={row}
            fill={sheet.fill[r]}
            layout={layout}
            separation={sheet.separations[r]}
          />
        ))}
      </tbody>
    </table>
  );
}

function RunSheetHead({layout}: {layout: Layout}) {
  return (
    <thead>
      <tr>
        <th>taken</th>
        <th>id</th>
        {layout.joints.map(({name, unit}) => (
          <th class="number">{unit === "" ? name : `${name}, ${unit}`}</th>
        ))}
        {layout.load >= 0 ? <th class="number">load</th> : null}
        {layout.hasSeparations ? (
          <th class="number" title="separation of the explanations, in sigmas">
            σ apart
          </th>
        ) : null}
        {layout.open.map((column) => (
          <th class="number">{column.replace("_", ", ")}</th>
        ))}
        <th class="no-print" />
      </tr>
    </thead>
  );
}

interface RunSheetRowProps {
  sheet: RunSheet;
  row: string[];
  fill: FillIn;
  layout: Layout;
  separation: number | null | undefined;
}

function RunSheetRow({sheet, row, fill, layout, separation}: RunSheetRowProps) {
  const {joints, load, open, hasSeparations} = layout;
  const [id] = row;
  const isHere = takenIds.value.has(id);
  const own = [...fill.columns, ...fill.optional];
  return (
    <tr class={isHere ? "here" : ""}>
      <td>
        <input
          type="checkbox"
          aria-label={`Reading ${id} is taken`}
          checked={isHere || sheet.ticked.includes(id)}
          disabled={isHere}
          onChange={(event) => tick(sheet, id, event.currentTarget.checked)}
        />
      </td>
      <td>{id}</td>
      {joints.map((joint) => (
        <td class="number" title={row[joint.k] || row[joint.near]}>
          {fixed(proposedJoint(row, joint), jointDecimals(joint.unit))}
          {joint.sense >= 0 ? senseArrow(Number(row[joint.sense])) : ""}
        </td>
      ))}
      {load >= 0 ? <td class="number">{row[load]}</td> : null}
      {hasSeparations ? <td class="number">{short(separation)}</td> : null}
      {open.map((column) => (
        <td class="number">
          {isHere ? "✓" : own.includes(column) ? <Field sheet={sheet} id={id} column={column} /> : null}
        </td>
      ))}
      <td class="number no-print">
        <button class="button small" aria-label={`Show reading ${id} on the arm`} onClick={() => show(layout, row)}>
          Arm
        </button>
      </td>
    </tr>
  );
}

function Field({sheet, id, column}: {sheet: RunSheet; id: string; column: string}) {
  return (
    <input
      inputMode="decimal"
      aria-label={`${column} of ${id}`}
      value={sheet.typed[id]?.[column] ?? ""}
      onInput={(event) => type(sheet, id, column, event.currentTarget.value)}
    />
  );
}

function tick(sheet: RunSheet, id: string, isTaken: boolean): void {
  change({ticked: isTaken ? [...sheet.ticked, id] : sheet.ticked.filter((other) => other !== id)});
}

/** Stores a typed value and ticks off its reading. */
function type(sheet: RunSheet, id: string, column: string, value: string): void {
  const typed = {...sheet.typed, [id]: {...sheet.typed[id], [column]: value.replace(",", ".")}};
  change({typed, ticked: sheet.ticked.includes(id) ? sheet.ticked : [...sheet.ticked, id]});
}

function show({joints, load}: Layout, row: string[]): void {
  const own = new Map(joints.map((joint) => [joint.name, joint]));
  poseRequest.joints.value = (cell.value?.joints ?? []).map(({name, unit}, i) => {
    const column = own.get(name);
    return column
      ? inUnit(proposedJoint(row, column), column.unit, unit, unitTable.value)
      : poseRequest.joints.value[i];
  });
  if (load >= 0 && isNumber(Number(row[load]))) poseRequest.load.value = Number(row[load]);
  view.value = "arm";
}
