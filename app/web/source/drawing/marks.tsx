// The marks of maps and legends. Shape alone tells them apart, so that they serve in print and for every eye.
import type {ColourName} from "./colours";

export type Shape =
  "ring" | "dot" | "disc" | "square" | "diamond" | "triangle" | "cross" | "half" | "bar" | "target" | "none";

export interface Mark {
  shape: Shape;
  colour: ColourName;
}

type Path = CanvasRenderingContext2D;

/** Draws a mark of radius r about (x, y); fill and stroke are the context's own. */
export function drawMark(context: Path, shape: Shape, x: number, y: number, r: number): void {
  context.beginPath();
  switch (shape) {
    case "none":
      return;
    case "ring":
      strokeRing(context, x, y, r * 0.86, Math.max(0.9, r * 0.22));
      return;
    case "target":
      strokeRing(context, x, y, r * 0.9, Math.max(1, r * 0.24));
      context.beginPath();
      context.arc(x, y, r * 0.36, 0, 2 * Math.PI);
      break;
    case "dot":
      context.arc(x, y, r * 0.5, 0, 2 * Math.PI);
      break;
    case "disc":
      context.arc(x, y, r, 0, 2 * Math.PI);
      break;
    case "half":
      strokeRing(context, x, y, r * 0.88, Math.max(0.9, r * 0.22));
      context.beginPath();
      context.arc(x, y, r * 0.88, Math.PI / 2, 1.5 * Math.PI);
      break;
    case "square":
      context.rect(x - r * 0.84, y - r * 0.84, r * 1.68, r * 1.68);
      break;
    case "bar":
      context.rect(x - r, y - r * 0.36, r * 2, r * 0.72);
      break;
    case "diamond":
      context.moveTo(x, y - r * 1.08);
      context.lineTo(x + r * 1.08, y);
      context.lineTo(x, y + r * 1.08);
      context.lineTo(x - r * 1.08, y);
      context.closePath();
      break;
    case "triangle":
      context.moveTo(x, y - r * 1.05);
      context.lineTo(x + r, y + r * 0.78);
      context.lineTo(x - r, y + r * 0.78);
      context.closePath();
      break;
    case "cross": {
      const s = r * 0.78;
      context.lineWidth = Math.max(1.2, r * 0.42);
      context.moveTo(x - s, y - s);
      context.lineTo(x + s, y + s);
      context.moveTo(x + s, y - s);
      context.lineTo(x - s, y + s);
      context.stroke();
      return;
    }
  }
  context.fill();
}

function strokeRing(context: Path, x: number, y: number, r: number, width: number): void {
  context.arc(x, y, r, 0, 2 * Math.PI);
  context.lineWidth = width;
  context.stroke();
}

const RING = "M8 2.6a5.4 5.4 0 1 0 .01 0z";
const OUTLINES: Record<Shape, string> = {
  none: "",
  ring: RING,
  target: RING,
  dot: "M8 5a3 3 0 1 0 .01 0z",
  disc: "M8 2.2a5.8 5.8 0 1 0 .01 0z",
  half: RING,
  square: "M3 3h10v10H3z",
  bar: "M2 6h12v4H2z",
  diamond: "M8 1.6L14.4 8 8 14.4 1.6 8z",
  triangle: "M8 2L14.2 13H1.8z",
  cross: "M3.5 3.5l9 9M12.5 3.5l-9 9",
};

const STROKED: ReadonlySet<Shape> = new Set<Shape>(["ring", "cross", "target", "half"]);

/** A mark as a small picture beside text. */
export function MarkIcon({mark, size = 14, isHollow = false}: {mark: Mark; size?: number; isHollow?: boolean}) {
  const colour = `var(--${mark.colour})`;
  const isStroked = isHollow || STROKED.has(mark.shape);
  return (
    <svg class="mark" width={size} height={size} viewBox="0 0 16 16" aria-hidden="true">
      <path
        d={OUTLINES[mark.shape]}
        fill={isStroked ? "none" : colour}
        stroke={isStroked ? colour : "none"}
        stroke-width={mark.shape === "cross" ? 2.6 : 1.7}
      />
      {mark.shape === "target" && <circle cx="8" cy="8" r="2.2" fill={colour} />}
      {mark.shape === "half" && <path d="M8 2.6a5.4 5.4 0 0 0 0 10.8z" fill={colour} />}
    </svg>
  );
}
