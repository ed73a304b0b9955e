// The 3-D picture within a view, with its buttons and the clearance next to the line to the nearest object.
import {choicesOf, Segments} from "../drawing/segments";
import {signal} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {Vector3} from "three";
import {palette} from "../drawing/colours";
import {Check} from "../drawing/fields";
import {MarkIcon} from "../drawing/marks";
import {lengthAndUnit, short, tickTexts, whole} from "../../../drawing/numbers.js";
import type {PoseDocument} from "../server/documents";
import {cell, sceneDocument, units} from "../server/workbench";
import {sheet, view} from "../shell/page_state";
import {ProblemWords} from "../shell/states";
import type {ArmLook} from "./arm_bodies";
import {ArmStage, openStage, pictureReach} from "./arm_stage";
import {readingErrors, type ReadingErrors} from "../error/residuals";
import {factorOf} from "./error_arrow";
import {fieldFactor, SIZE_COLOURS, sizeEnds} from "./error_field";
import {labelLeft} from "./label_place";
import {savePicture} from "./picture_file";
import {poseRequest, type ShownReading} from "./pose_link";

const TIMES = [1, 10, 50].map((times) => ({value: times, words: `×${times}`, hint: `Deflection drawn ${times} times`}));
export const magnified = signal(1);
const LOOKS: readonly (readonly [ArmLook, string])[] = [
  ["shapes", "Shapes"],
  ["skeleton", "Skeleton"],
];
const armLook = signal<ArmLook>("shapes");
/** Display of the joint axes with the names of the joints, which a skeleton always has. */
const areAxesShown = signal(false);
/** Display of the errors of all readings: on or off, and the blend from before (0) to after (1). */
const isFieldShown = signal(false);
const fade = signal(1);
/** True if the arrows of all readings are coloured by size instead of by series. */
const isBySize = signal(false);
const VIEWS = [
  ["corner", "Corner"],
  ["side", "Side"],
  ["front", "Front"],
  ["below", "Below"],
] as const;

function makeStage(canvas: HTMLCanvasElement): ArmStage | string {
  try {
    return new ArmStage(canvas);
  } catch {
    return "This browser draws no 3-D pictures (WebGL is off); everything else works.";
  }
}

export function ArmPicture({tour = null, isSmall = false}: {tour?: Vector3[] | null; isSmall?: boolean}) {
  const errors = isFieldShown.value && !isSmall ? readingErrors.value : null;
  const {canvas, figure, names, refusal, stage} = useStage();
  useScene(stage, tour);
  usePose(stage);
  useErrors(stage, errors);
  useLook(stage);
  return (
    <div class="arm-picture">
      <div class="fill">
        <canvas ref={canvas} aria-label="The arm, rigid and deflected, under the sheet" role="img" />
      </div>
      <span ref={figure} class="clearance-figure" />
      <div ref={names} class="joint-names" aria-hidden="true" />
      <p ref={refusal} class="refusal muted" />
      {sceneDocument.value.problem ? <ProblemWords problem={sceneDocument.value.problem} /> : null}
      <StageBar stage={stage} isSmall={isSmall} />
    </div>
  );
}

type StageRef = {current: ArmStage | null};

/** Creates the stage on a canvas that fills its box; reports the reason if this browser cannot draw in 3-D. */
function useStage() {
  const canvas = useRef<HTMLCanvasElement>(null),
    figure = useRef<HTMLSpanElement>(null);
  const names = useRef<HTMLDivElement>(null);
  const stage = useRef<ArmStage | null>(null),
    refusal = useRef<HTMLParagraphElement>(null);
  useEffect(() => {
    const made = makeStage(canvas.current!);
    if (typeof made === "string") {
      refusal.current!.textContent = made;
      return;
    }
    stage.current = openStage.value = made;
    made.onDraw = () => {
      placeFigure(made, figure.current!);
      placeNames(made, names.current!);
    };
    const box = canvas.current!.parentElement!;
    const observer = new ResizeObserver(() => made.resize(box.clientWidth, box.clientHeight));
    observer.observe(box);
    made.resize(box.clientWidth, box.clientHeight);
    return () => {
      observer.disconnect();
      made.dispose();
      stage.current = null;
      if (openStage.peek() === made) openStage.value = null;
    };
  }, []);
  return {canvas, figure, names, refusal, stage};
}

/** Shows the cell, the sheet and the tour; a new cell is viewed from a corner. */
function useScene(stage: StageRef, tour: Vector3[] | null): void {
  const scene = sceneDocument.value.document;
  useEffect(() => {
    if (!scene || !stage.current) return;
    stage.current.setCell(scene, sheet.value, palette.value);
    stage.current.setTour(tour, palette.value);
  }, [scene, sheet.value, palette.value]);
  useEffect(() => {
    if (scene) stage.current?.look("corner");
  }, [scene, sheet.value]);
  useEffect(() => stage.current?.setTour(tour, palette.value), [tour]);
}

/** Shows the arm in the requested posture, with the errors of the reading taken there. */
function usePose(stage: StageRef): void {
  const scene = sceneDocument.value.document,
    reading = poseRequest.reading.value;
  useEffect(() => {
    if (poseRequest.answer.value) stage.current?.setPose(poseRequest.answer.value, magnified.value);
  }, [poseRequest.answer.value, magnified.value, scene]);
  useEffect(() => stage.current?.setReading(reading, palette.value), [reading, scene, palette.value]);
}

/** Shows the errors of all readings; null hides them. */
function useErrors(stage: StageRef, errors: ReadingErrors | null): void {
  const scene = sceneDocument.value.document;
  useEffect(() => {
    stage.current?.setErrors(errors, palette.value, isBySize.value);
    stage.current?.fadeErrors(errors && errors.series.length > 1 ? fade.peek() : 0);
  }, [errors, scene, palette.value, isBySize.value]);
  useEffect(() => {
    if (errors && errors.series.length > 1) stage.current?.fadeErrors(fade.value);
  }, [fade.value]);
  const isShown = errors !== null;
  useEffect(() => {
    if (errors) stage.current?.fit(errors.places);
  }, [isShown]);
}

/** Draws the arm by its shapes or as a skeleton, with the axes of the joints where they are chosen. */
function useLook(stage: StageRef): void {
  const joints = cell.value?.joints,
    hasAxes = areAxesShown.value || armLook.value === "skeleton";
  useEffect(() => stage.current?.setLook(armLook.value), [armLook.value]);
  useEffect(() => {
    stage.current?.setAxes(hasAxes && joints ? joints : []);
  }, [hasAxes, joints, palette.value, sceneDocument.value.document]);
}

function StageBar({stage, isSmall}: {stage: StageRef; isSmall: boolean}) {
  const reading = poseRequest.reading.value;
  return (
    <div class="stage-bar">
      <Segments
        label="Deflection drawn"
        choices={TIMES}
        value={magnified.value}
        onChoose={(times) => (magnified.value = times)}
      />
      <Segments
        label="View"
        choices={choicesOf(VIEWS)}
        value={undefined}
        onChoose={(from) => stage.current?.look(from)}
      />
      <button
        class="button small"
        title="Bring the arm, and the errors if they are shown, into the picture"
        onClick={() => stage.current?.fit(isFieldShown.value && !isSmall ? (readingErrors.value?.places ?? []) : [])}
      >
        Fit
      </button>
      {!isSmall && sceneDocument.value.document?.arm.some((row) => row.bodies.length > 0) ? (
        <Segments
          label="Arm drawn by"
          choices={choicesOf(LOOKS)}
          value={armLook.value}
          onChoose={(look) => (armLook.value = look)}
        />
      ) : null}
      {armLook.value === "skeleton" ? null : (
        <Check of={areAxesShown} title="The axis and the name of each joint" kind="stage-check">
          axes
        </Check>
      )}
      <button
        class="button small"
        title="Save this picture as a PNG"
        onClick={() => stage.current && savePicture(stage.current)}
      >
        Picture
      </button>
      {reading ? <ShownErrors reading={reading} factor={factorOf(reading, pictureReach.value)} /> : null}
      {!isSmall && readingErrors.value ? <FieldBar errors={readingErrors.value} /> : null}
      {isSmall || reading ? null : (
        <span class="arm-legend">
          <i class="swatch ghost" /> rigid <i class="swatch solid" /> deflected
        </span>
      )}
    </div>
  );
}

/** Controls that switch the errors of all readings on and off and blend them from before to after. */
function FieldBar({errors}: {errors: ReadingErrors}) {
  const hasTwo = errors.series.length > 1;
  return (
    <span class="shown-errors">
      <Check of={isFieldShown} title="The errors of all readings as arrows at their places" kind="">
        all errors
      </Check>
      {isFieldShown.value && hasTwo ? (
        <label class="fade" title={errors.series.map((series) => series.name).join("; ")}>
          <MarkIcon mark={errors.series[0].mark} size={12} isHollow /> before
          <input
            type="range"
            min={0}
            max={1}
            step={0.01}
            value={fade.value}
            aria-label="From before to after"
            onInput={(event) => (fade.value = Number(event.currentTarget.value))}
          />
          <MarkIcon mark={errors.series[1].mark} size={12} /> after
        </label>
      ) : null}
      {isFieldShown.value ? (
        <Check of={isBySize} title="Colours by the size of the error instead of before and after" kind="">
          by size
        </Check>
      ) : null}
      {isFieldShown.value && isBySize.value ? <SizeScale errors={errors} /> : null}
      {isFieldShown.value ? <span class="muted">drawn ×{whole(fieldFactor(errors, pictureReach.value))}</span> : null}
    </span>
  );
}

/** Scale of the colours of error sizes: a swatch for each, with the sizes at which they change. */
function SizeScale({errors}: {errors: ReadingErrors}) {
  const ends = tickTexts(sizeEnds(errors));
  return (
    <span class="size-scale" role="img" aria-label={`Colours change at ${ends.join(", ")} ${units.value.length}`}>
      {SIZE_COLOURS.map((name, k) => (
        <>
          <i style={{background: `var(--${name})`}} />
          {k < ends.length ? <small>{ends[k]}</small> : null}
        </>
      ))}
      <small>{units.value.length}</small>
    </span>
  );
}

/** Legend of the error arrows at the tip, with a button that removes the arrows. */
function ShownErrors({reading, factor}: {reading: ShownReading; factor: number}) {
  return (
    <span class="shown-errors" role="status">
      <b>reading {reading.id}</b>
      {reading.errors.map(({mark, error}, k) => (
        <span title={reading.words[k]}>
          <MarkIcon mark={mark} size={12} isHollow={k === 0} /> {k === 0 ? "before" : "after"}{" "}
          {error ? short(Math.hypot(...error)) : "–"} {units.value.length}
        </span>
      ))}
      <span class="muted" title="From the modelled tip, a full ball, to the measured one, a wire ball">
        modelled to measured, drawn ×{whole(factor)}
      </span>
      <button class="button small" onClick={() => (view.value = "error")}>
        Back to the errors
      </button>
    </span>
  );
}

/** Returns the clearance with its unit; below zero, the two bodies in collision. */
function clearanceText({distance, pair}: NonNullable<PoseDocument["clearance"]>): string {
  const size = lengthAndUnit(Math.abs(distance), units.peek().length, 2);
  return distance < 0 ? `in collision by ${size}: ${pair.join(" and ")}` : size;
}

function placeFigure(stage: ArmStage, figure: HTMLSpanElement): void {
  const clearance = poseRequest.answer.peek()?.clearance;
  const at =
    clearance?.to && magnified.peek() === 1
      ? stage.onScreen(new Vector3(...clearance.from).add(new Vector3(...clearance.to)).multiplyScalar(0.5))
      : null;
  figure.style.display = at ? "" : "none";
  if (!at || !clearance) return;
  figure.textContent = clearanceText(clearance);
  const left = labelLeft(at[0], figure.offsetWidth, stage.canvas.clientWidth);
  figure.style.transform = `translate(${left}px, ${Math.round(at[1] - 10)}px)`;
}

/** Puts the name of each joint at the end of its axis. */
function placeNames(stage: ArmStage, box: HTMLDivElement): void {
  while (box.childElementCount > stage.axes.length) box.lastElementChild!.remove();
  stage.axes.forEach(({name, to}, k) => {
    const label = (box.children[k] ?? box.appendChild(document.createElement("span"))) as HTMLSpanElement;
    const at = stage.onScreen(to);
    label.textContent = name;
    label.style.display = at ? "" : "none";
    if (at) label.style.transform = `translate(${Math.round(at[0] + 4)}px, ${Math.round(at[1] - 9)}px)`;
  });
}
