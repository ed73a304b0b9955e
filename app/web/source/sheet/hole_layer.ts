// Draws thousands of holes in about a millisecond: each kind of mark is drawn once for a few sub-pixel offsets and
// copied into an image pixel by pixel. This needs no graphics processor; holes never overlap, so no blending is needed.
import type {Palette} from "../drawing/colours";
import {drawMark, type Mark} from "../drawing/marks";
import {toPixel, type Camera, type Size} from "../../../drawing/frames.js";
import type {SheetModel} from "./sheet_model";

/**
 * Returns the number of sub-pixel offsets along each axis; only small marks need several offsets to look evenly spaced.
 */
function placesOf(radius: number): number {
  return radius < 6 ? 4 : radius < 14 ? 2 : 1;
}

interface Stamp {
  pixels: Uint32Array;
  side: number;
}

export class HoleLayer {
  private picture: ImageData | null = null;
  private target = new Uint32Array(0);
  private stamps = new Map<string, Stamp[]>();
  private stampedAt = "";
  private places = 1;

  constructor(private readonly context: CanvasRenderingContext2D) {}

  /**
   * Draws the holes. `kinds[i]` is the index of the mark of hole i in `marks`; holes with mark k are drawn if
   * `shown[k]`.
   */
  draw(
    sheet: SheetModel,
    camera: Camera,
    size: Size,
    ratio: number,
    palette: Palette,
    marks: readonly Mark[],
    kinds: Uint8Array,
    shown: readonly boolean[],
  ): void {
    const width = Math.round(size.width * ratio),
      height = Math.round(size.height * ratio);
    this.prepare(width, height);
    const radius = Number(Math.max(1.1, sheet.holeRadius * camera.scale * ratio).toPrecision(2));
    this.places = placesOf(radius);
    this.keepStampsOf(`${radius} ${palette.ink} ${palette.paper}`);
    const prepared = marks.map((mark, kind) => (shown[kind] ? this.stampsOf(mark, radius, palette) : null));
    const [left, top] = toPixel(camera, size, 0, 0);
    const scale = camera.scale * ratio;
    for (let i = 0; i < sheet.count; ++i) {
      const stamps = prepared[kinds[i]];
      if (stamps)
        this.stamp(stamps, left * ratio + sheet.u[i] * scale, top * ratio - sheet.v[i] * scale, width, height);
    }
    this.context.putImageData(this.picture!, 0, 0);
  }

  private prepare(width: number, height: number): void {
    if (this.picture === null || this.picture.width !== width || this.picture.height !== height) {
      this.picture = this.context.createImageData(Math.max(1, width), Math.max(1, height));
      this.target = new Uint32Array(this.picture.data.buffer);
    } else {
      this.target.fill(0);
    }
  }

  private keepStampsOf(key: string): void {
    if (this.stampedAt === key) return;
    this.stampedAt = key;
    this.stamps.clear();
  }

  private stampsOf(mark: Mark, radius: number, palette: Palette): Stamp[] {
    const key = `${mark.shape} ${mark.colour}`;
    let known = this.stamps.get(key);
    if (known === undefined) {
      known = makeStamps(mark, radius, this.places, palette);
      this.stamps.set(key, known);
    }
    return known;
  }

  private stamp(stamps: Stamp[], x: number, y: number, width: number, height: number): void {
    const px = Math.floor(x),
      py = Math.floor(y);
    const place = Math.floor((y - py) * this.places) * this.places + Math.floor((x - px) * this.places);
    const {pixels, side} = stamps[place];
    const half = side >> 1;
    const x0 = px - half,
      y0 = py - half;
    if (x0 >= width || y0 >= height || x0 + side <= 0 || y0 + side <= 0) return;
    const fromX = Math.max(0, -x0),
      toX = Math.min(side, width - x0);
    const fromY = Math.max(0, -y0),
      toY = Math.min(side, height - y0);
    const target = this.target;
    for (let row = fromY; row < toY; ++row) {
      let from = row * side + fromX,
        to = (y0 + row) * width + x0 + fromX;
      for (const end = row * side + toX; from < end; ++from, ++to) {
        const pixel = pixels[from];
        if (pixel !== 0) target[to] = pixel;
      }
    }
  }
}

function makeStamps(mark: Mark, radius: number, places: number, palette: Palette): Stamp[] {
  const side = 2 * Math.ceil(radius * 1.15 + 1.5) + 1;
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = side;
  const context = canvas.getContext("2d", {willReadFrequently: true})!;
  context.fillStyle = context.strokeStyle = palette[mark.colour];
  const stamps: Stamp[] = [];
  for (let place = 0; place < places * places; ++place) {
    context.clearRect(0, 0, side, side);
    const dx = ((place % places) + 0.5) / places,
      dy = (Math.floor(place / places) + 0.5) / places;
    drawMark(context, mark.shape, (side >> 1) + dx, (side >> 1) + dy, radius);
    const data = context.getImageData(0, 0, side, side).data;
    stamps.push({pixels: new Uint32Array(data.buffer), side});
  }
  return stamps;
}
