// The joint axes of the arm: a line along the z axis of each joint's row, whose end carries the joint's name.
import {BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments, Quaternion, Vector3} from "three";
import type {Palette} from "../drawing/colours";
import type {Frame, JointInfo} from "../server/documents";
import {vector} from "./solids";

/** Length of an axis to each side of its joint, relative to the picture's reach. */
const HALF = 0.09;

export interface JointAxis {
  name: string;
  from: Vector3;
  to: Vector3;
}

/** Returns the axes of the joints whose rows have a frame. */
export function axesOf(
  joints: readonly Pick<JointInfo, "name" | "row">[],
  frames: readonly Frame[],
  reach: number,
): JointAxis[] {
  return joints.flatMap(({name, row}) => {
    const frame = frames.find((entry) => entry.row === row);
    if (!frame) return [];
    const [w, x, y, z] = frame.quaternion;
    const way = new Vector3(0, 0, HALF * reach).applyQuaternion(new Quaternion(x, y, z, w));
    const middle = vector(frame.position);
    return [{name, from: middle.clone().sub(way), to: middle.add(way)}];
  });
}

/** Returns the axes as lines in front of the bodies, which would hide them. */
export function axisLines(axes: readonly JointAxis[], palette: Palette): LineSegments {
  const ends = axes.flatMap(({from, to}) => [...from.toArray(), ...to.toArray()]);
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(ends, 3));
  const lines = new LineSegments(
    geometry,
    new LineBasicMaterial({color: palette.violet, depthTest: false, transparent: true}),
  );
  lines.renderOrder = 5;
  return lines;
}
