// From the sheet's plane to the picture's pixels and back: u to the right, v upwards.

export interface Camera {
  u: number;
  v: number;
  /** Pixels per unit of length. */
  scale: number;
}

export interface Size {
  width: number;
  height: number;
}

export interface Extent {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

export const MARGIN = {left: 44, right: 20, top: 34, bottom: 46};

export function fit(extent: Extent, size: Size): Camera {
  const width = Math.max(40, size.width - MARGIN.left - MARGIN.right);
  const height = Math.max(40, size.height - MARGIN.top - MARGIN.bottom);
  const scale = Math.min(width / (extent.right - extent.left), height / (extent.top - extent.bottom));
  return {
    u: (extent.left + extent.right) / 2 - (MARGIN.left - MARGIN.right) / 2 / scale,
    v: (extent.bottom + extent.top) / 2 + (MARGIN.top - MARGIN.bottom) / 2 / scale,
    scale,
  };
}

export function toPixel(camera: Camera, size: Size, u: number, v: number): [number, number] {
  return [size.width / 2 + (u - camera.u) * camera.scale, size.height / 2 - (v - camera.v) * camera.scale];
}

export function toSheet(camera: Camera, size: Size, x: number, y: number): [number, number] {
  return [camera.u + (x - size.width / 2) / camera.scale, camera.v - (y - size.height / 2) / camera.scale];
}

/** Zooms by a factor and keeps the place under a pixel where it is. */
export function zoomed(
  camera: Camera,
  size: Size,
  x: number,
  y: number,
  factor: number,
  limits: [number, number],
): Camera {
  const scale = Math.min(limits[1], Math.max(limits[0], camera.scale * factor));
  const [u, v] = toSheet(camera, size, x, y);
  return {u: u - (x - size.width / 2) / scale, v: v + (y - size.height / 2) / scale, scale};
}

export function panned(camera: Camera, dx: number, dy: number): Camera {
  return {...camera, u: camera.u - dx / camera.scale, v: camera.v + dy / camera.scale};
}
