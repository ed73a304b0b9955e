// Gantt chart of a job's plan: legs, mounting, tool changes and packages of each arm over time.
import {duration, fixed, plural} from "../../../drawing/numbers.js";
import {type Fill, FillIcon, fillOf, FillPatterns} from "../drawing/hatching";
import {hours, type JobPlan, legName, type LegPlan, packageFills, timeFill} from "./job_plan";

/** Dimensions of the picture [units of the picture]. */
const WIDTH = 1000,
  LEFT = 58,
  RIGHT = 14,
  ROW = 66,
  BAR = 30,
  AXIS = 34,
  LETTER = 6.6;

/** One block of a bar [s]; `words` is shown where there is room, and all of it under the pointer. */
interface Block {
  start: number;
  end: number;
  fill: Fill | null;
  words: string;
  title: string;
}

/** Returns the blocks of a leg, in the order of the work; `fills` are those of the packages. */
function blocksOf(leg: LegPlan, fills: Map<string, Fill>): Block[] {
  const blocks: Block[] = [];
  let at = leg.start_s;
  const add = (time: number, fill: Fill, words: string, title: string) => {
    if (time > 0) blocks.push({start: at, end: at + time, fill, words, title: `${title}, ${duration(time)}`});
    at += time;
  };
  add(leg.mount_s, timeFill("mount_s"), "", `mounting in ${legName(leg)}`);
  for (const of of leg.packages) {
    add(of.change_s, timeFill("change_s"), "", `tool change for ${of.package}`);
    add(of.total_s - of.change_s, fills.get(of.package)!, of.package, `${of.package}, ${plural(of.visits, "visit")}`);
  }
  return blocks;
}

/** Returns the idle time of the arm before the leg as a block; null if there is none. */
function idleBlock(leg: LegPlan): Block | null {
  if (!leg.wait || leg.wait.idle_s <= 0) return null;
  const words = `waits for ${leg.wait.for}`;
  return {start: leg.start_s - leg.wait.idle_s, end: leg.start_s, fill: null, words, title: `arm ${leg.arm} ${words}`};
}

/** Returns the times of the ticks [h], at most about 14. */
function ticksUntil(end: number): number[] {
  const step = [0.25, 0.5, 1, 2, 4, 6, 12, 24, 48, 96, 168].find((hour) => end / hour <= 14) ?? 336;
  return Array.from({length: Math.floor(end / step) + 1}, (_, k) => k * step);
}

export function Gantt({plan}: {plan: JobPlan}) {
  const fills = packageFills(plan);
  const scale = (WIDTH - LEFT - RIGHT) / Math.max(1, plan.end_s);
  const at = (seconds: number) => LEFT + scale * seconds;
  const arms = Array.from({length: plan.arms}, (_, k) => k + 1);
  const height = ROW * plan.arms + AXIS;
  return (
    <figure class="gantt">
      <svg
        class="drawing"
        viewBox={`0 0 ${WIDTH} ${height}`}
        role="img"
        aria-label={`Schedule of ${plan.arms} arms over ${fixed(hours(plan.end_s), 1)} hours`}
      >
        <FillPatterns fills={[timeFill("mount_s"), timeFill("change_s"), ...fills.values()]} />
        {ticksUntil(hours(plan.end_s)).map((hour) => (
          <g key={hour}>
            <line class="grid" x1={at(3600 * hour)} x2={at(3600 * hour)} y1={4} y2={height - AXIS + 4} />
            <text x={at(3600 * hour)} y={height - AXIS + 18} text-anchor="middle">
              {hour} h
            </text>
          </g>
        ))}
        {arms.map((arm, row) => (
          <g key={arm} transform={`translate(0 ${ROW * row})`}>
            <text class="strong" x={4} y={ROW - BAR / 2 - 6}>
              arm {arm}
            </text>
            <line class="grid" x1={LEFT} x2={WIDTH - RIGHT} y1={ROW - 10} y2={ROW - 10} />
            {plan.legs
              .filter((leg) => leg.arm === arm)
              .map((leg) => (
                <Leg key={legName(leg)} leg={leg} fills={fills} at={at} />
              ))}
          </g>
        ))}
      </svg>
      <ul class="legend">
        {[["mounting", timeFill("mount_s")] as const, ["tool change", timeFill("change_s")] as const, ...fills].map(
          ([name, fill]) => (
            <li key={name}>
              <FillIcon fill={fill} /> {name}
            </li>
          ),
        )}
      </ul>
      <Waits plan={plan} />
    </figure>
  );
}

/** Bar of one leg below its name, with the arm's preceding idle time. */
function Leg({leg, fills, at}: {leg: LegPlan; fills: Map<string, Fill>; at: (seconds: number) => number}) {
  const idle = idleBlock(leg),
    name = `${legName(leg)}, ${fixed(hours(leg.total_s), 1)} h`,
    room = at(leg.end_s) - at(leg.start_s);
  return (
    <>
      <text class="strong" x={at(leg.start_s) + 2} y={ROW - BAR - 16}>
        {fitting(name, room) || fitting(legName(leg), room)}
      </text>
      {[...(idle ? [idle] : []), ...blocksOf(leg, fills)].map((block) => (
        <Bar key={block.start} block={block} at={at} />
      ))}
    </>
  );
}

/** Returns the words if they fit into the width, or else an empty text. */
function fitting(words: string, width: number): string {
  return words.length * LETTER + 6 <= width ? words : "";
}

function Bar({block: {start, end, fill, words, title}, at}: {block: Block; at: (seconds: number) => number}) {
  const width = at(end) - at(start),
    y = ROW - BAR - 10;
  return (
    <g class={fill ? "" : "idle"}>
      <rect x={at(start)} y={y} width={width} height={BAR} fill={fill ? fillOf(fill) : "none"}>
        <title>{title}</title>
      </rect>
      <text class="on-bar" x={at(start) + width / 2} y={y + BAR / 2 + 4} text-anchor="middle">
        {fitting(words, width)}
      </text>
    </g>
  );
}

/** Sentences that state which leg waits for which, and the end of the schedule with its lower bound. */
function Waits({plan}: {plan: JobPlan}) {
  const isProved = plan.schedule === "optimal";
  return (
    <ul class="reasons">
      {plan.legs.map((leg) =>
        leg.wait ? (
          <li key={legName(leg)}>
            <b>{legName(leg)}</b> begins at {fixed(hours(leg.start_s), 1)} h, when {leg.wait.for} ends: {leg.wait.words}
            {leg.wait.idle_s > 0 ? `; arm ${leg.arm} is idle for ${duration(leg.wait.idle_s)} before` : ""}.
          </li>
        ) : null,
      )}
      <li>
        The last leg ends after <b>{fixed(hours(plan.end_s), 1)} h</b>
        {isProved ? "; no schedule ends earlier" : `; no schedule ends before ${fixed(hours(plan.lower_bound_s), 1)} h`}
        .
      </li>
    </ul>
  );
}
