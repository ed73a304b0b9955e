// Every tube of the plan in visiting order; only the rows in sight are in the page, so that thousands cost nothing.
import {useEffect, useRef} from "preact/hooks";
import {useSignal} from "@preact/signals";
import {MarkIcon} from "../drawing/marks";
import {clock, lengthFigure, probability, short} from "../../../drawing/numbers.js";
import {tubeTitle} from "../../../drawing/sheet_model.js";
import type {PlanDocument, PlannedTube} from "../server/documents";
import {units} from "../server/workbench";
import {stepKinds, type Kind} from "../sheet/colourings";
import {arrivals, currentVisit, goToVisit, isPlaying} from "./playback";

const titleOf = ({row, column}: {row: number; column: number}) => tubeTitle(row, column);

const ROW = 27;
const MORE = 8;

export function TubeTable({document}: {document: PlanDocument}) {
  const box = useRef<HTMLDivElement>(null);
  const top = useSignal(0),
    height = useSignal(400);
  useEffect(() => {
    const element = box.current!;
    const observer = new ResizeObserver(() => (height.value = element.clientHeight));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  useEffect(() => {
    const element = box.current!,
      at = currentVisit.value * ROW;
    if (isPlaying.peek() && (at < element.scrollTop || at > element.scrollTop + element.clientHeight - 3 * ROW))
      element.scrollTop = at - ROW;
  }, [currentVisit.value]);
  const total = document.tubes.length + document.unreachable.length;
  const first = Math.max(0, Math.floor(top.value / ROW) - MORE),
    last = Math.min(total, first + Math.ceil(height.value / ROW) + 2 * MORE);
  const kinds = stepKinds(document.step_words, document.base);
  const rows = [];
  for (let i = first; i < last; ++i) {
    const tube = document.tubes[i];
    rows.push(
      tube ? (
        <TubeRow key={i} tube={tube} index={i} kinds={kinds} />
      ) : (
        <div class="tube-row out" key={i} role="row" style={{top: `${ROW * i}px`}}>
          <span class="number">–</span>
          <b>{titleOf(document.unreachable[i - document.tubes.length])}</b>
          <span class="wide bad">{document.unreachable[i - document.tubes.length].reason}</span>
        </div>
      ),
    );
  }
  const {length, angle} = units.value;
  return (
    <div class="tube-table" role="table" aria-rowcount={total} aria-label="Tubes in visiting order">
      <div class="tube-row head" role="row">
        <span class="number">#</span>
        <span>tube</span>
        <span>tool goes in</span>
        <span class="number">chance of 3</span>
        <span class="number">true arm, {length}</span>
        <span class="number">tilt, {angle}</span>
        <span class="number">at</span>
      </div>
      <div class="tube-rows" ref={box} onScroll={(event) => (top.value = event.currentTarget.scrollTop)} tabIndex={0}>
        <div style={{height: `${ROW * total}px`}}>{rows}</div>
      </div>
    </div>
  );
}

function TubeRow({tube, index, kinds}: {tube: PlannedTube; index: number; kinds: readonly Kind[]}) {
  const score = tube.scored?.via_point ?? tube.scored?.goal_point ?? null;
  const kind = kinds[score?.steps ?? tube.steps];
  return (
    <div
      class="tube-row"
      role="row"
      aria-current={currentVisit.value === index || undefined}
      style={{top: `${ROW * index}px`}}
      onClick={() => {
        isPlaying.value = false;
        goToVisit(index);
      }}
    >
      <span class="number">{index + 1}</span>
      <b>{titleOf(tube)}</b>
      <span>
        {kind ? (
          <>
            <MarkIcon mark={kind.mark} size={12} /> {kind.name}
          </>
        ) : (
          "–"
        )}
      </span>
      <span class="number">{probability(tube.probability_by_steps?.[3])}</span>
      <span class="number">{lengthFigure(score?.error, units.value.length, 4)}</span>
      <span class="number">{short(tube.tilt)}</span>
      <span class="number">{Number.isFinite(arrivals.value[index]) ? clock(arrivals.value[index]) : "–"}</span>
    </div>
  );
}
