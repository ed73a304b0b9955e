// What the series of errors are, with their marks.
import type {ComponentChildren} from "preact";
import {shareText} from "../../../drawing/shares.js";
import {MarkIcon} from "../drawing/marks";
import type {ErrorPair} from "../../../drawing/reading_errors.js";

interface SeriesLegendProps {
  errors: ErrorPair | null;
  /** What the series are is said above: here before and after alone. */
  isBrief?: boolean;
  /** How many of the readings are drawn. */
  most: number;
  children?: ComponentChildren;
}

export function SeriesLegend({errors, isBrief = false, most, children}: SeriesLegendProps) {
  const share = shareText(errors?.readings.length ?? 0, most);
  return (
    <p class="series-legend">
      {(errors?.series ?? []).map((series) => (
        <span>
          <MarkIcon mark={series.mark} size={12} isHollow={series === errors?.series[0]} />{" "}
          {isBrief ? series.name.split(":")[0] : series.name}
        </span>
      ))}
      {children}
      {share ? <span>{share}</span> : null}
    </p>
  );
}
