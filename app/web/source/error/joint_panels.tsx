// Joint by joint: small pictures of the error as that of each joint, the loudest framed. One look says where.
import {useEffect, useMemo, useRef} from "preact/hooks";
import {palette, type Palette} from "../drawing/colours";
import {chance, isNumber, short} from "../../../drawing/numbers.js";
import {besideLevel} from "../../../drawing/variables.js";
import {cell, sceneDocument} from "../server/workbench";
import {binnedMeans} from "./binned";
import {chosenPart, chosenVariable, parts, shownView, variables} from "./focus";
import {COLUMNS, loudest, multiplesOf, type Multiple} from "./joint_multiples";
import {compare} from "./loop";
import {readingErrors, type ReadingErrors} from "./residuals";
import {SeriesLegend} from "./residual_plot";

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
  const most = useMemo(() => scaleOf(multiples, errors), [multiples, errors]);
  if (!errors || multiples.length === 0)
    return <p class="muted pad">The joints stand here once readings are compared.</p>;
  return (
    <div class="panel-body flush with-legend">
      <div class="joint-panels" style={{gridTemplateRows: `auto repeat(${errors.joints.length}, minmax(36px, 1fr))`}}>
        <span class="muted">as error of, {multiples[0].part.unit}</span>
        {COLUMNS.map((column) => (
          <span class="muted">{column}</span>
        ))}
        {errors.joints.map((joint) => (
          <>
            <span class="joint-name">
              <b>{joint}</b>
              <small class="muted">± {short(most)}</small>
            </span>
            {COLUMNS.map((column) => {
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
      <SeriesLegend errors={errors}>
        <span>
          <i class="mean-line" /> means and p: {errors.tested === 0 ? "before" : "after"}
        </span>
      </SeriesLegend>
    </div>
  );
}

/** One scale for all, so that sizes compare: of the errors before, but for the wildest. */
function scaleOf(multiples: readonly Multiple[], errors: ReadingErrors | null): number {
  const sizes = [...new Set(multiples.map((entry) => entry.part))].flatMap((part) =>
    (errors?.series[errors.judged].errors ?? []).flatMap((error, i) => {
      const value = error ? part.of(error, i) : null;
      return isNumber(value) ? [Math.abs(value)] : [];
    }),
  );
  sizes.sort((a, b) => a - b);
  return sizes[Math.floor(0.97 * (sizes.length - 1))] || 1;
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
  const words = `Error of ${joint} against ${variable.name}, ${chance(p)}${isLoud ? ", the loudest" : ""}`;
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

/** So many points say as much as thousands do in a picture of this size. */
const MOST_POINTS = 300;

function drawPanel(
  canvas: HTMLCanvasElement,
  {variable, part}: Multiple,
  errors: ReadingErrors,
  most: number,
  colours: Palette,
): void {
  const box = canvas.parentElement!,
    ratio = Math.min(2, devicePixelRatio || 1);
  const [width, height] = [box.clientWidth, box.clientHeight];
  canvas.width = Math.max(1, Math.round(width * ratio));
  canvas.height = Math.max(1, Math.round(height * ratio));
  const context = canvas.getContext("2d")!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const xs = errors.readings.map((reading, i) => variable.of(reading, i));
  const known = xs.filter(isNumber);
  const low = known.reduce((least, x) => Math.min(least, x), Infinity),
    high = known.reduce((largest, x) => Math.max(largest, x), -Infinity);
  const inner = width - 16;
  const at = (x: number) => 8 + (inner * (x - low)) / (high - low || 1);
  const up = (value: number) => height / 2 - (0.46 * height * Math.max(-1.08, Math.min(1.08, value / most))) / 1.08;
  context.strokeStyle = colours.line;
  context.beginPath();
  context.moveTo(0, up(0));
  context.lineTo(width, up(0));
  context.stroke();
  const step = Math.max(1, Math.ceil(errors.readings.length / MOST_POINTS));
  errors.series.forEach((series, k) => {
    context.strokeStyle = context.fillStyle = colours[series.mark.colour];
    context.globalAlpha = 0.75;
    for (let i = 0; i < xs.length; i += step) {
      const x = xs[i],
        error = series.errors[i],
        value = error ? part.of(error, i) : null;
      if (!isNumber(x) || !isNumber(value)) continue;
      // Levels are spread a little, so that their points are seen.
      const beside = variable.kind === "sense" ? besideLevel(i) * 0.2 * inner : 0;
      const px = at(x) + (x > (low + high) / 2 ? -Math.abs(beside) : Math.abs(beside));
      context.beginPath();
      if (k === 0) {
        context.moveTo(px, up(value) - 2.2);
        context.lineTo(px + 2, up(value) + 1.6);
        context.lineTo(px - 2, up(value) + 1.6);
        context.closePath();
        context.stroke();
      } else {
        context.arc(px, up(value), 1.3, 0, 2 * Math.PI);
        context.fill();
      }
    }
    context.globalAlpha = 1;
  });
  const means = binnedMeans(
    xs,
    errors.series[errors.tested].errors.map((error, i) => (error ? part.of(error, i) : null)),
  );
  context.strokeStyle = colours.ink;
  context.lineWidth = 1.6;
  context.beginPath();
  means.forEach((bin) => context.lineTo(at(bin.x), up(bin.mean)));
  context.stroke();
}
