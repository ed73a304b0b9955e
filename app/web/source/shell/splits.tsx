// Splitters between the panels of a view: dragged, or moved by the arrow keys. The shares are kept in this browser.
import {signal} from "@preact/signals";
import {keep, keptObject} from "./kept";

const KEPT = "tubeplan.splits";
const LEAST = 0.15;
const STEP = 0.02;

/** Share of the first panel at each splitter, keyed by the splitter's name. */
const shares = signal(keptObject<number>(KEPT));

/** Splitters of the views: the share at first, and the direction in which the panels follow one another. */
const SPLITS = {
  "error-columns": {share: 0.46, axis: "x", words: "Widths of the panels"},
  "error-rows": {share: 0.5, axis: "y", words: "Heights of the panels"},
  "plan-columns": {share: 0.535, axis: "x", words: "Widths of the panels"},
  "plan-rows": {share: 0.63, axis: "y", words: "Heights of the panels"},
} as const;
type SplitName = keyof typeof SPLITS;

function shareOf(name: SplitName): number {
  const kept = shares.value[name];
  return typeof kept === "number" && kept >= LEAST && kept <= 1 - LEAST ? kept : SPLITS[name].share;
}

function setShare(name: SplitName, share: number): void {
  shares.value = {...shares.peek(), [name]: Math.max(LEAST, Math.min(1 - LEAST, share))};
}

function keepShares(): void {
  keep(KEPT, shares.peek());
}

/** Returns the shares as style variables of the view's grid, such as --error-columns-1 and --error-columns-2. */
export function splitStyle(...names: SplitName[]): Record<string, string> {
  return Object.fromEntries(
    names.flatMap((name) => [
      [`--${name}-1`, `${100 * shareOf(name)}fr`],
      [`--${name}-2`, `${100 * (1 - shareOf(name))}fr`],
    ]),
  );
}

/** Splitter of a view, placed in its grid by the class of its name. */
export function Splitter({name}: {name: SplitName}) {
  const {axis, words} = SPLITS[name];
  const keys: Record<string, number> = axis === "x" ? {ArrowLeft: -1, ArrowRight: 1} : {ArrowUp: -1, ArrowDown: 1};
  return (
    <div
      class={`splitter splitter-${axis} ${name}`}
      role="separator"
      tabIndex={0}
      aria-label={words}
      aria-orientation={axis === "x" ? "vertical" : "horizontal"}
      aria-valuenow={Math.round(100 * shareOf(name))}
      aria-valuemin={100 * LEAST}
      aria-valuemax={100 * (1 - LEAST)}
      title="Drag, or move by the arrow keys; double click: initial size"
      onDblClick={() => {
        setShare(name, SPLITS[name].share);
        keepShares();
      }}
      onKeyDown={(event) => {
        const by = keys[event.key];
        if (by === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        setShare(name, shareOf(name) + by * STEP);
        keepShares();
      }}
      onPointerDown={(event) => followDrag(event, name)}
    />
  );
}

/** Moves the splitter with the pointer until the button is released. */
function followDrag(event: PointerEvent & {currentTarget: HTMLElement}, name: SplitName): void {
  const bar = event.currentTarget,
    isX = SPLITS[name].axis === "x";
  const along = ({clientX, clientY}: PointerEvent) => (isX ? clientX : clientY);
  // The grid area of the first panels ends at the splitter; both areas together have the length of all shares.
  const area = bar.parentElement!.getBoundingClientRect(),
    own = bar.getBoundingClientRect();
  const [start, end] = isX ? [area.left, area.right] : [own.top - shareOf(name) * lengthBelow(bar, name), area.bottom];
  bar.setPointerCapture(event.pointerId);
  const move = (moved: PointerEvent) => setShare(name, (along(moved) - start) / (end - start));
  const stop = () => {
    bar.removeEventListener("pointermove", move);
    keepShares();
  };
  bar.addEventListener("pointermove", move);
  bar.addEventListener("pointerup", stop, {once: true});
  bar.addEventListener("pointercancel", stop, {once: true});
}

/** Returns the height that the two rows at a horizontal splitter share [page pixels]. */
function lengthBelow(bar: HTMLElement, name: SplitName): number {
  const {bottom} = bar.parentElement!.getBoundingClientRect(),
    {top} = bar.getBoundingClientRect();
  return (bottom - top) / (1 - shareOf(name));
}
