// Joint by joint: small plots of the error expressed as an error of each joint. The plot with the most significant
// dependence is framed.
import {useMemo, useRef} from "preact/hooks";
import {clearedContext, strokeLine} from "../drawing/canvas";
import {palette, type Palette} from "../drawing/colours";
import {marksPath} from "../drawing/marks";
import {usePainted} from "../drawing/painted";
import {
  loudest,
  MULTIPLE_COLUMNS,
  multiplesScale,
  panelPlaces,
  type Multiple,
} from "../../../drawing/joint_multiples.js";
import {chance, short} from "../../../drawing/numbers.js";
import type {ErrorPair} from "../../../drawing/reading_errors.js";
import {MOST_POINTS} from "../../../drawing/shares.js";
import {SeriesLegend} from "./series_legend";

interface JointGridProps {
  errors: ErrorPair;
  multiples: readonly Multiple[];
  /**
   * Returns true for the panel that is shown large; `onChoose` is called when a panel is clicked. Without them, the
   * plots do not react to clicks.
   */
  isShown?: (multiple: Multiple) => boolean;
  onChoose?: (multiple: Multiple) => void;
}

/** Grid with a row for each joint and a column for each kind of variable. */
export function JointGrid({errors, multiples, isShown, onChoose}: JointGridProps) {
  const loud = loudest(multiples);
  const most = useMemo(() => multiplesScale(multiples, errors), [multiples, errors]);
  return (
    <>
      <div class="joint-panels" style={{gridTemplateRows: `auto repeat(${errors.joints.length}, minmax(36px, 1fr))`}}>
        <span class="muted">as error of, {multiples[0].part.unit}</span>
        {MULTIPLE_COLUMNS.map((column) => (
          <span class="muted">{column}</span>
        ))}
        {errors.joints.map((joint) => (
          <>
            <span class="joint-name">
              <b>{joint}</b>
              <small class="muted">± {short(most)}</small>
            </span>
            {MULTIPLE_COLUMNS.map((column) => {
              const entry = multiples.find((one) => one.joint === joint && one.column === column);
              return entry ? (
                <JointPanel
                  multiple={entry}
                  errors={errors}
                  most={most}
                  isLoud={entry === loud}
                  isShown={isShown?.(entry)}
                  onChoose={onChoose}
                />
              ) : (
                <span class="joint-panel none muted">–</span>
              );
            })}
          </>
        ))}
      </div>
      <SeriesLegend errors={errors} most={MOST_POINTS}>
        <span>
          <i class="mean-line" /> means and p: {errors.tested === 0 ? "before" : "after"}; errors beyond ± {short(most)}{" "}
          are drawn at the edge
        </span>
      </SeriesLegend>
    </>
  );
}

interface JointPanelProps {
  multiple: Multiple;
  errors: ErrorPair;
  most: number;
  isLoud: boolean;
  isShown?: boolean;
  onChoose?: (multiple: Multiple) => void;
}

function JointPanel({multiple, errors, most, isLoud, isShown, onChoose}: JointPanelProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  usePainted(canvas, (element) => drawPanel(element, multiple, errors, most, palette.peek()), [
    multiple,
    errors,
    most,
    palette.value,
  ]);
  const {variable, joint, column, p} = multiple;
  const words = `Error of ${joint} against ${variable.name}, ${chance(p)}${isLoud ? ", the most significant" : ""}`;
  const named = {class: `joint-panel ${isLoud ? "loud" : ""}`, "aria-label": words, "data-panel": `${joint} ${column}`};
  const picture = (
    <>
      <canvas ref={canvas} aria-hidden="true" />
      <small>{chance(p)}</small>
    </>
  );
  return onChoose ? (
    <button
      {...named}
      aria-pressed={isShown}
      title={`${words}. Click: in the large plot`}
      onClick={() => onChoose(multiple)}
    >
      {picture}
    </button>
  ) : (
    <div {...named} role="img">
      {picture}
    </div>
  );
}

function drawPanel(
  canvas: HTMLCanvasElement,
  multiple: Multiple,
  errors: ErrorPair,
  most: number,
  colours: Palette,
): void {
  const {clientWidth: width, clientHeight: height} = canvas;
  const context = clearedContext(canvas, width, height);
  const {points, means, zero} = panelPlaces(multiple, errors, most, width, height);
  context.strokeStyle = colours.line;
  strokeLine(context, [0, zero], [width, zero]);
  context.globalAlpha = 0.75;
  points.forEach((places, k) => {
    const {mark} = errors.series[k];
    context.strokeStyle = context.fillStyle = colours[mark.colour];
    if (k === 0) context.stroke(marksPath(mark.shape, places, 2));
    else context.fill(marksPath(mark.shape, places, 1.3));
  });
  context.globalAlpha = 1;
  context.strokeStyle = colours.ink;
  context.lineWidth = 1.6;
  strokeLine(context, ...means);
}
