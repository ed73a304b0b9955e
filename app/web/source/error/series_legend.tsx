// Legend of the series of errors, with their marks.
import type {ComponentChildren} from "preact";
import {shareText} from "../../../drawing/shares.js";
import {MarkIcon} from "../drawing/marks";
import type {ErrorPair} from "../../../drawing/reading_errors.js";

interface SeriesLegendProps {
  errors: ErrorPair | null;
  /** True if the series are explained above, so that the legend names only "before" and "after". */
  isBrief?: boolean;
  /** Approximate largest number of readings drawn. */
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
