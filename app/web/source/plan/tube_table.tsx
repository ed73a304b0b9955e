// Table of all tubes of the plan in visiting order.
import {useEffect, useRef} from "preact/hooks";
import {MarkIcon} from "../drawing/marks";
import {useWindow} from "../drawing/window";
import {clock, lengthFigure, probability, short} from "../../../drawing/numbers.js";
import {tubeTitle} from "../../../drawing/sheet_model.js";
import type {PlanDocument, PlannedTube} from "../server/documents";
import {pageWords} from "../server/page_words";
import {units} from "../server/workbench";
import {stepKinds} from "../../../drawing/steps.js";
import {type Kind, predictedSteps} from "../sheet/colourings";
import {arrivals, currentVisit, goToVisit, isPlaying} from "./playback";

const titleOf = ({row, column}: {row: number; column: number}) => tubeTitle(row, column);

const ROW = 27;

export function TubeTable({document}: {document: PlanDocument}) {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = box.current!,
      at = currentVisit.value * ROW;
    if (isPlaying.peek() && (at < element.scrollTop || at > element.scrollTop + element.clientHeight - 3 * ROW))
      element.scrollTop = at - ROW;
  }, [currentVisit.value]);
  const {tubes, unreachable} = document,
    total = tubes.length + unreachable.length;
  const {first, last} = useWindow(box, total, ROW);
  const kinds = stepKinds(document);
  const rowAt = (i: number) => {
    if (i < tubes.length) return <TubeRow key={i} tube={tubes[i]} index={i} kinds={kinds} />;
    const tube = unreachable[i - tubes.length];
    return (
      <div class="tube-row out" key={i} role="row" style={{top: `${ROW * i}px`}}>
        <span role="cell" class="number">
          –
        </span>
        <b role="cell">{titleOf(tube)}</b>
        <span role="cell" class="wide bad">
          {pageWords(tube.reason)}
        </span>
      </div>
    );
  };
  const {length, angle} = units.value;
  return (
    <div class="tube-table" role="table" aria-rowcount={total} aria-label="Tubes in visiting order">
      <div class="tube-row head" role="row">
        <span role="columnheader" class="number">
          #
        </span>
        <span role="columnheader">tube</span>
        <span role="columnheader">tool goes in</span>
        <span role="columnheader" class="number" title={`probability: ${kinds.at(-1)!.name}`}>
          chance of all
        </span>
        <span role="columnheader" class="number">
          true arm, {length}
        </span>
        <span role="columnheader" class="number">
          tilt, {angle}
        </span>
        <span role="columnheader" class="number">
          at
        </span>
      </div>
      <div class="tube-rows" role="rowgroup" ref={box} tabIndex={0}>
        <div style={{height: `${ROW * total}px`}}>{Array.from({length: last - first}, (_, k) => rowAt(first + k))}</div>
      </div>
    </div>
  );
}

function TubeRow({tube, index, kinds}: {tube: PlannedTube; index: number; kinds: readonly Kind[]}) {
  const score = tube.scored?.via_point ?? tube.scored?.goal_point ?? null;
  const kind = kinds[score?.steps ?? predictedSteps(tube) ?? -1];
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
      <span role="cell" class="number">
        {index + 1}
      </span>
      <b role="cell">{titleOf(tube)}</b>
      <span role="cell">
        {kind ? (
          <>
            <MarkIcon mark={kind.mark} size={12} /> {kind.name}
          </>
        ) : (
          <span class="muted">not known</span>
        )}
      </span>
      <span role="cell" class="number">
        {probability(tube.probability_by_steps?.at(-1))}
      </span>
      <span role="cell" class="number">
        {lengthFigure(score?.error, units.value.length, 4)}
      </span>
      <span role="cell" class="number">
        {short(tube.tilt)}
      </span>
      <span role="cell" class="number">
        {Number.isFinite(arrivals.value[index]) ? clock(arrivals.value[index]) : "–"}
      </span>
    </div>
  );
}
