// The errors of all readings as arrows at their positions in the 3-D picture, blended between the series before and
// after.
import {Group, InstancedMesh, LineSegments, Vector3, type LineBasicMaterial, type MeshBasicMaterial} from "three";
import type {Palette} from "../drawing/colours";
import {usualLargest} from "../../../drawing/arrows.js";
import {roundDown125} from "../../../drawing/scales.js";
import type {ReadingErrors} from "../error/residuals";
import {arrowGroup} from "./arrow_group";

/** Drawn length of a large error that few readings exceed, relative to the picture's reach. */
const LONG = 0.16;
/** Length of an arrow's head, relative to the picture's reach. */
const HEAD = 0.018;
/** Minimum opacity at which a series is drawn. */
const FAINTEST = 0.02;

type Place = [number, number, number];

/** Returns the magnification of the error arrows, common to the series before and after. */
export function fieldFactor(errors: ReadingErrors, reach: number): number {
  const lengths = errors.series.flatMap((series) =>
    series.errors.map((error) => (error ? Math.hypot(...error) : null)),
  );
  const largest = usualLargest(lengths);
  return largest > 0 ? Math.max(1, roundDown125((LONG * reach) / largest)) : 1;
}

/** Returns the arrows of one series; null if no reading has an error. */
function arrowsOf(places: (Place | null)[], errors: (Place | null)[], factor: number, reach: number, colour: string) {
  const arrows = places.flatMap((place, i) => {
    const error = errors[i];
    return place && error && Math.hypot(...error) > 0
      ? [{from: new Vector3(...place), way: new Vector3(...error).multiplyScalar(factor)}]
      : [];
  });
  return arrows.length > 0 ? arrowGroup(arrows, HEAD * reach, colour, 4) : null;
}

/** Returns the arrows of both series as a group for fadeField(). */
export function errorField(errors: ReadingErrors, reach: number, palette: Palette): Group {
  const field = new Group(),
    factor = fieldFactor(errors, reach);
  for (const [k, series] of errors.series.entries()) {
    const arrows = arrowsOf(errors.places, series.errors, factor, reach, palette[series.mark.colour]);
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
