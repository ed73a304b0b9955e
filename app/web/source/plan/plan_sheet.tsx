// The sheet of the plan view: the work list and the tour, coloured by the number of tool steps that enter.
import {signal} from "@preact/signals";
import {useCallback, useMemo} from "preact/hooks";
import {MarkIcon} from "../drawing/marks";
import {Segments, type Choice} from "../drawing/segments";
import {whole} from "../../../drawing/numbers.js";
import {stepKinds} from "../../../drawing/steps.js";
import type {PlanDocument} from "../server/documents";
import {picked, select, selection, toggleSelected} from "../shell/page_state";
import {byState, bySteps, type Colouring, predictedSteps} from "../sheet/colourings";
import {SelectionBox} from "../sheet/selection_panel";
import type {PaintOver} from "../sheet/sheet_drawing";
import type {SheetModel} from "../sheet/sheet_model";
import {SheetPanel} from "../sheet/with_sheet";
import {PlanOrder} from "./plan_order";
import {currentVisit, goToVisit} from "./playback";
import {tour, unplanned} from "./tour";
import {paintTour} from "./tour_painting";

const mode = signal("via_point");

/**
 * Returns the possible colourings of the tour: each compensation mode scored against the true arm, and the prediction
 * of the plan.
 */
function modesOf({modes}: PlanDocument): Choice<string>[] {
  const scored = (modes ?? []).map(({name, words, brief}) => ({value: name, words: brief, hint: words}));
  return [...scored, {value: "predicted", words: "predicted"}];
}

interface PlanSheetProps {
  model: SheetModel;
  document: PlanDocument | null;
}

export function PlanSheet({model, document}: PlanSheetProps) {
  const isScored = document?.tubes.some((tube) => tube.scored?.via_point ?? tube.scored?.goal_point) ?? false;
  const shownMode = isScored ? mode.value : "predicted";
  const colouring = useMemo(
    () => (document ? bySteps(model, document, shownMode) : byState(model)),
    [model, document, shownMode],
  );
  const paintOver = useCallback<PaintOver>(
    (context, camera, size, colours) =>
      paintTour(
        {context, camera, size, colours},
        {model, colouring, holes: tour.peek(), at: currentVisit.peek(), unreachable: document?.unreachable ?? []},
      ),
    [model, document, colouring, tour.value, currentVisit.value],
  );
  return (
    <SheetPanel
      headClass="plan-head"
      head={<PlanHead />}
      foot={
        <>
          {isScored ? (
            <ModeChoice document={document} shownMode={shownMode} />
          ) : (
            <span class="muted">
              {document
                ? predictionWords(document)
                : "Select holes, then press Plan. The path is checked for collisions."}
            </span>
          )}
          {document ? <StepCounts document={document} colouring={colouring} /> : null}
        </>
      }
      sheet={model}
      colouring={colouring}
      selection={document && tour.value.length > 0 ? unplanned.value : selection.value}
      picked={picked}
      paintOver={paintOver}
      onLasso={select}
      onPick={visitOrSelect}
    />
  );
}

/** Returns what the sheet shows of a plan without a true arm, which for a base that was not measured is no number. */
function predictionWords({tubes, base}: PlanDocument): string {
  const isKnown = tubes.some((tube) => predictedSteps(tube) !== null);
  return `steps of the tool ${isKnown ? "as predicted" : "are not known"} ${base?.words ?? ""}`;
}

function visitOrSelect(hole: number, event: {shiftKey: boolean}): void {
  const visit = tour.value.indexOf(hole);
  if (visit >= 0 && !event.shiftKey) goToVisit(visit);
  else toggleSelected(hole);
}

function PlanHead() {
  return (
    <>
      <SelectionBox />
      <div class="end">
        <PlanOrder />
      </div>
    </>
  );
}

function ModeChoice({document, shownMode}: {document: PlanDocument | null; shownMode: string}) {
  return (
    <>
      <span class="muted">true arm, compensation</span>
      <Segments
        label="Compensation of the true arm"
        choices={document ? modesOf(document) : []}
        value={shownMode}
        onChoose={(next) => (mode.value = next)}
      />
    </>
  );
}

/** Numbers of holes that no step, one step, and so on up to all steps of the tool enter. */
function StepCounts({document, colouring}: {document: PlanDocument; colouring: Colouring}) {
  const kinds = stepKinds(document);
  if (kinds.every((_, i) => colouring.counts[i] === 0)) return null;
  return (
    <span class="counts">
      {kinds.map((kind, i) => (
        <span title={kind.name}>
          <MarkIcon mark={kind.mark} size={12} /> {whole(colouring.counts[i])}
        </span>
      ))}
    </span>
  );
}
