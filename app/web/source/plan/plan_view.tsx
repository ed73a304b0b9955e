// The plan view: a work list chosen on the sheet, made into a proved tour, played with the arm, and taken away as files.
import {Segments, type Choice} from "../drawing/segments";
import {computed, signal} from "@preact/signals";
import {useCallback, useEffect, useMemo} from "preact/hooks";
import {Vector3} from "three";
import {ArmPicture} from "../arm/arm_picture";
import {UNREACHABLE} from "../../../drawing/kinds.js";
import {drawMark, MarkIcon} from "../drawing/marks";
import {duration, percent, plural, short, whole} from "../../../drawing/numbers.js";
import type {PlanDocument} from "../server/documents";
import {cell, runJob, runningJob, units} from "../server/workbench";
import {picked, select, selection, sheet, toggleSelected} from "../shell/page_state";
import {ExportMenu} from "../shell/export_menu";
import {OtherModel} from "../shell/other_model";
import {ProblemWords} from "../shell/states";
import {byState, bySteps} from "../sheet/colourings";
import {toPixel} from "../../../drawing/frames.js";
import type {PaintOver} from "../sheet/sheet_drawing";
import type {SheetModel} from "../sheet/sheet_model";
import {SelectionBox} from "../sheet/selection_panel";
import {SheetPanel, WithSheet} from "../sheet/with_sheet";
import {currentVisit, goToVisit, isFollowed, plan, wantPath} from "./playback";
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
const compensation = signal("via-point");
const isOnLines = signal(false);
const isParked = signal(false);
const mode = signal("via_point");
/** What the tour is coloured by: each way that is scored against the true arm, and what the plan itself expects. */
function modesOf({modes}: PlanDocument): Choice<string>[] {
  const scored = (modes ?? []).map(({name, words, brief}) => ({value: name, words: brief, hint: words}));
  return [...scored, {value: "predicted", words: "predicted"}];
}

/** The planned holes in the order of visiting. */
const tour = computed<number[]>(() => {
  const model = sheet.value,
    document = plan.value.document;
  return model && document ? document.tubes.map((tube) => model.find(tube.row, tube.column)) : [];
});

export default function PlanView() {
  useEffect(() => {
    isFollowed.value = true;
    return () => {
      isFollowed.value = false;
    };
  }, []);
  wantPath();
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
    <div class="plan-view">
      <PlanSheet model={model} document={document} />
      <section class="panel">
        <div class="panel-body flush">
          <ArmPicture tour={points} isSmall />
        </div>
      </section>
      <Transport />
      <TourPlot />
      <section class="panel">
        <header>
          {document ? <Outcome document={document} /> : <h2>Tubes</h2>}
          <OtherModel name="plan" />
          <ExportMenu exports={EXPORTS} isHere={document !== null} at="end" />
        </header>
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
    </div>
  );
}

/** Just under each hole, where the tool comes from. */
function tourPoints(model: SheetModel, holes: number[]): Vector3[] | null {
  if (holes.length < 2) return null;
  return holes
    .filter((hole) => hole >= 0)
    .map((hole) => new Vector3(model.world[3 * hole], model.world[3 * hole + 1], -1));
}

function PlanSheet({model, document}: {model: SheetModel; document: PlanDocument | null}) {
  const isScored = document?.tubes.some((tube) => tube.scored?.via_point ?? tube.scored?.goal_point) ?? false;
  const shownMode = isScored ? mode.value : "predicted";
  const colouring = useMemo(
    () => (document ? bySteps(model, document, shownMode) : byState(model)),
    [model, document, shownMode],
  );
  const paintOver = useCallback<PaintOver>(
    (context, camera, size, colours) => {
      const holes = tour.peek(),
        at = currentVisit.peek();
      if (holes.length < 2) return;
      const draw = (from: number, to: number, colour: string, width: number) => {
        context.beginPath();
        for (let i = from; i <= to; ++i) {
          const [x, y] = toPixel(camera, size, model.u[holes[i]], model.v[holes[i]]);
          if (i === from) context.moveTo(x, y);
          else context.lineTo(x, y);
        }
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.stroke();
      };
      draw(0, holes.length - 1, colours.rim, 1);
      if (at >= 0) draw(0, Math.min(at, holes.length - 1), colours.ink, 2);
      const r = Math.max(4.2, model.holeRadius * camera.scale);
      for (const hole of holes) {
        if (hole < 0) continue;
        const {mark} = colouring.kinds[colouring.of[hole]];
        context.strokeStyle = context.fillStyle = colours[mark.colour];
        drawMark(context, mark.shape, ...toPixel(camera, size, model.u[hole], model.v[hole]), r);
      }
      for (const tube of document?.unreachable ?? []) {
        const hole = model.find(tube.row, tube.column);
        context.fillStyle = context.strokeStyle = colours[UNREACHABLE.colour];
        if (hole >= 0) drawMark(context, UNREACHABLE.shape, ...toPixel(camera, size, model.u[hole], model.v[hole]), r);
      }
      if (holes[at] !== undefined) {
        const [x, y] = toPixel(camera, size, model.u[holes[at]], model.v[holes[at]]);
        context.beginPath();
        context.arc(x, y, 9, 0, 2 * Math.PI);
        context.strokeStyle = colours.rose;
        context.lineWidth = 3;
        context.stroke();
      }
    },
    [model, document, colouring, tour.value, currentVisit.value],
  );
  return (
    <SheetPanel
      headClass="plan-head"
      head={
        <>
          <SelectionBox />
          <div class="end">
            <PlanButton />
          </div>
        </>
      }
      foot={
        <>
          {isScored ? (
            <>
              <span class="muted">true arm, compensation</span>
              <Segments
                label="Compensation of the true arm"
                choices={document ? modesOf(document) : []}
                value={shownMode}
                onChoose={(next) => (mode.value = next)}
              />
            </>
          ) : (
            <span class="muted">
              {document
                ? "steps of the tool as predicted"
                : "lasso, ranges or clicks with Shift select; a plan proves the tour"}
            </span>
          )}
          {document ? (
            <span class="counts">
              {colouring.kinds.slice(0, 4).map((kind, i) => (
                <span title={kind.name}>
                  <MarkIcon mark={kind.mark} size={12} /> {whole(colouring.counts[i])}
                </span>
              ))}
            </span>
          ) : null}
        </>
      }
      sheet={model}
      colouring={colouring}
      selection={document && tour.value.length > 0 ? unplanned.value : selection.value}
      picked={picked}
      paintOver={paintOver}
      onLasso={(holes, isMore) => select(holes, isMore)}
      onPick={(hole, event) => {
        const visit = tour.value.indexOf(hole);
        if (visit >= 0 && !event.shiftKey) goToVisit(visit);
        else toggleSelected(hole);
      }}
    />
  );
}

/** Selected holes that the plan does not have yet. */
const unplanned = computed<ReadonlySet<number>>(() => {
  const planned = new Set(tour.value);
  return new Set([...selection.value].filter((hole) => !planned.has(hole)));
});

function PlanButton() {
  const count = selection.value.size,
    job = runningJob("plan");
  return (
    <>
      <select
        aria-label="Compensation"
        value={compensation.value}
        onChange={(event) => (compensation.value = event.currentTarget.value)}
      >
        <option value="via-point">via point</option>
        <option value="goal-point">goal point</option>
        <option value="none">no compensation</option>
      </select>
      {compensation.value === "via-point" ? (
        <label class="check" title="the tip straight from tube to tube, wherever that is possible and free">
          <input type="checkbox" checked={isOnLines.value} onChange={() => (isOnLines.value = !isOnLines.value)} />{" "}
          straight
        </label>
      ) : null}
      {cell.value?.has_park ? (
        <label class="check" title="set out from the park posture and come back to it">
          <input type="checkbox" checked={isParked.value} onChange={() => (isParked.value = !isParked.value)} /> park
        </label>
      ) : null}
      <button
        class="button first"
        disabled={count === 0 || job !== null}
        onClick={() =>
          runJob("Plan", "/api/plan", {
            tubes: [...selection.value].sort((a, b) => a - b),
            compensation: compensation.value,
            travel: isOnLines.value && compensation.value === "via-point" ? "line" : "joints",
            load: 0,
            seed: 1,
            ...(isParked.value && cell.value?.has_park ? {start: "park", end: "park"} : {}),
          })
        }
      >
        {job ? "Planning …" : `Plan ${plural(count, "tube")}`}
      </button>
    </>
  );
}

function Outcome({document}: {document: PlanDocument}) {
  const unit = units.value.length;
  return (
    <p class="outcome">
      <span>
        <b>{whole(document.tubes.length)}</b> planned
      </span>
      {document.unreachable.length > 0 ? (
        <span>
          <b>{whole(document.unreachable.length)}</b> out of reach
        </span>
      ) : null}
      <span>
        travel <b>{duration(document.travel_time_s)}</b>
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
