// Pointers and keys on a sheet: wheel, drag, pinch, lasso, and from hole to hole by arrows.
import type {Signal} from "@preact/signals";
import {toPixel} from "../../../drawing/frames.js";
import {panned} from "./sheet_camera";
import type {SheetDrawing} from "./sheet_drawing";
import {neighbour} from "./sheet_model";

export type Tip = Signal<{x: number; y: number; hole: number} | null>;

export function makeGestures(held: {current: SheetDrawing | null}, isLassoing: Signal<boolean>, tip: Tip) {
  const pointers = new Map<number, [number, number]>();
  let moved = 0,
    pinch = 0;
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
      const at = place(event),
        from = pointers.get(event.pointerId);
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
    drawing.ask({});
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
    drawing.ask({});
    return;
  } else {
    return;
  }
  event.preventDefault();
  event.stopPropagation();
}
