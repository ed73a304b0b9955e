// The sheet view: all holes coloured by state, reach, steps, predicted error or residual; the selection; and the data
// of a hole.
import {choicesOf, Segments} from "../drawing/segments";
import {Icon} from "../drawing/icons";
import {runJob, runningJob} from "../server/workbench";
import {picked, select, selection, toggleSelected, view} from "../shell/page_state";
import {showHole} from "../arm/pose_link";
import {byState} from "./colourings";
import {HolePanel} from "./hole_panel";
import {hiddenKinds, LegendPanel} from "./legend_panel";
import {SelectionPanel} from "./selection_panel";
import {CHOICES, chosen, colouring, computeField, type Choice} from "./sheet_choice";
import type {SheetModel} from "./sheet_model";
import {SheetPanel, WithSheet} from "./with_sheet";

const HOW: Record<string, {words: string; action: string}> = {
  reach: {
    words: "Holes under which the arm can bring its tool, and reasons why not for the others.",
    action: "Compute reachable holes",
  },
  centring: {words: "Distance of the tool from each hole's centre.", action: "Predict the error"},
  residual: {words: "Distance of the model's tip from each touched hole.", action: "Compute residuals"},
  sag: {words: "Deflection of the tool under each hole.", action: "Compute sag"},
  steps: {words: "Insertion of the stepped tool, once a plan is made.", action: "Make a plan"},
};

function compute(choice: Choice): void {
  if (choice === "steps") view.value = "plan";
  else if (choice === "reach") void runJob("Reach", "/api/reach");
  else void computeField(choice);
}

export function SheetView() {
  return (
    <WithSheet
      without={
        <>
          <p>
            Its arm stands on a bench. Open a cell with a sheet to see holes; the arm and the error are there all the
            same.
          </p>
          <button class="button" onClick={() => (view.value = "error")}>
            To the error
          </button>
        </>
      }
    >
      {(model) => <Sheet model={model} />}
    </WithSheet>
  );
}

function Sheet({model}: {model: SheetModel}) {
  const shown = colouring.value ?? byState(model);
  return (
    <div class="sheet-view">
      <SheetPanel
        head={<SheetHead />}
        over={colouring.value ? null : <ToCompute choice={chosen.value} />}
        sheet={model}
        colouring={shown}
        hidden={colouring.value ? hiddenKinds.value : undefined}
        selection={selection.value}
        picked={picked}
        onPick={(hole, event) => pick(hole, event.shiftKey || event.ctrlKey || event.metaKey)}
        onLasso={(holes, isMore) => select(holes, isMore)}
      />
      <aside class="side">
        <LegendPanel colouring={shown} isReady={colouring.value !== null} />
        <SelectionPanel model={model} />
        <HolePanel model={model} colouring={shown} />
      </aside>
    </div>
  );
}

function SheetHead() {
  return (
    <>
      <h2>Colour by</h2>
      <Segments
        label="Colour by"
        choices={choicesOf(CHOICES)}
        value={chosen.value}
        onChoose={(next) => (chosen.value = next)}
      />
      <div class="end no-print">
        <button class="tool" title="Print the map in black and white" onClick={() => window.print()}>
          <Icon name="print" />
        </button>
      </div>
    </>
  );
}

function pick(hole: number, isMore: boolean): void {
  if (isMore) toggleSelected(hole);
  picked.value = hole;
  void showHole(hole);
}

function ToCompute({choice}: {choice: Choice}) {
  const how = HOW[choice];
  const job = runningJob("reach", "field");
  return (
    <div class="to-compute">
      <p>{how.words}</p>
      <button class="button first" disabled={job !== null} onClick={() => compute(choice)}>
        {job ? "Working …" : how.action}
      </button>
    </div>
  );
}
