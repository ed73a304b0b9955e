// The page's own canvases: as sharp as the screen, in the page's type.

/** The family of the page's type, as a canvas's font and a plot's take it. */
export const TYPEFACE = "'IBM Plex Sans Variable', system-ui, sans-serif";

/** Pixels of the canvas for one of the page; more than two cost much and show little. */
export function pixelRatio(): number {
  return Math.min(2, devicePixelRatio || 1);
}

/** Sizes a canvas for its place in the page and clears it; what is drawn is in the page's pixels. */
export function clearedContext(canvas: HTMLCanvasElement, width: number, height: number): CanvasRenderingContext2D {
  const ratio = pixelRatio();
  canvas.width = Math.max(1, Math.round(width * ratio));
  canvas.height = Math.max(1, Math.round(height * ratio));
  const context = canvas.getContext("2d")!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return context;
}

/** Rings of one radius, as one stroke of the context's own colour and width. */
export function drawRings(context: CanvasRenderingContext2D, places: Iterable<[number, number]>, radius: number): void {
  context.beginPath();
  for (const [x, y] of places) {
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.stroke();
}

/** A line through places, as one stroke of the context's own colour and width. */
export function strokeLine(context: CanvasRenderingContext2D, ...places: (readonly number[])[]): void {
  context.beginPath();
  for (const [x, y] of places) context.lineTo(x, y);
  context.stroke();
}
