// The camera of a sheet picture: fitted to the sheet's plate, zoomed and moved.
import {fit as fitted, fromPixel, type Camera, type Extent, type Size} from "../../../drawing/frames.js";

export type {Camera, Size};

/** Margins around a sheet that is fitted to its picture [pixels]. */
export const MARGIN = {left: 44, right: 20, top: 34, bottom: 46};

export function fit(extent: Extent, size: Size): Camera {
  return fitted(extent, size, MARGIN);
}

/** Returns the camera zoomed by a factor; the point under the pixel (x, y) stays fixed. */
export function zoomed(
  camera: Camera,
  size: Size,
  x: number,
  y: number,
  factor: number,
  limits: [number, number],
): Camera {
  const scale = Math.min(limits[1], Math.max(limits[0], camera.scale * factor));
  const [u, v] = fromPixel(camera, size, x, y);
  return {u: u - (x - size.width / 2) / scale, v: v + (y - size.height / 2) / scale, scale};
}

export function panned(camera: Camera, dx: number, dy: number): Camera {
  return {...camera, u: camera.u - dx / camera.scale, v: camera.v + dy / camera.scale};
}
