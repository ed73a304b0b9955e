// What the series of errors are, with their marks.
import type {ComponentChildren} from "preact";
import {MarkIcon} from "../drawing/marks";
import type {ReadingErrors} from "./residuals";

export function SeriesLegend({
  errors,
  isBrief = false,
  children,
}: {
  errors: ReadingErrors | null;
  /** What the series are is said above: here before and after alone. */
  isBrief?: boolean;
  children?: ComponentChildren;
}) {
  return (
    <p class="series-legend">
      {(errors?.series ?? []).map((series) => (
        <span>
          <MarkIcon mark={series.mark} size={12} isHollow={series === errors?.series[0]} />{" "}
          {isBrief ? series.name.split(":")[0] : series.name}
        </span>
      ))}
      {children}
    </p>
  );
}
