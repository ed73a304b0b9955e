// Lines in the 3-D picture: from the arm to the nearest object, and the tour of a plan.
import {
  BufferGeometry,
  Group,
  Line,
  LineBasicMaterial,
  LineDashedMaterial,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  type Vector3,
} from "three";
import type {Palette} from "../drawing/colours";

/** Returns the line from the arm to the nearest object, with a dot at each end, drawn in front of all bodies. */
export function clearanceLine(from: Vector3, to: Vector3, reach: number, palette: Palette): Group {
  const look = {color: palette.rose, depthTest: false};
  const line = new Line(new BufferGeometry().setFromPoints([from, to]), new LineBasicMaterial(look));
  const group = new Group().add(line);
  for (const end of [from, to]) {
    const dot = new Mesh(new SphereGeometry(0.008 * reach, 12, 8), new MeshBasicMaterial(look));
    dot.position.copy(end);
    group.add(dot);
  }
  for (const part of group.children) part.renderOrder = 5;
  return group;
}

export const TOUR = "tour";

/** Returns a line through the tip positions in the order of visiting. */
export function tourLine(points: Vector3[], reach: number, palette: Palette): Line {
  const look = {color: palette.violet, dashSize: 0.035 * reach, gapSize: 0.02 * reach};
  const tour = new Line(new BufferGeometry().setFromPoints(points), new LineDashedMaterial(look));
  tour.computeLineDistances();
  tour.name = TOUR;
  return tour;
}
