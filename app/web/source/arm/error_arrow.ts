// The errors of one reading in the 3-D picture: arrows from the tip, magnified by a round factor to be visible.
import {Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3} from "three";
import type {Palette} from "../drawing/colours";
import {roundDown125} from "../../../drawing/scales.js";
import {arrowGroup} from "./arrow_group";
import type {ShownReading} from "./pose_link";

/** Maximum drawn length of the larger error, relative to the picture's reach. */
const LONGEST = 0.24;
/** Length of an arrow's head, relative to the picture's reach. */
const HEAD = 0.03;

/** Returns the magnification of the arrows of a reading. */
export function factorOf(reading: ShownReading, reach: number): number {
  const most = Math.max(...reading.errors.map(({error}) => (error ? Math.hypot(...error) : 0)));
  return most > 0 ? Math.max(1, roundDown125((LONGEST * reach) / most)) : 1;
}

/** Returns a wireframe sphere at the arrow's end, the measured tip; a solid sphere marks the modelled tip. */
function measuredTip(place: Vector3, reach: number, colour: string): Mesh {
  const ball = new Mesh(
    new SphereGeometry(0.013 * reach, 10, 7),
    new MeshBasicMaterial({color: colour, wireframe: true, depthTest: false, transparent: true}),
  );
  ball.position.copy(place);
  ball.renderOrder = 7;
  return ball;
}

export function errorArrows(reading: ShownReading, reach: number, palette: Palette): Group {
  const group = new Group();
  if (!reading.place) return group;
  const from = new Vector3(...reading.place),
    factor = factorOf(reading, reach);
  for (const {mark, error} of reading.errors) {
    if (!error || !error.some((value) => value !== 0)) continue;
    const way = new Vector3(...error).multiplyScalar(factor);
    group.add(arrowGroup([{from, way}], HEAD * reach, palette[mark.colour], 6));
    group.add(measuredTip(from.clone().add(way), reach, palette[mark.colour]));
  }
  const dot = new Mesh(
    new SphereGeometry(0.006 * reach, 12, 8),
    new MeshBasicMaterial({color: palette.ink, depthTest: false}),
  );
  dot.position.copy(from);
  dot.renderOrder = 7;
  group.add(dot);
  return group;
}
