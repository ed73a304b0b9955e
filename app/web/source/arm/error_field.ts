// The errors of all readings as arrows at their places in the 3-D picture, before and after faded one into the other.
import {Group, InstancedMesh, LineSegments, Vector3, type LineBasicMaterial, type MeshBasicMaterial} from "three";
import type {Palette} from "../drawing/colours";
import {usualLargest} from "../../../drawing/arrows.js";
import {roundDown125} from "../../../drawing/scales.js";
import type {ReadingErrors} from "../error/residuals";
import {arrowGroup} from "./arrow_group";

/** Of the picture's reach: how long an error is drawn that few are beyond. */
const LONG = 0.16;
/** Likewise, the length of an arrow's head. */
const HEAD = 0.018;
/** Fainter than this, a series is not drawn at all. */
const FAINTEST = 0.02;

type Place = [number, number, number];

/** By how much the errors are drawn larger: one factor for before and after. */
export function fieldFactor(errors: ReadingErrors, reach: number): number {
  const lengths = errors.series.flatMap((series) =>
    series.errors.map((error) => (error ? Math.hypot(...error) : null)),
  );
  const largest = usualLargest(lengths);
  return largest > 0 ? Math.max(1, roundDown125((LONG * reach) / largest)) : 1;
}

/** Arrows of one series; null where it has none. */
function arrowsOf(places: (Place | null)[], errors: (Place | null)[], factor: number, reach: number, colour: string) {
  const arrows = places.flatMap((place, i) => {
    const error = errors[i];
    return place && error && Math.hypot(...error) > 0
      ? [{from: new Vector3(...place), way: new Vector3(...error).multiplyScalar(factor)}]
      : [];
  });
  return arrows.length > 0 ? arrowGroup(arrows, HEAD * reach, colour, 4) : null;
}

/** The field, to be faded by fadeField(). */
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

/** `after`: 0 shows what was before alone, 1 what is after alone. */
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
