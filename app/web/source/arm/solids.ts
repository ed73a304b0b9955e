// Meshes for the shapes of a cell file and for the arm's members.
import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  CircleGeometry,
  CylinderGeometry,
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
import type {SolidShape, Units, Vector3 as Triple} from "../server/documents";

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

/**
 * Returns the mesh of a solid shape in the shape's own frame; null for half spaces and insides, which are drawn as
 * boundaries of the scene.
 */
export function solidOf(shape: SolidShape, material: Material, units: Units | undefined): Object3D | null {
  const geometry = geometryOf(shape);
  if (!geometry) return null;
  const mesh = new Mesh(geometry, material);
  if (shape.mesh?.positions) return mesh; // in the world frame already
  if (shape.from && shape.to) layAlong(mesh, vector(shape.from), vector(shape.to));
  else if (shape.center) mesh.position.set(...shape.center);
  if (shape.rpy) mesh.rotation.set(...(shape.rpy.map((angle) => inRadians(angle, units)) as Triple), "ZYX");
  return mesh;
}

function inRadians(angle: number, units: Units | undefined): number {
  return units?.angle === "rad" ? angle : (angle * Math.PI) / 180;
}

function geometryOf(shape: SolidShape): BufferGeometry | null {
  if (shape.mesh?.positions) return meshOf(shape.mesh.positions);
  switch (shape.kind) {
    case "box":
      return new BoxGeometry(...(shape.size ?? [1, 1, 1]));
    case "sphere":
      return new SphereGeometry(shape.radius ?? 1, 32, 20);
    case "capsule":
    case "cylinder": {
      if (!shape.from || !shape.to) return null;
      const long = vector(shape.to).distanceTo(vector(shape.from)),
        r = shape.radius ?? 1;
      return shape.kind === "capsule" ? new CapsuleGeometry(r, long, 8, 22) : new CylinderGeometry(r, r, long, 28);
    }
    default:
      return null;
  }
}

/** Returns triangles from the coordinates of their corners, one triangle after another. */
function meshOf(positions: readonly number[]): BufferGeometry {
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** Returns the mesh of an obstacle, filled and with its edges, visible in any light. */
export function obstacleOf(
  shape: SolidShape,
  units: Units | undefined,
  colours: {fill: string; edge: string},
): Object3D | null {
  const look = {color: colours.fill, roughness: 0.9, transparent: true, opacity: 0.85};
  const solid = solidOf(shape, new MeshStandardMaterial(look), units);
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
