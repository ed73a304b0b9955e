// The plan view: a work list chosen on the sheet, planned as a tour with proved clearance, played back with the arm,
// and exported as files.
import {useEffect, useMemo} from "preact/hooks";
import {Vector3} from "three";
import {Panel} from "../drawing/panel";
import {ArmPicture} from "../arm/arm_picture";
import {useOpeningPosture} from "../arm/opening_posture";
import {duration, percent, short, whole} from "../../../drawing/numbers.js";
import {MARKED} from "../../../drawing/sigma_text.js";
import type {PlanDocument} from "../server/documents";
import {currentModel, units} from "../server/workbench";
import {view} from "../shell/page_state";
import {ExportMenu} from "../shell/export_menu";
import {OtherModel} from "../shell/other_model";
import {Splitter, splitStyle} from "../shell/splits";
import {ProblemWords} from "../shell/states";
import type {SheetModel} from "../sheet/sheet_model";
import {WithSheet} from "../sheet/with_sheet";
import {startPlan} from "./plan_order";
import {isFollowed, plan} from "./playback";
import {PlanSheet} from "./plan_sheet";
import {tour} from "./tour";
import {TourPlot} from "./tour_plot";
import {Transport} from "./transport";
import {TubeTable} from "./tube_table";

const EXPORTS = [
  ["plan.json", "Plan"],
  ["path.csv", "Path"],
  ["worklist.csv", "Work list"],
  ["trajectory.yaml", "Trajectory for ROS 2"],
  ["report.html", "Report"],
  ["cell.yaml", "Cell"],
] as const;

export default function PlanView() {
  useOpeningPosture(false);
  useEffect(() => {
    isFollowed.value = true;
    return () => void (isFollowed.value = false);
  }, []);
  return (
    <WithSheet without={<p>There is nothing to visit. Open a cell with a sheet.</p>}>
      {(model) => <Plan model={model} />}
    </WithSheet>
  );
}

function Plan({model}: {model: SheetModel}) {
  const document = plan.value.document;
  const points = useMemo(() => tourPoints(model, tour.value), [model, tour.value]);
  return (
    <div class="plan-view" style={splitStyle("plan-columns", "plan-rows")}>
      <PlanSheet model={model} document={document} />
      <Panel body="flush">
        <ArmPicture tour={points} isSmall />
      </Panel>
      <Transport />
      <TourPlot />
      <section class="panel">
        <header>
          {document ? <Outcome document={document} /> : <h2>Tubes</h2>}
          <OtherModel name="plan" />
          <ExportMenu exports={EXPORTS} isHere={document !== null} at="end" />
        </header>
        <Standing base={document?.base} />
        <div class="panel-body flush">
          {plan.value.problem ? (
            <ProblemWords problem={plan.value.problem} />
          ) : document ? (
            <TubeTable document={document} />
          ) : (
            <p class="muted pad">Select holes on the sheet, or write them as ranges, and plan their visit.</p>
          )}
        </div>
      </section>
      <Splitter name="plan-columns" />
      <Splitter name="plan-rows" />
    </div>
  );
}

/** Returns the points just below the visited holes, from which the tool is inserted; null for fewer than two holes. */
function tourPoints(model: SheetModel, holes: number[]): Vector3[] | null {
  if (holes.length < 2) return null;
  return holes
    .filter((hole) => hole >= 0)
    .map((hole) => new Vector3(model.world[3 * hole], model.world[3 * hole + 1], -model.pitch));
}

/**
 * Base for which the plan is proved, with the advice to calibrate a base that was not measured, or to plan again with
 * the base measured since.
 */
function Standing({base}: {base?: PlanDocument["base"]}) {
  if (!base?.words) return null;
  const now = currentModel.value?.base,
    isOld = !base.placed && now?.placed === true;
  return (
    <p class={`standing ${base.placed ? "" : "bad"}`}>
      {base.placed ? "" : MARKED}Proved {base.words}
      {isOld ? `. Plan again ${now.words}` : ""}
      {base.placed ? null : isOld ? (
        <button class="button" onClick={() => startPlan(tour.value)}>
          Plan again
        </button>
      ) : (
        <button class="button" onClick={() => (view.value = "calibrate")}>
          Calibrate
        </button>
      )}
    </p>
  );
}

function Outcome({document}: {document: PlanDocument}) {
  const unit = units.value.length;
  return (
    <p class="outcome" title={document.sentence}>
      <span>
        <b>{whole(document.tubes.length)}</b> planned
      </span>
      {document.unreachable.length > 0 ? (
        <span>
          <b>{whole(document.unreachable.length)}</b> out of reach
        </span>
      ) : null}
      <span title="between the tubes, and with approaches, retreats and dwell times">
        travel <b>{duration(document.travel_time_s)}</b> of {duration(document.total_time_s)}
      </span>
      <span title={`at best ${duration(document.lower_bound_s)}; row by row ${duration(document.row_by_row_time_s)}`}>
        gap <b>{percent(document.gap, 1)}</b>
      </span>
      <span title={document.tightest}>
        clearance <b>{short(document.min_clearance)}</b> {unit}
      </span>
      {document.travel?.on_line !== undefined ? (
        <span title={`the tip leaves its line by at most ${short(document.travel.line_deviation)} ${unit}`}>
          straight <b>{whole(document.travel.on_line)}</b>
        </span>
      ) : null}
    </p>
  );
}
