// Stacked bars of fractions; each part has the mark and the count of its number of steps.
import {plural, whole} from "../../../drawing/numbers.js";
import {stepMark} from "../../../drawing/steps.js";
import {MarkIcon} from "../drawing/marks";

interface StepBarsProps {
  label: string;
  /** Number of holes for each number of steps that enter, for each model or mode. */
  rows: readonly {name: string; counts: readonly number[]}[];
}

export function StepBars({label, rows}: StepBarsProps) {
  return (
    <div class="step-bars" role="img" aria-label={label}>
      {rows.map(({name, counts}) => (
        <>
          <span>
            {name} ({whole(counts.reduce((sum, count) => sum + count, 0))})
          </span>
          <div class="step-bar">
            {counts.map((count, steps) =>
              count > 0 ? <Part steps={steps} of={counts.length - 1} count={count} /> : null,
            )}
          </div>
        </>
      ))}
    </div>
  );
}

function Part({steps, of, count}: {steps: number; of: number; count: number}) {
  const mark = stepMark(steps, of);
  return (
    <span
      style={{flexGrow: count, background: `color-mix(in srgb, var(--${mark.colour}) 35%, var(--panel))`}}
      title={`${plural(steps, "step")}: ${whole(count)}`}
    >
      <MarkIcon mark={{...mark, colour: "ink"}} size={12} /> {whole(count)}
    </span>
  );
}
