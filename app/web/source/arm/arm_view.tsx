// The arm view: the deflected arm under the sheet, sliders that move the arm at once, and the operator's read-out.
import {submitting, TextInput, withPoint} from "../drawing/fields";
import {Figures, Panel} from "../drawing/panel";
import {Segments} from "../drawing/segments";
import {useSignal} from "@preact/signals";
import {fixed, jointDecimals, lengthFigure, lengthAndUnit, MISSING} from "../../../drawing/numbers.js";
import type {JointInfo} from "../server/documents";
import {cell, report, units} from "../server/workbench";
import {picked, sheet} from "../shell/page_state";
import {ArmPicture} from "./arm_picture";
import {pictureReach} from "./arm_stage";
import {isFollowing, isLive} from "./live";
import {useOpeningPosture} from "./opening_posture";
import {bringArm, poseRequest, setJoint, showHole, whyNot} from "./pose_link";
import {ToolInset} from "./tool_inset";

export default function ArmView() {
  useOpeningPosture(true);
  return (
    <div class="arm-view">
      <Panel body="flush">
        <ArmPicture />
        {cell.value?.has_sheet ? <ToolInset /> : null}
      </Panel>
      <aside class="side">
        <ReadOut />
        <Sliders />
      </aside>
    </div>
  );
}

const PLACES = ["x", "y", "z"],
  TURNS = ["γ", "β", "α"];

function ReadOut() {
  const answer = poseRequest.answer.value,
    clearance = answer?.clearance;
  const {length, angle} = units.value;
  const change = answer?.change.position;
  return (
    <Panel
      title="Tip, deflected"
      end={isLive.value ? <LiveSwitch /> : <span class="muted">in the base's frame</span>}
      kind="readout"
    >
      <div class="readout-grid">
        {PLACES.map((name, k) => (
          <Figure name={name} figure={lengthFigure(answer?.flexible.position[k], length)} unit={length} />
        ))}
        {TURNS.map((name, k) => (
          <Figure name={name} figure={fixed(answer?.flexible.fixed_angles[k], jointDecimals(angle))} unit={angle} />
        ))}
      </div>
      <Figures
        rows={[
          ["sag", change ? lengthAndUnit(Math.hypot(...change), length) : MISSING],
          [
            "from rigid",
            change ? `${change.map((value) => lengthFigure(value, length)).join("  ")} ${length}` : MISSING,
          ],
          [
            "clearance",
            <span class={(clearance?.distance ?? 1) < 0 ? "bad" : ""}>
              {clearance ? lengthAndUnit(clearance.distance, length) : MISSING}
            </span>,
          ],
          ["", <div class="muted clip">{clearance?.pair.join(" to ") ?? "no scene"}</div>],
        ]}
      />
      {answer?.segments?.warning ? <p class="bad">{answer.segments.warning}</p> : null}
    </Panel>
  );
}

/** Switch that makes this browser follow the running arm. */
function LiveSwitch() {
  return (
    <label class="live-switch" title="The arm follows the encoders of the running arm">
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
  const found = (answer?.branches ?? []).flatMap(({status}, index) =>
    status === "found" ? [{value: index, words: String(index + 1)}] : [],
  );
  const park = cell.value?.park;
  const rest = (
    <button class="link" onClick={() => bringArm(park ?? joints.map((joint) => joint.home), poseRequest.load.value)}>
      {park ? "park" : "home"}
    </button>
  );
  return (
    <Panel title="Joints and load" end={rest} kind="grow" body="sliders">
      {cell.value?.has_sheet ? <HoleBox /> : null}
      {joints.map((joint, index) => (
        <JointSlider key={joint.name} joint={joint} index={index} />
      ))}
      <LoadSlider />
      {found.length > 1 ? (
        <div class="branches">
          <span class="muted">postures under this hole</span>
          <Segments
            label="Posture"
            value={answer!.branch}
            onChoose={(index) => showHole(poseRequest.hole.value, index)}
            choices={found}
          />
        </div>
      ) : null}
      <p class="muted latency">answered in {fixed(poseRequest.latency.value, 1)} ms</p>
    </Panel>
  );
}

/** Text field for a hole's name; the arm moves under the entered hole. */
function HoleBox() {
  const text = useSignal("");
  const go = () => {
    const found = /R?\s*(\d+)\s*[C ,]\s*(\d+)/i.exec(text.value);
    const hole = found ? (sheet.value?.find(Number(found[1]), Number(found[2])) ?? -1) : -1;
    if (hole < 0)
      return report("No such hole", {message: `found "${text.value}", expected a hole of this sheet, as R10C20`});
    picked.value = hole;
    void showHole(hole);
  };
  return (
    <form class="hole-box" onSubmit={submitting(go)}>
      <label class="field">
        under hole
        <TextInput of={text} placeholder="R10C20" />
      </label>
      <button class="button" type="submit">
        Go
      </button>
      <span class="bad clip">{poseRequest.inverse.value ? whyNot(poseRequest.inverse.value) : ""}</span>
    </form>
  );
}

/**
 * Returns the limit of a slider, in both directions, for a joint without limits: one turn for an angle, otherwise the
 * picture's reach.
 */
function unlimitedOf(unit: string): number {
  return unit === "deg" ? 360 : unit === "rad" ? 2 * Math.PI : pictureReach.value;
}

function JointSlider({joint, index}: {joint: JointInfo; index: number}) {
  const turn = unlimitedOf(joint.unit),
    least = joint.lower ?? -turn,
    most = joint.upper ?? turn;
  return (
    <Slider
      name={joint.name}
      unit={joint.unit}
      range={[least, most, (most - least) / 4000]}
      value={poseRequest.joints.value[index] ?? joint.home}
      digits={jointDecimals(joint.unit)}
      onSlide={(next) => {
        isFollowing.value = false; // the arm no longer follows the encoders once a slider is moved
        setJoint(index, next);
      }}
      onType={(next) => setJoint(index, Math.min(most, Math.max(least, next)))}
    />
  );
}

function LoadSlider() {
  const most = Math.max(40, ...(cell.value?.loads ?? []));
  const take = (next: number) => (poseRequest.load.value = Math.max(0, next));
  return (
    <Slider
      name="load"
      unit={units.value.force}
      range={[0, most, most / 400]}
      value={poseRequest.load.value}
      digits={1}
      onSlide={take}
      onType={take}
    />
  );
}

interface SliderProps {
  name: string;
  unit: string;
  /** Minimum, maximum and step of the slider. */
  range: [number, number, number];
  value: number;
  digits: number;
  onSlide: (next: number) => void;
  onType: (next: number) => void;
}

/** Returns a name that may continue on another line after each of its underscores. */
function breakable(name: string) {
  return name.split("_").flatMap((part, k) => (k === 0 ? [part] : ["_", <wbr />, part]));
}

/**
 * Slider with its value, which can also be typed. A typed value is accepted on Enter or when the field loses the focus.
 */
function Slider({name, unit, range: [min, max, step], value, digits, onSlide, onType}: SliderProps) {
  return (
    <label class="slider">
      <span>{breakable(name)}</span>
      <input
        {...{type: "range", min, max, step, value}}
        onInput={(event) => onSlide(Number(event.currentTarget.value))}
      />
      <input
        class="number-box"
        aria-label={`${name}, as a number`}
        value={value.toFixed(digits)}
        onChange={(event) => {
          const next = Number(withPoint(event.currentTarget.value));
          if (Number.isFinite(next)) onType(next);
          else event.currentTarget.value = value.toFixed(digits);
        }}
      />
      <small>{unit}</small>
    </label>
  );
}
