// Arrows in the 3-D picture, drawn in front of the bodies. All shafts form one object, and all heads another.
import {
  BufferGeometry,
  Color,
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

export interface Arrow {
  from: Vector3;
  way: Vector3;
  /** Colour of this arrow, if the arrows of a group differ in colour. */
  colour?: string;
}

/**
 * Returns a group of arrows in one colour, unless the arrows have their own. `head` is the length of the heads; an arrow shorter than `head` is drawn as a smaller head
 * only.
 */
export function arrowGroup(arrows: readonly Arrow[], head: number, colour: string, renderOrder: number): Group {
  const hasOwn = arrows.some((arrow) => arrow.colour !== undefined);
  const look = {color: hasOwn ? "white" : colour, transparent: true, depthTest: false};
  const colours = arrows.map((arrow) => new Color(arrow.colour ?? colour));
  const ends = arrows.flatMap(({from, way}) => [...from.toArray(), ...from.clone().add(way).toArray()]);
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(ends, 3));
  if (hasOwn) {
    const ofEnds = colours.flatMap((own) => [...own.toArray(), ...own.toArray()]);
    geometry.setAttribute("color", new Float32BufferAttribute(ofEnds, 3));
  }
  const shafts = new LineSegments(geometry, new LineBasicMaterial({...look, vertexColors: hasOwn}));
  const heads = new InstancedMesh(new ConeGeometry(0.3 * head, head, 8), new MeshBasicMaterial(look), arrows.length);
  const placed = new Object3D(),
    up = new Vector3(0, 1, 0);
  arrows.forEach(({from, way}, i) => {
    const long = way.length();
    placed.scale.setScalar(Math.min(1, long / head));
    placed.quaternion.setFromUnitVectors(up, way.clone().normalize());
    placed.position.copy(from).addScaledVector(way, Math.max(0, 1 - (0.5 * head * placed.scale.x) / long));
    placed.updateMatrix();
    heads.setMatrixAt(i, placed.matrix);
    if (hasOwn) heads.setColorAt(i, colours[i]);
  });
  shafts.renderOrder = heads.renderOrder = renderOrder;
  return new Group().add(shafts, heads);
}
