// Meshes of the arm's members and their poses: rigid, deflected, or with magnified deflection.
import {CapsuleGeometry, Group, Mesh, MeshStandardMaterial, Quaternion, SphereGeometry, Vector3} from "three";
import type {Frame, SceneDocument} from "../server/documents";
import {layAlong, solidOf, vector} from "./solids";

/**
 * Dimensions relative to the picture's reach: radius of the rod drawn for a member without a body, radius of the tip,
 * and shortest member for which a rod is drawn.
 */
const ROD = 0.016,
  TIP = 0.012,
  SHORTEST = 0.004;

export interface ArmBodies {
  group: Group;
  rows: Group[];
  rods: (Mesh | null)[];
  tip: Mesh;
  reach: number;
}

/** Style in which the arm is drawn: bodies as in collision checks, or rods from joint to joint. */
export type ArmLook = "shapes" | "skeleton";

export function makeArm(
  document: SceneDocument,
  material: MeshStandardMaterial,
  reach: number,
  look: ArmLook,
): ArmBodies {
  const group = new Group(),
    rows: Group[] = [],
    rods: (Mesh | null)[] = [];
  for (const row of document.arm) {
    const frame = new Group();
    const bodies = look === "shapes" ? row.bodies : [];
    for (const body of bodies) {
      const solid = solidOf(body, material);
      if (solid) frame.add(solid);
    }
    const rod = bodies.length === 0 ? new Mesh(new CapsuleGeometry(ROD, 1, 6, 16), material) : null;
    if (rod) group.add(rod);
    rows.push(frame);
    rods.push(rod);
    group.add(frame);
  }
  const tip = new Mesh(new SphereGeometry(TIP * reach, 16, 12), material);
  group.add(tip);
  return {group, rows, rods, tip, reach};
}

export function placeArm(arm: ArmBodies, frames: Frame[], tip: Vector3): void {
  frames.forEach((frame, i) => {
    const row = arm.rows[i];
    if (!row) return;
    row.position.set(...frame.position);
    const [w, x, y, z] = frame.quaternion;
    row.quaternion.set(x, y, z, w);
    const rod = arm.rods[i];
    if (rod) placeRod(arm, rod, vector(frame.position), i + 1 < frames.length ? vector(frames[i + 1].position) : tip);
  });
  arm.tip.position.copy(tip);
}

function placeRod({reach}: ArmBodies, rod: Mesh, a: Vector3, b: Vector3): void {
  const long = a.distanceTo(b);
  rod.visible = long > SHORTEST * reach;
  layAlong(rod, a, b);
  rod.scale.set(reach, long / (1 + 2 * ROD), reach);
}

/**
 * Returns the deflected frame, with its displacement and rotation relative to the rigid frame multiplied by `times`.
 */
export function magnifiedFrame(rigid: Frame, flexible: Frame, times: number): Frame {
  if (times === 1) return flexible;
  const position = rigid.position.map(
    (value, k) => value + times * (flexible.position[k] - value),
  ) as Frame["position"];
  const turn = (frame: Frame) =>
    new Quaternion(frame.quaternion[1], frame.quaternion[2], frame.quaternion[3], frame.quaternion[0]);
  const from = turn(rigid),
    change = turn(flexible).multiply(from.clone().invert());
  if (change.w < 0) change.set(-change.x, -change.y, -change.z, -change.w);
  const half = Math.acos(Math.min(1, change.w)),
    sine = Math.sin(half);
  const axis = sine > 1e-12 ? new Vector3(change.x, change.y, change.z).divideScalar(sine) : new Vector3(1, 0, 0);
  const result = new Quaternion().setFromAxisAngle(axis, 2 * half * times).multiply(from);
  return {row: flexible.row, position, quaternion: [result.w, result.x, result.y, result.z]};
}
