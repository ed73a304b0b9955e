// Joint by joint: small pictures of the error as that of each joint, the loudest framed. One look says where.
import {useEffect, useMemo, useRef} from "preact/hooks";
import {clearedContext} from "../drawing/canvas";
import {palette, type Palette} from "../drawing/colours";
import {marksPath} from "../drawing/marks";
import {
  loudest,
  MULTIPLE_COLUMNS,
  multiplesOf,
  multiplesScale,
  panelPlaces,
  type Multiple,
} from "../../../drawing/joint_multiples.js";
import {chance, short} from "../../../drawing/numbers.js";
import {MOST_POINTS} from "../../../drawing/shares.js";
import {cell, sceneDocument} from "../server/workbench";
import {chosenPart, chosenVariable, parts, shownView, variables} from "./focus";
import {compare} from "./loop";
import {readingErrors, type ReadingErrors} from "./residuals";
import {SeriesLegend} from "./series_legend";

function rowOf(joint: string): string {
  const row = cell.value?.joints.find((entry) => entry.name === joint)?.row;
  return sceneDocument.value.document?.arm.find((entry) => entry.row === row)?.name ?? "";
}

export function JointPanels() {
  const errors = readingErrors.value;
  const tested = compare.value.document?.tested ?? [];
  const multiples = useMemo(
    () => (errors ? multiplesOf({errors, variables: variables.value, parts: parts.value, tested, rowOf}) : []),
    [errors, variables.value, parts.value, tested, sceneDocument.value],
  );
  const loud = loudest(multiples);
  const most = useMemo(() => multiplesScale(multiples, errors), [multiples, errors]);
  if (!errors || multiples.length === 0)
    return <p class="muted pad">The joints stand here once readings are compared.</p>;
  return (
    <div class="panel-body flush with-legend">
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
                <JointPanel multiple={entry} errors={errors} most={most} isLoud={entry === loud} />
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
    </div>
  );
}

function JointPanel({
  multiple,
  errors,
  most,
  isLoud,
}: {
  multiple: Multiple;
  errors: ReadingErrors;
  most: number;
  isLoud: boolean;
}) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const element = canvas.current!;
    const draw = () => drawPanel(element, multiple, errors, most, palette.value);
    const observer = new ResizeObserver(draw);
    observer.observe(element.parentElement!);
    draw();
    return () => observer.disconnect();
  }, [multiple, errors, most, palette.value]);
  const {variable, part, joint, column, p} = multiple;
  const isShown = shownView.value?.variable.key === variable.key && shownView.value.part.key === part.key;
  const words = `Error of ${joint} against ${variable.name}, ${chance(p)}${isLoud ? ", the most significant" : ""}`;
  return (
    <button
      class={`joint-panel ${isLoud ? "loud" : ""}`}
      aria-pressed={isShown}
      aria-label={words}
      title={`${words}. Click: in the large plot`}
      data-panel={`${joint} ${column}`}
      onClick={() => {
        chosenVariable.value = variable.key;
        chosenPart.value = part.key;
      }}
    >
      <canvas ref={canvas} aria-hidden="true" />
      <small>{chance(p)}</small>
    </button>
  );
}

function drawPanel(
  canvas: HTMLCanvasElement,
  multiple: Multiple,
  errors: ReadingErrors,
  most: number,
  colours: Palette,
): void {
  const {clientWidth: width, clientHeight: height} = canvas;
  const context = clearedContext(canvas, width, height);
  const {points, means, zero} = panelPlaces(multiple, errors, most, width, height);
  context.strokeStyle = colours.line;
  context.beginPath();
  context.moveTo(0, zero);
  context.lineTo(width, zero);
  context.stroke();
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
  context.beginPath();
  means.forEach(([x, y]) => context.lineTo(x, y));
  context.stroke();
}
