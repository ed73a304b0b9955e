// Choice of the units in which the page shows and takes lengths and angles.
import {choicesOf, Segments} from "../drawing/segments";
import {chosenUnits, chooseUnits} from "../server/chosen_units";
import type {UnitKind} from "../server/unit_table";
import {cell, unitTable} from "../server/workbench";
import {Menu} from "./menu";

const KINDS: readonly (readonly [UnitKind, string])[] = [
  ["length", "Lengths"],
  ["angle", "Angles"],
];

export function UnitMenu() {
  const info = cell.value;
  if (!info) return null;
  const {length, angle} = info.units;
  return (
    <Menu
      kind="unit-menu"
      buttonKind="button"
      title="Units of lengths and angles on this page"
      button={
        <>
          {length} · {angle}
        </>
      }
    >
      <div class="unit-panel">
        {KINDS.map(([kind, words]) => (
          <div class="row">
            <span>{words}</span>
            <Segments
              label={words}
              choices={[
                {value: "", words: `as in the file: ${info.file_units?.[kind] ?? info.units[kind]}`},
                ...choicesOf(unitTable.value[kind].map(({name}) => [name, name] as const)),
              ]}
              value={chosenUnits[kind]}
              onChoose={(unit) => unit !== chosenUnits[kind] && chooseUnits({[kind]: unit})}
            />
          </div>
        ))}
        <p class="muted">For all that this page shows and takes. Files keep the units of the cell.</p>
      </div>
    </Menu>
  );
}
