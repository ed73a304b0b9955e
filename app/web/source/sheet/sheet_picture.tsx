// The sheet as a picture to look at and work on: three layers (ground, holes, and what is drawn over them), moved by
// wheel, drag, pinch and keys; holes are pointed at, picked, and selected with a lasso.
import {useEffect, useMemo, useRef} from "preact/hooks";
import {useSignal, useSignalEffect, type Signal} from "@preact/signals";
import {Icon} from "../drawing/icons";
import {palette, type Palette} from "../drawing/colours";
import {fixed} from "../drawing/numbers";
import type {Colouring} from "./colourings";
import {drawGround, drawTicks, sheetWords} from "./ground_layer";
import {HoleLayer} from "./hole_layer";
import {fit, isInside, panned, toPixel, toSheet, zoomed, type Camera, type Size} from "./sheet_camera";
import {holeName, legWords, neighbour, type SheetModel} from "./sheet_model";

/** What a view draws over the holes. */
export type PaintOver = (context: CanvasRenderingContext2D, camera: Camera, size: Size, palette: Palette) => void;

export interface SheetPictureProps {
  sheet: SheetModel;
  colouring: Colouring;
  hidden?: ReadonlySet<number>;
  selection?: ReadonlySet<number>;
  manway?: [number, number] | null;
  picked?: Signal<number>;
  paintOver?: PaintOver;
  onPick?: (hole: number, event: {shiftKey: boolean; ctrlKey: boolean; metaKey: boolean}) => void;
  onLasso?: (holes: number[], isMore: boolean) => void;
}

class SheetDrawing {
  camera: Camera = {u: 0, v: 0, scale: 1};
  size: Size = {width: 0, height: 0};
  ratio = 1;
  hover = -1;
  lasso: [number, number][] = [];
  props!: SheetPictureProps;
  private isFitted = true;
  private isAsked = false;
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
    this.ratio = Math.min(2, window.devicePixelRatio || 1);
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
    this.camera = fit(this.extent(), this.size);
    this.ask();
  }

  private extent() {
    const {sheet} = this.props;
    const r = sheet.radius;
    if (!sheet.isOneLeg) return {left: -r, right: r, bottom: -r, top: r};
    return sheet.extent.top > 0 ? {left: -r, right: r, bottom: 0, top: r} : {left: -r, right: r, bottom: -r, top: 0};
  }

  move(camera: Camera): void {
    this.isFitted = false;
    this.camera = camera;
    this.ask();
  }

  limits(): [number, number] {
    const least = fit(this.extent(), this.size).scale;
    return [0.5 * least, 90 / this.props.sheet.holeRadius];
  }

  zoom(x: number, y: number, factor: number): void {
    this.move(zoomed(this.camera, this.size, x, y, factor, this.limits()));
  }

  /** Draws at the next frame; what is drawn over the holes alone is cheap and often asked for. */
  ask(parts: {ground?: boolean; holes?: boolean} = {ground: true, holes: true}): void {
    this.parts = {ground: this.parts.ground || !!parts.ground, holes: this.parts.holes || !!parts.holes, over: true};
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => this.drawNow());
  }

  drawNow(): void {
    this.isAsked = false;
    const {sheet, colouring, hidden} = this.props;
    if (this.size.width === 0 || !palette.peek().ink) return;
    const start = performance.now();
    const colours = palette.peek();
    if (this.parts.ground) drawGround(this.ground, sheet, this.camera, this.size, colours, this.props.manway ?? null);
    if (this.parts.holes) {
      this.holes.draw(sheet, this.camera, this.size, this.ratio, colours, colouring.kinds.map((kind) => kind.mark),
                      colouring.of, colouring.kinds.map((_, kind) => !hidden?.has(kind)));
    }
    this.drawOver(colours);
    this.parts = {ground: false, holes: false, over: false};
    performance.clearMeasures("sheet");  // whoever watches is told of each; none are kept
    performance.measure("sheet", {start});
  }

  private drawOver(colours: Palette): void {
    const context = this.over, {size, camera} = this;
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
    const r = Math.max(2.6, sheet.holeRadius * this.camera.scale * 1.22);
    const context = this.over;
    context.beginPath();
    for (const hole of selection) {
      const [x, y] = toPixel(this.camera, this.size, sheet.u[hole], sheet.v[hole]);
      context.moveTo(x + r, y);
      context.arc(x, y, r, 0, 2 * Math.PI);
    }
    context.strokeStyle = colours.accent;
    context.lineWidth = Math.min(2, 0.35 * r);
    context.stroke();
  }

  private ringAbout(hole: number, colour: string, width: number, more: number): void {
    if (hole < 0 || hole >= this.props.sheet.count) return;
    const {sheet} = this.props;
    const [x, y] = toPixel(this.camera, this.size, sheet.u[hole], sheet.v[hole]);
    this.over.beginPath();
    this.over.arc(x, y, sheet.holeRadius * this.camera.scale + more, 0, 2 * Math.PI);
    this.over.strokeStyle = colour;
    this.over.lineWidth = width;
    this.over.stroke();
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
    const [u, v] = toSheet(this.camera, this.size, x, y);
    return sheet.nearest(u, v, reach);
  }

  insideLasso(): number[] {
    const polygon = this.lasso.map(([x, y]) => toSheet(this.camera, this.size, x, y));
    const {sheet} = this.props;
    const found: number[] = [];
    for (let i = 0; i < sheet.count; ++i) if (isInside(polygon, sheet.u[i], sheet.v[i])) found.push(i);
    return found;
  }

  /** Moves the picture just enough to show a hole. */
  reveal(hole: number): void {
    const {sheet} = this.props;
    const [x, y] = toPixel(this.camera, this.size, sheet.u[hole], sheet.v[hole]);
    const dx = x < 60 ? 60 - x : x > this.size.width - 40 ? this.size.width - 40 - x : 0;
    const dy = y < 40 ? 40 - y : y > this.size.height - 50 ? this.size.height - 50 - y : 0;
    if (dx !== 0 || dy !== 0) this.move(panned(this.camera, dx, dy));
  }
}

export function SheetPicture(props: SheetPictureProps) {
  const {sheet, colouring, picked} = props;
  const stage = useRef<HTMLDivElement>(null);
  const drawing = useRef<SheetDrawing | null>(null);
  const isLassoing = useSignal(false);
  const tip = useSignal<{x: number; y: number; hole: number} | null>(null);

  useEffect(() => {
    const element = stage.current!;
    const made = new SheetDrawing([...element.querySelectorAll("canvas")]);
    made.props = props;
    drawing.current = made;
    const observer = new ResizeObserver(() => made.resize(element.clientWidth, element.clientHeight));
    observer.observe(element);
    made.resize(element.clientWidth, element.clientHeight);
    return () => observer.disconnect();
  }, []);
  useEffect(() => {
    drawing.current?.fit();
  }, [sheet]);
  useEffect(() => {
    if (!drawing.current) return;
    drawing.current.props = props;
    drawing.current.ask({ground: true, holes: true});
  });
  useSignalEffect(() => {
    void palette.value;
    void picked?.value;
    drawing.current?.drawNow();
    drawing.current?.ask();
  });
  const gestures = useMemo(() => makeGestures(drawing, isLassoing, tip), []);

  return (
    <div class="sheet-picture">
      <div ref={stage} class={`stage ${isLassoing.value ? "lassoing" : ""}`} tabIndex={0} role="application"
        aria-label={`Tube sheet, ${sheetWords(sheet)}, ${sheet.count} holes. Arrow keys go from hole to hole, Enter picks.`}
        onKeyDown={(event) => sheetKeys(event, drawing.current!, isLassoing, tip)} {...gestures}>
        <canvas /><canvas /><canvas />
      </div>
      <div class="sheet-words">
        <b>{sheetWords(sheet)}</b>
        {sheet.name ? <span>{sheet.name}</span> : null}
        <span>{sheet.count.toLocaleString("en")} holes</span>
      </div>
      <div class="stage-tools" role="toolbar" aria-label="View of the sheet">
        {props.onLasso && (
          <button class="tool" title="Lasso (L, or drag with Shift)" aria-pressed={isLassoing.value}
            onClick={() => (isLassoing.value = !isLassoing.value)}><Icon name="lasso" /></button>)}
        <button class="tool" title="Larger (+)" onClick={() => zoomMiddle(drawing.current!, 1.4)}><Icon name="plus" /></button>
        <button class="tool" title="Smaller (−)" onClick={() => zoomMiddle(drawing.current!, 1 / 1.4)}><Icon name="minus" /></button>
        <button class="tool" title="Whole sheet (0)" onClick={() => drawing.current!.fit()}><Icon name="fit" /></button>
      </div>
      {tip.value && <HoleTip sheet={sheet} colouring={colouring} at={tip.value} size={drawing.current!.size} />}
    </div>
  );
}

function HoleTip({sheet, colouring, at, size}: {
  sheet: SheetModel; colouring: Colouring; at: {x: number; y: number; hole: number}; size: Size
}) {
  const {hole} = at;
  const isRight = at.x > size.width - 230, isLow = at.y > size.height - 130;
  const style = {
    left: isRight ? "auto" : `${at.x + 16}px`,
    right: isRight ? `${size.width - at.x + 16}px` : "auto",
    top: isLow ? "auto" : `${at.y + 14}px`,
    bottom: isLow ? `${size.height - at.y + 14}px` : "auto",
  };
  return (
    <div class="tip" style={style} role="status">
      <b>{legWords(sheet.legs[hole] ?? sheet.leg)} · {holeName(sheet, hole)}</b>
      <span>x {fixed(sheet.world[3 * hole], 3)}, y {fixed(sheet.world[3 * hole + 1], 3)} {sheet.unit}</span>
      <span>{sheet.states[sheet.state[hole]] ?? "open"}</span>
      {colouring.words(hole).map((line) => <span>{line}</span>)}
    </div>
  );
}

function zoomMiddle(drawing: SheetDrawing, factor: number): void {
  drawing.zoom(drawing.size.width / 2, drawing.size.height / 2, factor);
}

// ---- pointers and keys

type Tip = Signal<{x: number; y: number; hole: number} | null>;

function makeGestures(held: {current: SheetDrawing | null}, isLassoing: Signal<boolean>, tip: Tip) {
  const pointers = new Map<number, [number, number]>();
  let moved = 0, pinch = 0;
  const place = (event: PointerEvent | WheelEvent): [number, number] => {
    const box = held.current!.canvases[0].getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const finishLasso = (event: PointerEvent) => {
    const drawing = held.current!;
    if (drawing.lasso.length > 2) drawing.props.onLasso?.(drawing.insideLasso(), event.ctrlKey || event.metaKey);
    drawing.lasso = [];
    isLassoing.value = false;
    drawing.ask({});
  };
  const drag = (event: PointerEvent, from: [number, number], to: [number, number]) => {
    const drawing = held.current!;
    moved += Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (drawing.lasso.length > 0) {
      drawing.lasso.push(to);
      drawing.ask({});
    } else if (pointers.size === 2) {
      const [a, b] = [...pointers.values()];
      const spread = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (pinch > 0) drawing.zoom((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, spread / pinch);
      pinch = spread;
      drawing.move(panned(drawing.camera, (to[0] - from[0]) / 2, (to[1] - from[1]) / 2));
    } else if (moved > 3 && event.buttons !== 0) {
      drawing.move(panned(drawing.camera, to[0] - from[0], to[1] - from[1]));
    }
  };
  const hover = (at: [number, number], isTouch: boolean) => {
    const drawing = held.current!;
    const hole = drawing.holeAt(...at);
    if (hole !== drawing.hover) {
      drawing.hover = hole;
      drawing.ask({});
    }
    tip.value = hole >= 0 && !isTouch ? {x: at[0], y: at[1], hole} : null;
  };
  return {
    onPointerDown: (event: PointerEvent) => {
      if (event.button !== 0) return;
      const at = place(event);
      (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, at);
      moved = 0;
      pinch = 0;
      if (pointers.size === 1 && held.current!.props.onLasso && (isLassoing.value || event.shiftKey)) {
        held.current!.lasso = [at];
      }
    },
    onPointerMove: (event: PointerEvent) => {
      const at = place(event), from = pointers.get(event.pointerId);
      if (from) {
        pointers.set(event.pointerId, at);
        drag(event, from, at);
        tip.value = null;
      } else {
        hover(at, event.pointerType === "touch");
      }
    },
    onPointerUp: (event: PointerEvent) => {
      if (!pointers.delete(event.pointerId)) return;
      const drawing = held.current!;
      if (drawing.lasso.length > 2 && moved > 6) {
        finishLasso(event);
        return;
      }
      drawing.lasso = [];
      if (moved > 4) return;
      const hole = drawing.holeAt(...place(event));
      if (hole >= 0) drawing.props.onPick?.(hole, event);
    },
    onPointerCancel: (event: PointerEvent) => void pointers.delete(event.pointerId),
    onPointerLeave: () => {
      if (!held.current) return;
      held.current.hover = -1;
      tip.value = null;
      held.current.ask({});
    },
    onWheel: (event: WheelEvent) => {
      event.preventDefault();
      tip.value = null;
      held.current!.zoom(...place(event), Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0016)));
    },
    onDblClick: (event: MouseEvent) => held.current!.zoom(...place(event as PointerEvent), 2),
  };
}

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]
};

function sheetKeys(event: KeyboardEvent, drawing: SheetDrawing, isLassoing: Signal<boolean>, tip: Tip): void {
  const {sheet} = drawing.props;
  const arrow = ARROWS[event.key];
  if (arrow && event.shiftKey) {
    drawing.move(panned(drawing.camera, -60 * arrow[0], 60 * arrow[1]));
  } else if (arrow) {
    const start = drawing.hover >= 0 ? drawing.hover : drawing.props.picked?.peek() ?? -1;
    drawing.hover = start >= 0 ? neighbour(sheet, start, ...arrow) : sheet.nearest(sheet.u[0], sheet.v[0], sheet.pitch);
    drawing.reveal(drawing.hover);
    const [x, y] = toPixel(drawing.camera, drawing.size, sheet.u[drawing.hover], sheet.v[drawing.hover]);
    tip.value = {x, y, hole: drawing.hover};
    drawing.ask({});
  } else if (event.key === "Enter" || event.key === " ") {
    if (drawing.hover >= 0) drawing.props.onPick?.(drawing.hover, event);
  } else if (event.key === "+" || event.key === "=") {
    zoomMiddle(drawing, 1.25);
  } else if (event.key === "-") {
    zoomMiddle(drawing, 0.8);
  } else if (event.key === "0") {
    drawing.fit();
  } else if (event.key.toLowerCase() === "l" && drawing.props.onLasso) {
    isLassoing.value = !isLassoing.value;
  } else if (event.key === "Escape") {
    isLassoing.value = false;
    drawing.lasso = [];
    tip.value = null;
    drawing.ask({});
    return;
  } else {
    return;
  }
  event.preventDefault();
  event.stopPropagation();
}
