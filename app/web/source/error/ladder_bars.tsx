// The ladder: the error of each model, fitted and held out, falling towards the noise floor.
import {fixed, short} from "../drawing/numbers";
import {state} from "../server/workbench";
import {axisEnd, ladderOf, type Ladder} from "./ladder";
import {compare, ladder} from "./loop";

function shownLadder(): Ladder | null {
  if (ladder.value.document) return ladderOf(ladder.value.document);
  const document = compare.value.document;
  if (!document) return null;
  return {
    rungs: [
      {name: "as the model stands", fitted: document.rms.before, heldout: document.rms.heldout_before},
      {name: "refitted", fitted: document.rms.after, heldout: document.rms.heldout_after},
    ],
    floor: document.rms.noise_floor,
    unit: document.units.length,
  };
}

export function LadderBars() {
  const shown = shownLadder();
  if (!shown) return <p class="muted">The errors of the models stand here once readings are compared.</p>;
  const {rungs, floor, unit} = shown;
  const end = axisEnd(rungs, floor);
  const isCurrent = (index: number) => index === rungs.length - 1 && state.value?.models.length !== undefined;
  return (
    <div class="ladder">
      <div class="ladder-rungs">
        {floor !== null && (
          <div class="ladder-floor">
            <i style={{left: `${(100 * floor) / end}%`}}>
              <span>
                noise floor {short(floor)} {unit}
              </span>
            </i>
          </div>
        )}
        {rungs.map((rung, index) => (
          <div class={`rung ${isCurrent(index) ? "now" : ""}`} key={`${index}`}>
            <span class="rung-name" title={rung.name}>
              {rung.name}
            </span>
            <div class="rung-bars">
              <Bar kind="fitted" value={rung.fitted} end={end} floor={floor} unit={unit} />
              <Bar kind="heldout" value={rung.heldout} end={end} floor={floor} unit={unit} />
            </div>
          </div>
        ))}
      </div>
      <p class="ladder-legend">
        <i class="swatch fitted" /> fitted <i class="swatch heldout" /> held out: judged by a fit that has not seen it
      </p>
    </div>
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
  const times = floor ? `${fixed(value / floor, value / floor < 10 ? 2 : 0)} × floor` : "";
  return (
    <>
      <div class="bar-line">
        <div class={`bar ${kind} ${value > end ? "cut" : ""}`} style={{width: `${100 * Math.min(1, value / end)}%`}} />
      </div>
      <span class="bar-text">
        {short(value)} {unit} <small>{times}</small>
      </span>
    </>
  );
}
