// Meshes for the shapes of a cell file and for the arm's members.
import {
  BufferGeometry,
  CircleGeometry,
  DoubleSide,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
  Object3D,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector3,
  type Material,
} from "three";
import {ConvexGeometry} from "three/examples/jsm/geometries/ConvexGeometry.js";
import {toCreasedNormals} from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type {SolidShape, Vector3 as Triple} from "../server/documents";

/** Least angle between faces that meet in a visible edge [rad]. */
const CREASE = 0.5;

const UP = new Vector3(0, 1, 0);

export function vector(triple: Triple): Vector3 {
  return new Vector3(...triple);
}

/** Transforms an object of unit length along y so that it extends from a to b. */
export function layAlong(object: Object3D, a: Vector3, b: Vector3): void {
  object.position.copy(a).add(b).multiplyScalar(0.5);
  const along = b.clone().sub(a);
  object.quaternion.copy(new Quaternion().setFromUnitVectors(UP, along.lengthSq() > 0 ? along.normalize() : UP));
}

/** Returns the mesh of a solid shape in the world or its row's frame; null for regions, drawn as boundaries of the scene. */
export function solidOf(shape: SolidShape, material: Material): Object3D | null {
  const geometry = geometryOf(shape);
  if (!geometry) return null;
  return new Mesh(geometry, material);
}

function geometryOf(shape: SolidShape): BufferGeometry | null {
  if (shape.mesh?.positions) return meshOf(shape.mesh.positions);
  return shape.outline ? hullOf(shape.outline) : null;
}

/** Returns the convex hull of points, given by their coordinates, one point after another; round where it is round. */
function hullOf(coordinates: readonly number[]): BufferGeometry {
  const points = [];
  for (let at = 0; at < coordinates.length; at += 3)
    points.push(new Vector3(coordinates[at], coordinates[at + 1], coordinates[at + 2]));
  return toCreasedNormals(new ConvexGeometry(points), CREASE);
}

/** Returns triangles from the coordinates of their corners, one triangle after another. */
function meshOf(positions: readonly number[]): BufferGeometry {
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** Returns the mesh of an obstacle, filled and with its edges, visible in any light. */
export function obstacleOf(shape: SolidShape, colours: {fill: string; edge: string}): Object3D | null {
  const look = {color: colours.fill, roughness: 0.9, transparent: true, opacity: 0.85};
  const solid = solidOf(shape, new MeshStandardMaterial(look));
  if (!(solid instanceof Mesh)) return null;
  solid.add(new LineSegments(new EdgesGeometry(solid.geometry, 30), new LineBasicMaterial({color: colours.edge})));
  return solid;
}

/** Returns the material of a transparent, two-sided surface. */
export function veil(color: string, opacity: number): MeshStandardMaterial {
  return new MeshStandardMaterial({color, opacity, side: DoubleSide, transparent: true, depthWrite: false});
}

/**
 * Returns the inside of a spherical bowl: its half below z = 0, and of this half only the side of the divider with
 * positive (1) or negative (-1) y; both sides if `side` is 0.
 */
export function bowlOf(shape: SolidShape, side: -1 | 0 | 1, colours: {fill: string; edge: string}): Object3D {
  const group = new Group();
  const r = shape.radius ?? 1,
    start = side > 0 ? Math.PI : 0,
    turn = side === 0 ? 2 * Math.PI : Math.PI;
  const geometry = new SphereGeometry(r, 40, 18, start, turn, Math.PI / 2, Math.PI / 2);
  geometry.rotateX(Math.PI / 2);
  group.add(new Mesh(geometry, veil(colours.fill, 0.13)));
  const coarse = new SphereGeometry(r, side === 0 ? 16 : 8, 6, start, turn, Math.PI / 2, Math.PI / 2);
  coarse.rotateX(Math.PI / 2);
  const edges = new LineBasicMaterial({color: colours.edge, transparent: true, opacity: 0.4});
  group.add(new LineSegments(new EdgesGeometry(coarse, 1), edges));
  if (shape.center) group.position.set(...shape.center);
  return group;
}

/** Returns the rim of a round opening whose axis passes through the world's origin, with a translucent disc inside. */
export function openingOf(center: Triple, diameter: number, colours: {edge: string}): Object3D {
  const group = new Group();
  const rim = new TorusGeometry(diameter / 2, 0.03 * diameter, 8, 48);
  group.add(new Mesh(rim, new MeshStandardMaterial({color: colours.edge, roughness: 0.8})));
  group.add(new Mesh(new CircleGeometry(diameter / 2, 48), veil(colours.edge, 0.18)));
  group.position.set(...center);
  group.lookAt(0, 0, 0);
  return group;
}

/** Frees the graphics memory of all objects below `root`. */
export function disposeAll(root: Object3D): void {
  root.traverse((object) => {
    const mesh = object as Mesh;
    mesh.geometry?.dispose();
    const material = mesh.material as Material | Material[] | undefined;
    for (const one of Array.isArray(material) ? material : material ? [material] : []) {
      (one as MeshStandardMaterial).map?.dispose();
      one.dispose();
    }
  });
}
