// The errors of all readings as arrows at their places in the 3-D picture, before and after faded one into the other.
import {
  BufferGeometry,
  ConeGeometry,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  MeshBasicMaterial,
  Object3D,
  Vector3,
} from "three";
import type {Palette} from "../drawing/colours";
import {usualLargest} from "../../../drawing/arrows.js";
import {roundDown125} from "../../../drawing/scales.js";
import type {ReadingErrors} from "../error/residuals";

/** Of the picture's reach: how long an error is drawn that few are beyond. */
const LONG = 0.16;
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
  if (arrows.length === 0) return null;
  const ends = arrows.flatMap(({from, way}) => [...from.toArray(), ...from.clone().add(way).toArray()]);
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(ends, 3));
  const look = {color: colour, transparent: true, depthTest: false};
  const shafts = new LineSegments(geometry, new LineBasicMaterial(look));
  const size = 0.018 * reach;
  const heads = new InstancedMesh(new ConeGeometry(0.3 * size, size, 8), new MeshBasicMaterial(look), arrows.length);
  const head = new Object3D(),
    up = new Vector3(0, 1, 0);
  arrows.forEach(({from, way}, i) => {
    const long = way.length();
    head.scale.setScalar(Math.min(1, long / size));
    head.quaternion.setFromUnitVectors(up, way.clone().normalize());
    head.position.copy(from).addScaledVector(way, Math.max(0, 1 - (0.5 * size * head.scale.x) / long));
    head.updateMatrix();
    heads.setMatrixAt(i, head.matrix);
  });
  shafts.renderOrder = heads.renderOrder = 4;
  return new Group().add(shafts, heads);
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
