// Bars that show the shares of a job's time: for all legs together, and for each leg.
import {fixed, percent} from "../../../drawing/numbers.js";
import {FillIcon, fillOf, FillPatterns} from "../drawing/hatching";
import {hours, type JobPlan, legName, type LegPlan, timeFill} from "./job_plan";

/** Dimensions of the picture [units of the picture]. */
const WIDTH = 1000,
  LEFT = 92,
  RIGHT = 66,
  ROW = 32,
  BAR = 22;

interface Part {
  key: string;
  words: string;
  time_s: number;
}

/** Returns the time of every part in one leg, summed over the leg itself and its packages. */
function partsOf(leg: LegPlan, plan: JobPlan): Part[] {
  const timeOf = (of: object, key: string) => (of as Record<string, number>)[key] ?? 0;
  return plan.times.map(({key, words}) => ({
    key,
    words,
    time_s: [leg, ...leg.packages].reduce((sum, of) => sum + timeOf(of, key), 0),
  }));
}

export function TimeShares({plan}: {plan: JobPlan}) {
  const rows = [
    {name: "all legs", parts: plan.times as Part[]},
    ...plan.legs.map((leg) => ({name: legName(leg), parts: partsOf(leg, plan)})),
  ];
  return (
    <figure class="gantt">
      <svg class="drawing" viewBox={`0 0 ${WIDTH} ${ROW * rows.length}`} role="img" aria-label="Time by activity">
        <FillPatterns fills={plan.times.map(({key}) => timeFill(key))} />
        {rows.map(({name, parts}, k) => (
          <g key={name} transform={`translate(0 ${ROW * k})`}>
            <Row name={name} parts={parts} />
          </g>
        ))}
      </svg>
      <ul class="legend">
        {plan.times.map(({key, words, time_s, share}) => (
          <li key={key}>
            <FillIcon fill={timeFill(key)} /> {words} <b>{percent(share, 1)}</b> ({fixed(hours(time_s), 1)} h)
          </li>
        ))}
      </ul>
    </figure>
  );
}

/** Smallest share whose number is printed on the bar. */
const NUMBERED = 0.045;

function Row({name, parts}: {name: string; parts: readonly Part[]}) {
  const all = parts.reduce((sum, {time_s}) => sum + time_s, 0),
    scale = (WIDTH - LEFT - RIGHT) / Math.max(1, all);
  let at = LEFT;
  return (
    <>
      <text class="strong" x={4} y={BAR / 2 + 6}>
        {name}
      </text>
      {parts.map(({key, words, time_s}) => {
        const x = at,
          width = scale * time_s;
        at += width;
        return (
          <g key={key}>
            <rect x={x} y={2} width={width} height={BAR} fill={fillOf(timeFill(key))}>
              <title>{`${words}: ${fixed(hours(time_s), 2)} h, ${percent(time_s / Math.max(1, all), 1)}`}</title>
            </rect>
            <text class="on-bar" x={x + width / 2} y={BAR / 2 + 6} text-anchor="middle">
              {time_s / Math.max(1, all) >= NUMBERED ? percent(time_s / all) : ""}
            </text>
          </g>
        );
      })}
      <text x={WIDTH - RIGHT + 8} y={BAR / 2 + 6}>
        {fixed(hours(all), 1)} h
      </text>
    </>
  );
}
