// Data of the picked hole, and the posture that brings the tool under it.
import {Figures, Panel} from "../drawing/panel";
import {fixed, jointDecimals, lengthFigure} from "../../../drawing/numbers.js";
import type {InverseDocument} from "../server/documents";
import {cell, units} from "../server/workbench";
import {picked, selection, toggleSelected, view} from "../shell/page_state";
import {poseRequest, whyNot} from "../arm/pose_link";
import type {Colouring} from "./colourings";
import {holeName, type SheetModel} from "./sheet_model";

export function HolePanel({model, colouring: shown}: {model: SheetModel; colouring: Colouring}) {
  const hole = picked.value;
  if (hole < 0 || hole >= model.count)
    return (
      <Panel title="Hole" kind="grow no-print">
        <p class="muted">Pick a hole: the arm goes under it. Shift adds it to the selection.</p>
      </Panel>
    );
  const {length} = units.value,
    at = [0, 1, 2].map((k) => lengthFigure(model.world[3 * hole + k], length)).join("  ");
  return (
    <section class="panel grow">
      <header>
        <h2>{holeName(model, hole)}</h2>
        <span class="muted">{model.legWords}</span>
        <div class="end no-print">
          <button class="button" aria-pressed={selection.value.has(hole)} onClick={() => toggleSelected(hole)}>
            {selection.value.has(hole) ? "Drop" : "Select"}
          </button>
        </div>
      </header>
      <div class="panel-body">
        <Figures
          rows={[
            ["x, y, z", `${at} ${length}`],
            ["state", model.stateWords[model.state[hole]]],
            ...shown.words(hole).map((line): [string, string] => ["", line]),
          ]}
        />
        <Posture inverse={poseRequest.inverse.value} />
      </div>
    </section>
  );
}

/** Joint values that bring the tool under the hole, or the reason why there are none. */
function Posture({inverse}: {inverse: InverseDocument | null}) {
  if (!inverse) return <p class="muted reserve">Finding a posture …</p>;
  if (inverse.status !== "found" || !inverse.joints) return <p class="reserve bad">Out of reach: {whyNot(inverse)}</p>;
  const joints = cell.value?.joints ?? [];
  return (
    <>
      <Figures
        rows={inverse.joints.map((value, i) => {
          const {name = "", unit = ""} = joints[i] ?? {};
          return [name, `${fixed(value, jointDecimals(unit))} ${unit}`];
        })}
      />
      <button class="button no-print" onClick={() => (view.value = "arm")}>
        See the arm
      </button>
    </>
  );
}
