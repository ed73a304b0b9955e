// The ladder as bars: a row for each model, with the noise floor and a tolerance as lines across all rows.
import {errorText} from "../../../drawing/numbers.js";
import {axisEnd, barOf, floorText, LADDER_WORDS, timesFloor} from "../../../drawing/ladder.js";
import {type Acceptance, acceptanceOf, type ComparedModel, type Ladder} from "./ladder";

interface LadderRowsProps {
  ladder: Ladder;
  /** Tolerance for the error; null if none is chosen. */
  limit?: number | null;
  /** Index of the emphasized model; undefined emphasizes none. */
  now?: number;
}

export function LadderRows({ladder: {models, floor, unit}, limit = null, now}: LadderRowsProps) {
  const end = axisEnd(models, floor);
  return (
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
        <div class={`ladder-row ${index === now ? "now" : ""}`} key={`${index}`}>
          <ModelName model={model} limit={limit} />
          <div class="ladder-bars">
            <Bar kind="fitted" value={model.fitted} end={end} floor={floor} unit={unit} />
            <Bar kind="heldout" value={model.heldout} end={end} floor={floor} unit={unit} />
          </div>
        </div>
      ))}
    </div>
  );
}

/** Sign and text of each acceptance of a model, and which of its errors are within the tolerance. */
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
export const MARKS_IN_WORDS = Object.values(MARKS)
  .map(({sign, within}) => `${sign} ${within}`)
  .join(", ");

/** Name of a model, its acceptance, and the number of holes that the tool enters with this model. */
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
        <small title="holes of the sheet that every step of the tool would enter if this model commanded the arm">
          all steps: {model.centred.all} of {model.centred.holes}
        </small>
      ) : null}
    </span>
  );
}

interface BarProps {
  kind: string;
  value: number | null;
  end: number;
  floor: number | null;
  unit: string;
}

function Bar({kind, value, end, floor, unit}: BarProps) {
  if (value === null || value === undefined) return null;
  const {share, isCut} = barOf(value, end);
  return (
    <>
      <div class="bar-line">
        <div class={`bar ${kind} ${isCut ? "cut" : ""}`} style={{width: `${100 * share}%`}} />
      </div>
      <span class="bar-text">
        {errorText(value, unit)} <small>{timesFloor(value, floor)}</small>
      </span>
    </>
  );
}
