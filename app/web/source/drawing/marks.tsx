// Marks for data points on canvases and next to text, with the outlines used in reports.
import type {ColourName} from "./colours";
import {hollowPath, outlineOf, type Shape} from "../../../drawing/shapes.js";

export type {Shape};

export interface Mark {
  shape: Shape;
  colour: ColourName;
}

interface Paths {
  fill: Path2D | null;
  line: Path2D | null;
  width: number;
}

const made = new Map<string, Paths>();
/** Maximum number of cached shapes and radii. Zooming changes the radius; a full cache is emptied. */
const MOST_MADE = 64;

/** Returns the paths of a shape of radius r about the origin, cached for each shape and radius. */
function pathsOf(shape: Shape, r: number): Paths {
  const key = `${shape} ${r}`;
  const known = made.get(key);
  if (known) return known;
  const {fill, line, width} = outlineOf(shape, 0, 0, r);
  const paths = {fill: fill ? new Path2D(fill) : null, line: line ? new Path2D(line) : null, width};
  if (made.size >= MOST_MADE) made.clear();
  made.set(key, paths);
  return paths;
}

/** Draws a mark of radius r about (x, y) with the context's fill and stroke styles. */
export function drawMark(context: CanvasRenderingContext2D, shape: Shape, x: number, y: number, r: number): void {
  const {fill, line, width} = pathsOf(shape, r);
  context.translate(x, y);
  if (fill) context.fill(fill);
  if (line) {
    context.lineWidth = Math.max(0.9, width * r);
    context.stroke(line);
  }
  context.translate(-x, -y);
}

/**
 * Returns a path with one mark at every position. This is more than twice as fast as parsing the text of thousands of
 * paths.
 */
export function marksPath(shape: Shape, places: Iterable<readonly [number, number]>, r: number): Path2D {
  const one = new Path2D(hollowPath(shape, 0, 0, r)),
    all = new Path2D();
  for (const [e, f] of places) all.addPath(one, {e, f});
  return all;
}

interface MarkAtProps {
  mark: Mark;
  x: number;
  y: number;
  r: number;
  isHollow?: boolean;
}

/** Mark at a position in an SVG picture; a hollow mark is outlined and not filled. */
export function MarkAt({mark, x, y, r, isHollow = false}: MarkAtProps) {
  const colour = `var(--${mark.colour})`;
  if (isHollow) return <path d={hollowPath(mark.shape, x, y, r)} fill="none" stroke={colour} stroke-width={0.28 * r} />;
  const {fill, line, width} = outlineOf(mark.shape, x, y, r);
  return (
    <>
      {fill ? <path d={fill} fill={colour} /> : null}
      {line ? <path d={line} fill="none" stroke={colour} stroke-width={Math.max(0.23, width) * r} /> : null}
    </>
  );
}

/** Mark as an icon next to text. */
export function MarkIcon({mark, size = 14, isHollow = false}: {mark: Mark; size?: number; isHollow?: boolean}) {
  return (
    <svg class="mark" width={size} height={size} viewBox="0 0 16 16" aria-hidden="true" stroke-linejoin="round">
      <MarkAt mark={mark} x={8} y={8} r={6} isHollow={isHollow} />
    </svg>
  );
}
