// The ladder: the error of each model, fitted and held out, falling towards the noise floor.
import {signal} from "@preact/signals";
import {short} from "../../../drawing/numbers.js";
import {cell, state} from "../server/workbench";
import {keep, keptObject} from "../shell/kept";
import {axisEnd, barOf, floorText, LADDER_WORDS, timesFloor} from "../../../drawing/ladder.js";
import {
  type Acceptance,
  acceptanceOf,
  ladderOf,
  ladderOfDiagnosis,
  ladderOfOne,
  type Ladder,
  type ComparedModel,
} from "./ladder";
import {compare, currentDiagnosis, ladder} from "./loop";

// ---- the tolerance: the user's, one for each cell, kept in this browser

const KEPT = "tubeplan.tolerance";
const typed = signal(keptObject<string>(KEPT));

const typedHere = () => typed.value[cell.value?.file ?? ""] ?? "";

function tolerance(): number | null {
  const value = Number(typedHere());
  return Number.isFinite(value) && value > 0 ? value : null;
}

function setTolerance(text: string): void {
  typed.value = {...typed.peek(), [cell.peek()?.file ?? ""]: text.replace(",", ".")};
  keep(KEPT, typed.peek());
}

// ---- the bars

/** Of the document that the verdict is of, so that its figures are those of the bars. */
function shownLadder(): Ladder | null {
  const climbed = ladder.value.document,
    diagnosed = currentDiagnosis.value;
  if (diagnosed && (diagnosed.ladder?.length ?? 0) > 0) return ladderOfDiagnosis(climbed, diagnosed);
  if (climbed) return ladderOf(climbed);
  const document = compare.value.document;
  return document ? ladderOfOne(document) : null;
}

export function LadderBars() {
  const shown = shownLadder();
  if (!shown) return <p class="muted">The errors of the models stand here once readings are compared.</p>;
  const {models, floor, unit} = shown;
  const end = axisEnd(models, floor);
  const limit = tolerance();
  const isCurrent = (index: number) => index === models.length - 1 && state.value?.models.length !== undefined;
  return (
    <div class="ladder">
      <div class="ladder-rows">
        {floor !== null && (
          <div class="ladder-floor">
            <i style={{left: `${(100 * floor) / end}%`}}>
              <span title={LADDER_WORDS.floor}>{floorText(floor, unit)}</span>
            </i>
          </div>
        )}
        {limit !== null && limit <= end && (
          <div class="ladder-floor">
            <i class="limit" style={{left: `${(100 * limit) / end}%`}}>
              <span>tolerance</span>
            </i>
          </div>
        )}
        {models.map((model, index) => (
          <div class={`ladder-row ${isCurrent(index) ? "now" : ""}`} key={`${index}`}>
            <ModelName model={model} limit={limit} />
            <div class="ladder-bars">
              <Bar kind="fitted" value={model.fitted} end={end} floor={floor} unit={unit} />
              <Bar kind="heldout" value={model.heldout} end={end} floor={floor} unit={unit} />
            </div>
          </div>
        ))}
      </div>
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
            value={typedHere()}
            onInput={(event) => setTolerance(event.currentTarget.value)}
          />
          {unit}
        </label>
        {limit !== null && <span class="acceptance-key">within the tolerance: {MARKS_IN_WORDS}</span>}
      </p>
    </div>
  );
}

/** The sign of each, what it says of a model, and what is within the tolerance then. */
const MARKS: Record<Acceptance, {sign: string; words: string; within: string}> = {
  accepted: {sign: "✓", words: "accepted: no error is beyond the tolerance", within: "every error"},
  "in part": {
    sign: "◐",
    words: "in part: the errors are within the tolerance in the mean square, the largest is not",
    within: "the root mean square",
  },
  rejected: {
    sign: "✗",
    words: "rejected: the errors are beyond the tolerance in the mean square",
    within: "neither",
  },
};
const MARKS_IN_WORDS = Object.values(MARKS)
  .map(({sign, within}) => `${sign} ${within}`)
  .join(", ");

/** What a model is called, whether it is accepted, and what it is worth under the sheet. */
function ModelName({model, limit}: {model: ComparedModel; limit: number | null}) {
  const acceptance = acceptanceOf(model, limit);
  return (
    <span class="ladder-name" title={model.name}>
      {acceptance ? (
        <b
          class={`acceptance ${acceptance.replace(" ", "-")}`}
          title={MARKS[acceptance].words}
          role="img"
          aria-label={acceptance}
        >
          {MARKS[acceptance].sign}
        </b>
      ) : null}
      {model.name}
      {model.centred ? (
        <small title="holes of the sheet in which every step of the tool would go in, were this model to steer">
          all steps: {model.centred.all} of {model.centred.holes}
        </small>
      ) : null}
    </span>
  );
}

function Bar({
  kind,
  value,
  end,
  floor,
  unit,
}: {
  kind: string;
  value: number | null;
  end: number;
  floor: number | null;
  unit: string;
}) {
  if (value === null || value === undefined) return null;
  const {share, isCut} = barOf(value, end);
  return (
    <>
      <div class="bar-line">
        <div class={`bar ${kind} ${isCut ? "cut" : ""}`} style={{width: `${100 * share}%`}} />
      </div>
      <span class="bar-text">
        {short(value)} {unit} <small>{timesFloor(value, floor)}</small>
      </span>
    </>
  );
}
