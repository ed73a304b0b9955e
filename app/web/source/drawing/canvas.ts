// Canvases of the page: at the screen's resolution, in the page's typeface.

/** Font family of the page, in the notation of canvases and plots. */
export const TYPEFACE = "'IBM Plex Sans Variable', system-ui, sans-serif";

/** Returns the number of canvas pixels per page pixel, at most two: more are slow to draw and hardly visible. */
export function pixelRatio(): number {
  return Math.min(2, devicePixelRatio || 1);
}

/** Resizes a canvas to width x height page pixels and clears it. Drawing coordinates are page pixels. */
export function clearedContext(canvas: HTMLCanvasElement, width: number, height: number): CanvasRenderingContext2D {
  const ratio = pixelRatio();
  canvas.width = Math.max(1, Math.round(width * ratio));
  canvas.height = Math.max(1, Math.round(height * ratio));
  const context = canvas.getContext("2d")!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return context;
}

/** Draws rings of equal radius as one path, in the context's colour and line width. */
export function drawRings(context: CanvasRenderingContext2D, places: Iterable<[number, number]>, radius: number): void {
  context.beginPath();
  for (const [x, y] of places) {
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.stroke();
}

/** Draws a line through the given points, in the context's colour and line width. */
export function strokeLine(context: CanvasRenderingContext2D, ...places: (readonly number[])[]): void {
  context.beginPath();
  for (const [x, y] of places) context.lineTo(x, y);
  context.stroke();
}
