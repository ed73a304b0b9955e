// The errors of all readings as arrows at their positions in the 3-D picture, blended between the series before and
// after.
import {Group, InstancedMesh, LineSegments, Vector3, type LineBasicMaterial, type MeshBasicMaterial} from "three";
import type {Palette} from "../drawing/colours";
import {usualLargest} from "../../../drawing/arrows.js";
import {roundDown125, roundUp125} from "../../../drawing/scales.js";
import type {ReadingErrors} from "../error/residuals";
import {arrowGroup} from "./arrow_group";

/** Drawn length of a large error that few readings exceed, relative to the picture's reach. */
const LONG = 0.16;
/** Length of an arrow's head, relative to the picture's reach. */
const HEAD = 0.018;
/** Minimum opacity at which a series is drawn. */
const FAINTEST = 0.02;

type Place = [number, number, number];

/** Returns the large error that few readings exceed, before or after. */
export function largestShown(errors: ReadingErrors): number {
  return usualLargest(
    errors.series.flatMap((series) => series.errors.map((error) => (error ? Math.hypot(...error) : null))),
  );
}

/** Colours of the sizes of errors, from small to large. */
export const SIZE_COLOURS = ["band0", "band1", "band2", "band3", "band4", "band5"] as const;

/** Returns the upper ends of the sizes of each colour but the last, in the unit of the errors. */
export function sizeEnds(errors: ReadingErrors): number[] {
  const step = roundUp125(largestShown(errors) / (SIZE_COLOURS.length - 1) || 1);
  return SIZE_COLOURS.slice(1).map((_, k) => (k + 1) * step);
}

/** Returns the magnification of the error arrows, common to the series before and after. */
export function fieldFactor(errors: ReadingErrors, reach: number): number {
  const largest = largestShown(errors);
  return largest > 0 ? Math.max(1, roundDown125((LONG * reach) / largest)) : 1;
}

/** Returns the arrows of one series; null if no reading has an error. */
function arrowsOf(
  places: (Place | null)[],
  errors: (Place | null)[],
  {factor, reach, colour, ofSize}: {factor: number; reach: number; colour: string; ofSize?: (size: number) => string},
) {
  const arrows = places.flatMap((place, i) => {
    const error = errors[i],
      size = error ? Math.hypot(...error) : 0;
    return place && error && size > 0
      ? [{from: new Vector3(...place), way: new Vector3(...error).multiplyScalar(factor), colour: ofSize?.(size)}]
      : [];
  });
  return arrows.length > 0 ? arrowGroup(arrows, HEAD * reach, colour, 4) : null;
}

/** Returns the arrows of both series, coloured by series or by size, as a group for fadeField(). */
export function errorField(errors: ReadingErrors, reach: number, palette: Palette, isBySize: boolean): Group {
  const field = new Group(),
    factor = fieldFactor(errors, reach),
    ends = sizeEnds(errors);
  const bandOf = (size: number) => palette[SIZE_COLOURS[ends.filter((end) => size >= end).length]];
  for (const [k, series] of errors.series.entries()) {
    const colour = palette[series.mark.colour];
    const arrows = arrowsOf(errors.places, series.errors, {
      factor,
      reach,
      colour,
      ofSize: isBySize ? bandOf : undefined,
    });
    if (!arrows) continue;
    arrows.name = k === 0 ? "before" : "after";
    field.add(arrows);
  }
  return field;
}

/** Blends the arrows of both series. `after` = 0 shows only the errors before, 1 only the errors after. */
export function fadeField(field: Group, after: number): void {
  for (const arrows of field.children) {
    const opacity = arrows.name === "after" ? after : 1 - after;
    arrows.visible = opacity > FAINTEST;
    arrows.traverse((part) => {
      if (part instanceof LineSegments || part instanceof InstancedMesh)
        (part.material as LineBasicMaterial | MeshBasicMaterial).opacity = opacity;
    });
  }
}
