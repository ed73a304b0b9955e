// Estimates with their 95 % intervals, one below the other. Settings are distinguished by colour, dash and mark.
import {exact, isNumber} from "../../../../drawing/numbers.js";
import {roundTicks} from "../../../../drawing/scales.js";
import {MarkAt, type Mark} from "../../drawing/marks";
import {Missing} from "../parts";

interface Look extends Mark {
  dash: number[];
}

export const LOOKS: Look[] = [
  {colour: "accent", dash: [], shape: "disc"},
  {colour: "case0", dash: [7, 4], shape: "square"},
  {colour: "case3", dash: [2, 3], shape: "triangle"},
  {colour: "rose", dash: [9, 3, 2, 3], shape: "diamond"},
  {colour: "case1", dash: [4, 2], shape: "cross"},
  {colour: "violet", dash: [1, 4], shape: "ring"},
];

export function lookOf(index: number): Look {
  return LOOKS[index % LOOKS.length];
}

export interface Estimate {
  name: string;
  look: Mark;
  value?: number;
  low?: number | null;
  high?: number | null;
}

interface EstimatesProps {
  label: string;
  rows: readonly Estimate[];
  /** Upper end of the axis (which begins at zero), and title of the axis. */
  to: number;
  title: string;
  write: (value: unknown) => string;
}

const WIDTH = 560,
  LEFT = 8,
  TALL = 42,
  BOTTOM = 40;

export function Estimates({label, rows, to, title, write}: EstimatesProps) {
  const shown = rows.filter((row) => isNumber(row.value));
  if (shown.length === 0) return <Missing what={label} />;
  const height = shown.length * TALL + BOTTOM,
    x = (value: number) => LEFT + ((WIDTH - 3 * LEFT) * value) / (to || 1);
  return (
    <svg class="drawing" viewBox={`0 0 ${WIDTH} ${height}`} role="img" aria-label={label}>
      {roundTicks(0, to, 6).map((tick) => (
        <>
          <path class="grid" d={`M${x(tick)} 6V${height - BOTTOM}`} />
          <text x={x(tick)} y={height - BOTTOM + 16} text-anchor="middle">
            {exact(tick)}
          </text>
        </>
      ))}
      <text x={WIDTH / 2} y={height - 6} text-anchor="middle">
        {title}
      </text>
      {shown.map(({name, look, value, low, high}, i) => {
        const y = (i + 0.86) * TALL,
          hasBand = isNumber(low) && isNumber(high);
        return (
          <>
            <text x={LEFT} y={y - 12}>
              {name}: {write(value)}
              {hasBand ? ` (${write(low)} to ${write(high)})` : ""}
            </text>
            {hasBand ? <path class="axis" d={`M${x(low)} ${y}H${x(high)}`} /> : null}
            <MarkAt mark={look} x={x(value!)} y={y} r={5} />
          </>
        );
      })}
    </svg>
  );
}
