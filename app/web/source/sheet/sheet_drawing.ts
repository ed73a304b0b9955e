// The drawing of a sheet: three layers (ground, holes, and the painting of a view) with a common camera, drawn at most
// once per frame.
import type {Signal} from "@preact/signals";
import {drawRings, pixelRatio} from "../drawing/canvas";
import {palette, type Palette} from "../drawing/colours";
import type {Colouring} from "./colourings";
import {drawGround, drawTicks} from "./ground_layer";
import {HoleLayer} from "./hole_layer";
import {isInside} from "../drawing/lasso";
import {fromPixel, toPixel, type Camera, type Size} from "../../../drawing/frames.js";
import {fit, panned, zoomed} from "./sheet_camera";
import type {SheetModel} from "./sheet_model";

/** Function that paints the view's own content over the holes. */
export type PaintOver = (context: CanvasRenderingContext2D, camera: Camera, size: Size, palette: Palette) => void;

export interface SheetPictureProps {
  sheet: SheetModel;
  /** Unit of the sheet's lengths. */
  unit: string;
  colouring: Colouring;
  hidden?: ReadonlySet<number>;
  selection?: ReadonlySet<number>;
  picked?: Signal<number>;
  paintOver?: PaintOver;
  onPick?: (hole: number, event: {shiftKey: boolean; ctrlKey: boolean; metaKey: boolean}) => void;
  onLasso?: (holes: number[], isMore: boolean) => void;
  /** True in a scrolling page, where the wheel zooms only with Ctrl pressed. */
  isInText?: boolean;
}

export class SheetDrawing {
  camera: Camera = {u: 0, v: 0, scale: 1};
  size: Size = {width: 0, height: 0};
  ratio = 1;
  hover = -1;
  lasso: [number, number][] = [];
  props!: SheetPictureProps;
  private isFitted = true;
  private isRequested = false;
  private parts = {ground: true, holes: true, over: true};
  private readonly ground: CanvasRenderingContext2D;
  private readonly over: CanvasRenderingContext2D;
  private readonly holes: HoleLayer;

  constructor(readonly canvases: HTMLCanvasElement[]) {
    this.ground = canvases[0].getContext("2d")!;
    this.holes = new HoleLayer(canvases[1].getContext("2d")!);
    this.over = canvases[2].getContext("2d")!;
  }

  resize(width: number, height: number): void {
    if (width < 2 || height < 2) return;
    this.ratio = pixelRatio();
    this.size = {width, height};
    for (const canvas of this.canvases) {
      canvas.width = Math.round(width * this.ratio);
      canvas.height = Math.round(height * this.ratio);
    }
    for (const context of [this.ground, this.over]) context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    if (this.isFitted) this.fit();
    this.drawNow();
  }

  fit(): void {
    this.isFitted = true;
    this.camera = fit(this.props.sheet.plate, this.size);
    this.requestFrame();
  }

  move(camera: Camera): void {
    this.isFitted = false;
    this.camera = camera;
    this.requestFrame();
  }

  limits(): [number, number] {
    const least = fit(this.props.sheet.plate, this.size).scale;
    return [0.5 * least, 90 / this.props.sheet.holeRadius];
  }

  zoom(x: number, y: number, factor: number): void {
    this.move(zoomed(this.camera, this.size, x, y, factor, this.limits()));
  }

  /**
   * Requests that layers are drawn at the next frame. The layer over the holes is always drawn, because it is cheap.
   */
  requestFrame(parts: {ground?: boolean; holes?: boolean} = {ground: true, holes: true}): void {
    this.parts = {ground: this.parts.ground || !!parts.ground, holes: this.parts.holes || !!parts.holes, over: true};
    if (this.isRequested) return;
    this.isRequested = true;
    requestAnimationFrame(() => this.drawNow());
  }

  drawNow(): void {
    this.isRequested = false;
    const {sheet, colouring, hidden} = this.props;
    if (this.size.width === 0 || !palette.peek().ink) return;
    const start = performance.now();
    const colours = palette.peek();
    if (this.parts.ground) drawGround(this.ground, sheet, this.camera, this.size, colours);
    if (this.parts.holes) {
      this.holes.draw(
        sheet,
        this.camera,
        this.size,
        this.ratio,
        colours,
        colouring.kinds.map((kind) => kind.mark),
        colouring.of,
        colouring.kinds.map((_, kind) => !hidden?.has(kind)),
      );
    }
    this.drawOver(colours);
    this.parts = {ground: false, holes: false, over: false};
    performance.clearMeasures("sheet"); // observers have received the measure, so it need not be stored
    performance.measure("sheet", {start});
  }

  private drawOver(colours: Palette): void {
    const context = this.over,
      {size, camera} = this;
    context.clearRect(0, 0, size.width, size.height);
    this.drawSelection(colours);
    context.save();
    this.props.paintOver?.(context, camera, size, colours);
    context.restore();
    this.ringAbout(this.props.picked?.peek() ?? -1, colours.accent, 2.4, 5);
    this.ringAbout(this.hover, colours.ink, 1.4, 3);
    this.drawLasso(colours);
    drawTicks(context, this.props.sheet, camera, size, colours);
  }

  private drawSelection(colours: Palette): void {
    const {selection, sheet} = this.props;
    if (!selection || selection.size === 0) return;
    // The ring leaves the shape of the hole's own mark visible, and stays clear of the neighbouring marks.
    const mark = sheet.holeRadius * this.camera.scale;
    const r = Math.max(3.2, 1.22 * mark, 0.47 * sheet.pitch * this.camera.scale);
    this.over.strokeStyle = colours.accent;
    this.over.lineWidth = Math.min(2, Math.max(0.8, r - mark - 0.4));
    const places = [...selection].map((hole) => toPixel(this.camera, this.size, sheet.u[hole], sheet.v[hole]));
    drawRings(this.over, places, r);
  }

  private ringAbout(hole: number, colour: string, width: number, more: number): void {
    if (hole < 0 || hole >= this.props.sheet.count) return;
    const {sheet} = this.props;
    const place = toPixel(this.camera, this.size, sheet.u[hole], sheet.v[hole]);
    this.over.strokeStyle = colour;
    this.over.lineWidth = width;
    drawRings(this.over, [place], sheet.holeRadius * this.camera.scale + more);
  }

  private drawLasso(colours: Palette): void {
    if (this.lasso.length < 2) return;
    const context = this.over;
    context.beginPath();
    this.lasso.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
    context.closePath();
    context.globalAlpha = 0.12;
    context.fillStyle = colours.accent;
    context.fill();
    context.globalAlpha = 1;
    context.strokeStyle = colours.accent;
    context.lineWidth = 1.5;
    context.setLineDash([5, 4]);
    context.stroke();
    context.setLineDash([]);
  }

  holeAt(x: number, y: number): number {
    const {sheet} = this.props;
    const reach = Math.max(sheet.pitch * 0.72, 9 / this.camera.scale);
    const [u, v] = fromPixel(this.camera, this.size, x, y);
    return sheet.nearest(u, v, reach);
  }

  insideLasso(): number[] {
    const polygon = this.lasso.map(([x, y]) => fromPixel(this.camera, this.size, x, y));
    const {sheet} = this.props;
    const found: number[] = [];
    for (let i = 0; i < sheet.count; ++i) if (isInside(polygon, sheet.u[i], sheet.v[i])) found.push(i);
    return found;
  }

  /** Moves the picture by the smallest distance that makes a hole visible. */
  reveal(hole: number): void {
    const {sheet} = this.props;
    const [x, y] = toPixel(this.camera, this.size, sheet.u[hole], sheet.v[hole]);
    const dx = x < 60 ? 60 - x : x > this.size.width - 40 ? this.size.width - 40 - x : 0;
    const dy = y < 40 ? 40 - y : y > this.size.height - 50 ? this.size.height - 50 - y : 0;
    if (dx !== 0 || dy !== 0) this.move(panned(this.camera, dx, dy));
  }

  zoomMiddle(factor: number): void {
    this.zoom(this.size.width / 2, this.size.height / 2, factor);
  }
}
