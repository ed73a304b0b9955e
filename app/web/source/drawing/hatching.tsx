// Fills of bars that are distinct without colour: each has a pattern in addition to its colour, so that they work in
// monochrome print and for colour-blind readers.
import type {ColourName} from "./colours";

export type Pattern = "plain" | "diagonal" | "back" | "dots" | "lines" | "crossed";

export interface Fill {
  pattern: Pattern;
  colour: ColourName;
}

/** Side of the tile that a pattern repeats [units of the picture]. */
const TILE = 7;

/** Strokes of each pattern within its tile; dots are strokes of no length with round ends. */
const STROKES: Record<Pattern, string> = {
  plain: "",
  diagonal: "M-2 2L2 -2M0 7L7 0M5 9L9 5",
  back: "M-2 5L2 9M0 0L7 7M5 -2L9 2",
  dots: "M2 2h0M5.5 5.5h0",
  lines: "M0 3.5h7",
  crossed: "M0 0L7 7M0 7L7 0",
};

const nameOf = ({pattern, colour}: Fill) => `fill-${pattern}-${colour}`;

/** Returns the value of an element's attribute `fill`; its picture has the definition by FillPatterns. */
export function fillOf(fill: Fill): string {
  return `url(#${nameOf(fill)})`;
}

export function FillPatterns({fills}: {fills: readonly Fill[]}) {
  return (
    <defs>
      {fills.map((fill) => (
        <pattern id={nameOf(fill)} width={TILE} height={TILE} patternUnits="userSpaceOnUse">
          <rect
            width={TILE}
            height={TILE}
            fill={
              fill.pattern === "plain"
                ? `var(--${fill.colour})`
                : `color-mix(in srgb, var(--${fill.colour}) 22%, var(--panel))`
            }
          />
          <path
            d={STROKES[fill.pattern]}
            stroke={`var(--${fill.colour})`}
            stroke-width={fill.pattern === "dots" ? 2.6 : 1.7}
            stroke-linecap="round"
            fill="none"
          />
        </pattern>
      ))}
    </defs>
  );
}

/** Fill as an icon next to text. */
export function FillIcon({fill}: {fill: Fill}) {
  return (
    <svg class="mark" width="22" height="14" viewBox="0 0 22 14" aria-hidden="true">
      <FillPatterns fills={[fill]} />
      <rect x="0.5" y="0.5" width="21" height="13" fill={fillOf(fill)} stroke="var(--ink)" stroke-width="0.7" />
    </svg>
  );
}
