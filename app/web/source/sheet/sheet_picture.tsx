// The sheet as an interactive picture, moved by wheel, drag, pinch and keys. Holes can be pointed at, picked, and
// selected with a lasso.
import {useEffect, useMemo, useRef} from "preact/hooks";
import {useSignal, useSignalEffect, type Signal} from "@preact/signals";
import {palette} from "../drawing/colours";
import {Icon} from "../drawing/icons";
import {lengthFigure, lengthAndUnit} from "../../../drawing/numbers.js";
import type {Colouring} from "./colourings";
import {sheetWords} from "../../../drawing/sheet_model.js";
import type {Size} from "../../../drawing/frames.js";
import {SheetDrawing, type SheetPictureProps} from "./sheet_drawing";
import {makeGestures, sheetKeys} from "./sheet_gestures";
import {holeName, type SheetModel} from "./sheet_model";

export type {PaintOver} from "./sheet_drawing";

export function SheetPicture(props: SheetPictureProps) {
  const {sheet, colouring} = props;
  const {stage, drawing} = useSheetDrawing(props);
  const isLassoing = useSignal(false);
  const tip = useSignal<{x: number; y: number; hole: number} | null>(null);
  const gestures = useMemo(() => makeGestures(drawing, isLassoing, tip), []);
  return (
    <div class="sheet-picture">
      <div
        ref={stage}
        class={`stage ${isLassoing.value ? "lassoing" : ""}`}
        tabIndex={0}
        role="application"
        aria-label={`Tube sheet, ${sheetWords(sheet)}, ${sheet.count} holes. Arrow keys go from hole to hole, Enter picks.`}
        onKeyDown={(event) => sheetKeys(event, drawing.current!, isLassoing, tip)}
        {...gestures}
      >
        <canvas />
        <canvas />
        <canvas />
      </div>
      <div class="sheet-words">
        <b>{sheetWords(sheet)}</b>
        {sheet.name ? <span>{sheet.name}</span> : null}
        <span>{sheet.count.toLocaleString("en")} holes</span>
      </div>
      <SheetTools drawing={drawing} isLassoing={props.onLasso ? isLassoing : null} />
      {tip.value && (
        <HoleTip sheet={sheet} unit={props.unit} colouring={colouring} at={tip.value} size={drawing.current!.size} />
      )}
    </div>
  );
}

/** Creates the drawing in its stage element: it fills the stage and is drawn again after every change. */
function useSheetDrawing(props: SheetPictureProps) {
  const stage = useRef<HTMLDivElement>(null);
  const drawing = useRef<SheetDrawing | null>(null);
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
  }, [props.sheet]);
  useEffect(() => {
    if (!drawing.current) return;
    drawing.current.props = props;
    drawing.current.requestFrame({ground: true, holes: true});
  });
  useSignalEffect(() => {
    void palette.value;
    void props.picked?.value;
    // The drawing is synchronous, so that a print has the print colours.
    drawing.current?.requestFrame();
    drawing.current?.drawNow();
  });
  return {stage, drawing};
}

interface SheetToolsProps {
  drawing: {current: SheetDrawing | null};
  /** True while a lasso is drawn; null if the picture has no lasso. */
  isLassoing: Signal<boolean> | null;
}

function SheetTools({drawing, isLassoing}: SheetToolsProps) {
  return (
    <div class="stage-tools" role="toolbar" aria-label="View of the sheet">
      {isLassoing ? (
        <button
          class="tool"
          title="Lasso (L, or drag with Shift)"
          aria-pressed={isLassoing.value}
          onClick={() => (isLassoing.value = !isLassoing.value)}
        >
          <Icon name="lasso" />
        </button>
      ) : null}
      <button class="tool" title="Zoom in (+)" onClick={() => drawing.current!.zoomMiddle(1.4)}>
        <Icon name="plus" />
      </button>
      <button class="tool" title="Zoom out (−)" onClick={() => drawing.current!.zoomMiddle(1 / 1.4)}>
        <Icon name="minus" />
      </button>
      <button class="tool" title="Whole sheet (0)" onClick={() => drawing.current!.fit()}>
        <Icon name="fit" />
      </button>
    </div>
  );
}

interface HoleTipProps {
  sheet: SheetModel;
  unit: string;
  colouring: Colouring;
  at: {x: number; y: number; hole: number};
  size: Size;
}

function HoleTip({sheet, unit, colouring, at, size}: HoleTipProps) {
  const {hole} = at;
  const isRight = at.x > size.width - 230,
    isLow = at.y > size.height - 130;
  const style = {
    left: isRight ? "auto" : `${at.x + 16}px`,
    right: isRight ? `${size.width - at.x + 16}px` : "auto",
    top: isLow ? "auto" : `${at.y + 14}px`,
    bottom: isLow ? `${size.height - at.y + 14}px` : "auto",
  };
  return (
    <div class="tip" style={style} role="status">
      <b>
        {sheet.legWords} · {holeName(sheet, hole)}
      </b>
      <span>
        x {lengthFigure(sheet.world[3 * hole], unit)}, y {lengthAndUnit(sheet.world[3 * hole + 1], unit)}
      </span>
      <span>{sheet.stateWords[sheet.state[hole]]}</span>
      {colouring.words(hole).map((line) => (
        <span>{line}</span>
      ))}
    </div>
  );
}
