// Surface above or below the arm: the lower face of the sheet with the divider, or a plain floor.
import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  SRGBColorSpace,
  Shape,
  ShapeGeometry,
} from "three";
import type {Palette} from "../drawing/colours";
import {roundDown125} from "../../../drawing/scales.js";
import type {SheetModel} from "../sheet/sheet_model";
import {veil} from "./solids";

/** Width of the texture of the holes on the sheet's face [pixels]. */
const FACE = 2048;

/**
 * Returns the sheet's lower face. All holes are one texture, which is smooth at any angle and fast on every processor.
 */
export function plateOf(sheet: SheetModel, palette: Palette): Object3D {
  const group = new Group();
  const outline = new Shape();
  if (sheet.isOneLeg)
    outline.absarc(0, 0, sheet.radius, sheet.isLower ? Math.PI : 0, sheet.isLower ? 2 * Math.PI : Math.PI, false);
  else outline.absarc(0, 0, sheet.radius, 0, 2 * Math.PI, false);
  const face = new ShapeGeometry(outline, 64);
  const places = face.getAttribute("position"),
    onPicture = face.getAttribute("uv");
  for (let i = 0; i < places.count; ++i) {
    onPicture.setXY(i, 0.5 + places.getX(i) / (2 * sheet.radius), 0.5 + places.getY(i) / (2 * sheet.radius));
  }
  const plate = new Mesh(
    face,
    new MeshBasicMaterial({map: pictureOf(sheet, palette), side: DoubleSide, transparent: true, depthWrite: false}),
  );
  plate.position.z = 0.001 * sheet.radius;
  group.add(plate, divider(sheet, palette));
  return group;
}

function pictureOf(sheet: SheetModel, palette: Palette): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = FACE;
  const context = canvas.getContext("2d")!;
  context.globalAlpha = 0.78;
  context.fillStyle = palette.plate;
  context.fillRect(0, 0, FACE, FACE);
  context.globalAlpha = 1;
  context.strokeStyle = palette.hole;
  const scale = FACE / (2 * sheet.radius),
    r = sheet.holeRadius * scale;
  context.lineWidth = Math.max(1, 0.3 * r);
  context.beginPath();
  for (let i = 0; i < sheet.count; ++i) {
    const x = FACE / 2 + sheet.world[3 * i] * scale,
      y = FACE / 2 - sheet.world[3 * i + 1] * scale;
    context.moveTo(x + r, y);
    context.arc(x, y, r, 0, 2 * Math.PI);
  }
  context.stroke();
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 8;
  return texture;
}

function divider(sheet: SheetModel, palette: Palette): Object3D {
  if (!sheet.isOneLeg) return new Group();
  const r = sheet.radius;
  const wall = new Shape();
  wall.absarc(0, 0, r, Math.PI, 2 * Math.PI, false);
  const plate = new Mesh(new ShapeGeometry(wall, 40), veil(palette.rim, 0.16));
  plate.rotation.x = Math.PI / 2;
  return plate;
}

/** Returns the plane of the arm's base as a grid, used if the cell has no sheet. */
export function floorOf(palette: Palette, reach: number): Object3D {
  const points: number[] = [];
  const step = 2 * roundDown125(0.1 * reach),
    end = 10 * step;
  for (let k = -10; k <= 10; ++k) points.push(k * step, -end, 0, k * step, end, 0, -end, k * step, 0, end, k * step, 0);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return new LineSegments(geometry, new LineBasicMaterial({color: new Color(palette.line)}));
}
