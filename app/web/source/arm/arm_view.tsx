// The arm view: the deflected arm under the sheet, sliders that it follows at once, and the operator's read-out.
import {Segments} from "../drawing/segments";
import {useEffect} from "preact/hooks";
import {useSignal} from "@preact/signals";
import {fixed, jointDecimals, lengthFigure, lengthAndUnit} from "../../../drawing/numbers.js";
import type {JointInfo, TipPose} from "../server/documents";
import {cell, report, units} from "../server/workbench";
import {picked, sheet} from "../shell/page_state";
import {ArmPicture} from "./arm_picture";
import {pictureReach} from "./arm_stage";
import {isFollowing, isLive} from "./live";
import {poseRequest, setJoint, showHole, whyNot} from "./pose_link";
import {ToolInset} from "./tool_inset";

/** Begins under a hole in the middle of the sheet rather than with the arm stretched out through a wall. */
function beginUnderHole(): void {
  const model = sheet.value;
  if (!model || poseRequest.hole.peek() >= 0 || poseRequest.reading.peek() || isLive.peek()) return;
  const middle = model.nearest(
    0.35 * model.radius,
    model.isOneLeg ? 0.5 * (model.extent.bottom + model.extent.top) : 0.35 * model.radius,
    model.radius,
  );
  if (middle < 0) return;
  picked.value = middle;
  void showHole(middle);
}

export default function ArmView() {
  useEffect(beginUnderHole, [sheet.value]);
  return (
    <div class="arm-view">
      <section class="panel">
        <div class="panel-body flush">
          <ArmPicture />
          {cell.value?.has_sheet ? <ToolInset /> : null}
        </div>
      </section>
      <aside class="side">
        <ReadOut />
        <Sliders />
      </aside>
    </div>
  );
}

function isFound(branch: {status: string}): boolean {
  return branch.status === "found";
}

const PLACES = ["x", "y", "z"],
  TURNS = ["γ", "β", "α"];

function ReadOut() {
  const answer = poseRequest.answer.value;
  const {length, angle} = units.value;
  return (
    <section class="panel readout" aria-live="off">
      <header>
        <h2>Tip, deflected</h2>
        <div class="end">{isLive.value ? <LiveSwitch /> : <span class="muted">in the base's frame</span>}</div>
      </header>
      <div class="panel-body">
        <div class="readout-grid">
          {PLACES.map((name, k) => (
            <Figure name={name} figure={lengthFigure(answer?.flexible.position[k], length)} unit={length} />
          ))}
          {TURNS.map((name, k) => (
            <Figure name={name} figure={fixed(answer?.flexible.fixed_angles[k], jointDecimals(angle))} unit={angle} />
          ))}
        </div>
        <dl class="figures">
          <dt>sag</dt>
          <dd>{answer ? lengthAndUnit(sagOf(answer.change), length) : "–"}</dd>
          <dt>from rigid</dt>
          <dd>{answer ? answer.change.position.map((value) => lengthFigure(value, length)).join("  ") : "–"}</dd>
          <dt>clearance</dt>
          <dd class={(answer?.clearance?.distance ?? 1) < 0 ? "bad" : ""}>
            {answer?.clearance ? lengthAndUnit(answer.clearance.distance, length) : "–"}
          </dd>
          <dt></dt>
          <dd class="muted clip">{answer?.clearance ? answer.clearance.pair.join(" to ") : "no scene"}</dd>
        </dl>
        {answer?.segments?.warning ? <p class="bad">{answer.segments.warning}</p> : null}
      </div>
    </section>
  );
}

/** Whether this browser goes where the running arm goes. */
function LiveSwitch() {
  return (
    <label class="live-switch" title="The arm goes where the encoders of the running arm say it is">
      <i class={`live-sign ${isFollowing.value ? "on" : ""}`} /> live
      <input
        type="checkbox"
        checked={isFollowing.value}
        aria-label="Follow the running arm"
        onChange={(event) => (isFollowing.value = event.currentTarget.checked)}
      />
    </label>
  );
}

function sagOf(change: TipPose): number {
  return Math.hypot(...change.position);
}

function Figure({name, figure, unit}: {name: string; figure: string; unit: string}) {
  return (
    <div class="figure">
      <span>{name}</span>
      <b class={figure.length > 7 ? "long" : ""}>{figure}</b>
      <small>{unit}</small>
    </div>
  );
}

function Sliders() {
  const joints = cell.value?.joints ?? [];
  const answer = poseRequest.inverse.value;
  return (
    <section class="panel grow">
      <header>
        <h2>Joints and load</h2>
        <div class="end">
          <button class="link" onClick={() => (poseRequest.joints.value = joints.map((joint) => joint.home))}>
            home
          </button>
        </div>
      </header>
      <div class="panel-body sliders">
        {cell.value?.has_sheet ? <HoleBox /> : null}
        {joints.map((joint, index) => (
          <JointSlider key={joint.name} joint={joint} index={index} />
        ))}
        <LoadSlider />
        {answer && answer.branches.filter(isFound).length > 1 ? (
          <div class="branches">
            <span class="muted">postures under this hole</span>
            <Segments
              label="Posture"
              value={answer.branch}
              onChoose={(index) => showHole(poseRequest.hole.value, index)}
              choices={answer.branches.flatMap((branch, index) =>
                isFound(branch) ? [{value: index, words: String(index + 1)}] : [],
              )}
            />
          </div>
        ) : null}
        <p class="muted latency">answered in {fixed(poseRequest.latency.value, 1)} ms</p>
      </div>
    </section>
  );
}

/** A hole by its name: the arm goes under it. */
function HoleBox() {
  const text = useSignal("");
  const go = (event: Event) => {
    event.preventDefault();
    const found = /R?\s*(\d+)\s*[C ,]\s*(\d+)/i.exec(text.value);
    const hole = found ? (sheet.value?.find(Number(found[1]), Number(found[2])) ?? -1) : -1;
    if (hole < 0)
      return report("No such hole", {message: `found "${text.value}", expected a hole of this sheet, as R10C20`});
    picked.value = hole;
    void showHole(hole);
  };
  return (
    <form class="hole-box" onSubmit={go}>
      <label class="field">
        under hole
        <input
          value={text.value}
          placeholder="R10C20"
          spellcheck={false}
          onInput={(event) => (text.value = event.currentTarget.value)}
        />
      </label>
      <button class="button" type="submit">
        Go
      </button>
      <span class="bad clip">{poseRequest.inverse.value ? whyNot(poseRequest.inverse.value) : ""}</span>
    </form>
  );
}

/** How far a joint without limits is moved by its slider either way: a turn, or the picture's reach along a slide. */
function unlimitedOf(unit: string): number {
  return unit === "deg" ? 360 : unit === "rad" ? 2 * Math.PI : pictureReach.value;
}

function JointSlider({joint, index}: {joint: JointInfo; index: number}) {
  const value = poseRequest.joints.value[index] ?? joint.home;
  const turn = unlimitedOf(joint.unit),
    lower = joint.lower ?? -turn,
    upper = joint.upper ?? turn;
  return (
    <label class="slider">
      <span>{joint.name}</span>
      <input
        type="range"
        min={lower}
        max={upper}
        step={(upper - lower) / 4000}
        value={value}
        onInput={(event) => {
          isFollowing.value = false; // a hand on the slider has it
          setJoint(index, Number(event.currentTarget.value));
        }}
      />
      <NumberBox
        value={value}
        digits={jointDecimals(joint.unit)}
        onChange={(next) => setJoint(index, Math.min(upper, Math.max(lower, next)))}
        label={joint.name}
      />
      <small>{joint.unit}</small>
    </label>
  );
}

function LoadSlider() {
  const most = Math.max(40, ...(cell.value?.loads ?? []));
  const {load} = poseRequest;
  return (
    <label class="slider">
      <span>load</span>
      <input
        type="range"
        min={0}
        max={most}
        step={most / 400}
        value={load.value}
        onInput={(event) => (load.value = Number(event.currentTarget.value))}
      />
      <NumberBox value={load.value} digits={1} onChange={(next) => (load.value = Math.max(0, next))} label="load" />
      <small>{units.value.force}</small>
    </label>
  );
}

/** A figure that can be typed: taken on Enter or when it is left. */
function NumberBox({
  value,
  digits,
  onChange,
  label,
}: {
  value: number;
  digits: number;
  onChange: (next: number) => void;
  label: string;
}) {
  return (
    <input
      class="number-box"
      aria-label={`${label}, as a number`}
      value={value.toFixed(digits)}
      onChange={(event) => {
        const next = Number(event.currentTarget.value.replace("−", "-").replace(",", "."));
        if (Number.isFinite(next)) onChange(next);
        else event.currentTarget.value = value.toFixed(digits);
      }}
    />
  );
}
