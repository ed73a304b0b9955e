// Pointer and key input on a sheet: wheel, drag, pinch, lasso, and arrow keys that move from hole to hole.
import type {Signal} from "@preact/signals";
import {toPixel} from "../../../drawing/frames.js";
import {panned} from "./sheet_camera";
import type {SheetDrawing} from "./sheet_drawing";
import {neighbour} from "./sheet_model";

export type Tip = Signal<{x: number; y: number; hole: number} | null>;

type Place = [number, number];

export function makeGestures(held: {current: SheetDrawing | null}, isLassoing: Signal<boolean>, tip: Tip) {
  const pointers = new SheetPointers(held, isLassoing, tip);
  return {
    onPointerDown: (event: PointerEvent) => pointers.down(event),
    onPointerMove: (event: PointerEvent) => pointers.move(event),
    onPointerUp: (event: PointerEvent) => pointers.up(event),
    onPointerCancel: (event: PointerEvent) => pointers.cancel(event),
    onPointerLeave: () => pointers.leave(),
    onWheel: (event: WheelEvent) => pointers.wheel(event),
    onDblClick: (event: MouseEvent) => pointers.drawing.zoom(...pointers.placeOf(event), 2),
  };
}

/** Pointers that are pressed on a sheet, and the gesture that they make. */
class SheetPointers {
  private readonly places = new Map<number, Place>();
  /** Path length of the pointer since it was pressed [pixels]; near zero for a click. */
  private moved = 0;
  /** Distance between two fingers [pixels]; 0 until it is known. */
  private spread = 0;

  constructor(
    private readonly held: {current: SheetDrawing | null},
    private readonly isLassoing: Signal<boolean>,
    private readonly tip: Tip,
  ) {}

  get drawing(): SheetDrawing {
    return this.held.current!;
  }

  placeOf(event: MouseEvent): Place {
    const box = this.drawing.canvases[0].getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  down(event: PointerEvent): void {
    if (event.button !== 0) return;
    const at = this.placeOf(event);
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.places.set(event.pointerId, at);
    this.moved = 0;
    this.spread = 0;
    const isLasso = this.drawing.props.onLasso && (this.isLassoing.value || event.shiftKey);
    if (this.places.size === 1 && isLasso) this.drawing.lasso = [at];
  }

  move(event: PointerEvent): void {
    const at = this.placeOf(event),
      from = this.places.get(event.pointerId);
    if (from) {
      this.places.set(event.pointerId, at);
      this.drag(event, from, at);
      this.tip.value = null;
    } else {
      this.hover(at, event.pointerType === "touch");
    }
  }

  up(event: PointerEvent): void {
    if (!this.places.delete(event.pointerId)) return;
    if (this.drawing.lasso.length > 2 && this.moved > 6) {
      this.finishLasso(event);
      return;
    }
    this.drawing.lasso = [];
    if (this.moved > 4) return;
    const hole = this.drawing.holeAt(...this.placeOf(event));
    if (hole >= 0) this.drawing.props.onPick?.(hole, event);
  }

  cancel(event: PointerEvent): void {
    this.places.delete(event.pointerId);
  }

  leave(): void {
    if (!this.held.current) return;
    this.drawing.hover = -1;
    this.tip.value = null;
    this.drawing.requestFrame({});
  }

  wheel(event: WheelEvent): void {
    if (this.drawing.props.isInText && !event.ctrlKey) return;
    event.preventDefault();
    this.tip.value = null;
    const step = event.deltaMode === 1 ? 0.05 : 0.0016; // the wheel reports lines or pixels
    this.drawing.zoom(...this.placeOf(event), Math.exp(-event.deltaY * step));
  }

  private drag(event: PointerEvent, from: Place, to: Place): void {
    const {drawing} = this;
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    this.moved += Math.hypot(dx, dy);
    if (drawing.lasso.length > 0) {
      drawing.lasso.push(to);
      drawing.requestFrame({});
    } else if (this.places.size === 2) {
      this.pinch(dx, dy);
    } else if (this.moved > 3 && event.buttons !== 0) {
      drawing.move(panned(drawing.camera, dx, dy));
    }
  }

  private pinch(dx: number, dy: number): void {
    const {drawing} = this;
    const [a, b] = [...this.places.values()];
    const spread = Math.hypot(a[0] - b[0], a[1] - b[1]);
    if (this.spread > 0) drawing.zoom((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, spread / this.spread);
    this.spread = spread;
    drawing.move(panned(drawing.camera, dx / 2, dy / 2));
  }

  private hover(at: Place, isTouch: boolean): void {
    const {drawing} = this;
    const hole = drawing.holeAt(...at);
    if (hole !== drawing.hover) {
      drawing.hover = hole;
      drawing.requestFrame({});
    }
    this.tip.value = hole >= 0 && !isTouch ? {x: at[0], y: at[1], hole} : null;
  }

  private finishLasso(event: PointerEvent): void {
    const {drawing} = this;
    drawing.props.onLasso?.(drawing.insideLasso(), event.ctrlKey || event.metaKey);
    drawing.lasso = [];
    this.isLassoing.value = false;
    drawing.requestFrame({});
  }
}

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export function sheetKeys(event: KeyboardEvent, drawing: SheetDrawing, isLassoing: Signal<boolean>, tip: Tip): void {
  const {sheet} = drawing.props;
  const arrow = ARROWS[event.key];
  if (arrow && event.shiftKey) {
    drawing.move(panned(drawing.camera, -60 * arrow[0], 60 * arrow[1]));
  } else if (arrow) {
    const start = drawing.hover >= 0 ? drawing.hover : (drawing.props.picked?.peek() ?? -1);
    drawing.hover = start >= 0 ? neighbour(sheet, start, ...arrow) : sheet.nearest(sheet.u[0], sheet.v[0], sheet.pitch);
    drawing.reveal(drawing.hover);
    const [x, y] = toPixel(drawing.camera, drawing.size, sheet.u[drawing.hover], sheet.v[drawing.hover]);
    tip.value = {x, y, hole: drawing.hover};
    drawing.requestFrame({});
  } else if (event.key === "Enter" || event.key === " ") {
    if (drawing.hover >= 0) drawing.props.onPick?.(drawing.hover, event);
  } else if (event.key === "+" || event.key === "=") {
    drawing.zoomMiddle(1.25);
  } else if (event.key === "-") {
    drawing.zoomMiddle(0.8);
  } else if (event.key === "0") {
    drawing.fit();
  } else if (event.key.toLowerCase() === "l" && drawing.props.onLasso) {
    isLassoing.value = !isLassoing.value;
  } else if (event.key === "Escape") {
    isLassoing.value = false;
    drawing.lasso = [];
    tip.value = null;
    drawing.requestFrame({});
    return;
  } else {
    return;
  }
  event.preventDefault();
  event.stopPropagation();
}
