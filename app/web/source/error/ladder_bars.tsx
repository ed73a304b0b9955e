// The ladder as bars: the fitted and held-out errors of each model, relative to the noise floor.
import {signal} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {inUnit} from "../server/unit_table";
import {cell, state, unitTable} from "../server/workbench";
import {keep, keptObject} from "../shell/kept";
import {LADDER_WORDS} from "../../../drawing/ladder.js";
import {ladderOf, ladderOfDiagnosis, ladderOfOne, type Ladder} from "./ladder";
import {LadderRows, MARKS_IN_WORDS} from "./ladder_rows";
import {compare, currentDiagnosis, ladder} from "./loop";

// ---- the tolerance, typed by the user for each cell and kept in this browser with its unit

const KEPT = "tubeplan.tolerance";
const typed = signal(keptObject<string>(KEPT));

/** Returns the tolerance as typed, or its number in the unit if it was typed in another one. */
function typedHere(unit: string): string {
  const info = cell.value,
    [text = "", own = info?.file_units?.length ?? unit] = (typed.value[info?.file ?? ""] ?? "").split(" ");
  return own === unit || text === ""
    ? text
    : String(Number(inUnit(Number(text), own, unit, unitTable.value).toPrecision(4)));
}

function tolerance(unit: string): number | null {
  const value = Number(typedHere(unit));
  return Number.isFinite(value) && value > 0 ? value : null;
}

function setTolerance(text: string, unit: string): void {
  typed.value = {...typed.peek(), [cell.peek()?.file ?? ""]: `${text.trim().replace(",", ".")} ${unit}`};
  keep(KEPT, typed.peek());
}

// ---- the bars

/**
 * Returns the ladder whose errors agree with the verdict: of the diagnosis, otherwise as computed, otherwise of the
 * comparison; null if there is none.
 */
function shownLadder(): Ladder | null {
  const climbed = ladder.value.document,
    diagnosed = currentDiagnosis.value;
  if (diagnosed && (diagnosed.ladder?.length ?? 0) > 0) return ladderOfDiagnosis(climbed, diagnosed);
  if (climbed) return ladderOf(climbed);
  const document = compare.value.document;
  return document ? ladderOfOne(document) : null;
}

/** Returns the ladder with the present names of the models, which may have been renamed since it was computed. */
function withPresentNames(shown: Ladder | null): Ladder | null {
  const document = ladder.value.document,
    now = state.value;
  if (!shown || !document || !now || shown.models.length !== document.models.length) return shown;
  const top = now.models.findIndex(({id}) => id === document.model);
  const first = shown.models.length - 1 - top;
  if (top < 0 || first < 0) return shown;
  return {
    ...shown,
    models: shown.models.map((model, k) => ({...model, name: now.models[k - first]?.label ?? model.name})),
  };
}

export function LadderBars() {
  const shown = withPresentNames(shownLadder());
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    box.current?.querySelector(".ladder-row.now")?.scrollIntoView({block: "nearest"});
  }, [shown?.models.length]);
  if (!shown) return <p class="muted">Errors of the models appear here after a comparison.</p>;
  const limit = tolerance(shown.unit);
  return (
    <div class="ladder" ref={box}>
      <LadderRows ladder={shown} limit={limit} now={shown.models.length - 1} />
      <p class="ladder-legend">
        <span title={LADDER_WORDS.fitted}>
          <i class="swatch fitted" /> fitted
        </span>
        <i class="swatch heldout" /> {LADDER_WORDS.heldout}
        <label class="tolerance">
          tolerance
          <input
            inputMode="decimal"
            placeholder="none"
            value={typedHere(shown.unit)}
            onInput={(event) => setTolerance(event.currentTarget.value, shown.unit)}
          />
          {shown.unit}
        </label>
        {limit !== null && <span class="acceptance-key">within the tolerance: {MARKS_IN_WORDS}</span>}
      </p>
    </div>
  );
}
