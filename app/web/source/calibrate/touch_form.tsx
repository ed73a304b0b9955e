// Form for the joint values at a hole: of a new touch, or of one whose values are corrected.
import {submitting, withPoint} from "../drawing/fields";
import {joinReadings} from "../error/run_sheet";
import type {TouchList} from "../server/documents";
import {remove} from "../server/requests";
import {attempt, cell, order, units} from "../server/workbench";
import {touchTable} from "./touch_readings";
import {touchReadings} from "./touches";

const DECIMALS = 5; // decimals of a joint value in its field, finer than an encoder reads

export function removeTouch(index: number): Promise<boolean> {
  return attempt("The touch stays", () => remove(`/api/touch/${index}`));
}

interface TouchFormProps {
  name: string;
  hole: number;
  /** Touch that the entered one replaces, with its place in the list. */
  old?: TouchList["touches"][number] & {index: number};
  onDone?: () => void;
}

export function TouchForm({name, hole, old, onDone}: TouchFormProps) {
  const joints = cell.value?.joints ?? [];
  const touch = (body: object) => order(`Touch of ${name}`, "/api/touch", {hole, ...body});
  const others = touchReadings.value;
  const enter = async (values: number[]): Promise<void> => {
    if (others.length > 0)
      return void (await joinReadings(touchTable({point: name, values}, others, joints, units.value.force)));
    const isTaken = await touch({joints: values, ...(old ? {load: old.load} : {})});
    if (isTaken && old && (await removeTouch(old.index))) onDone?.();
  };
  return (
    <form
      class="touch-row"
      onSubmit={submitting((form) => {
        const typed = new FormData(form);
        return enter(joints.map((joint) => Number(withPoint(String(typed.get(joint.name))))));
      })}
    >
      <span>{name}</span>
      <span class="joint-inputs">
        {joints.map((joint, k) => (
          <input
            name={joint.name}
            inputMode="decimal"
            placeholder={joint.name}
            aria-label={`${joint.name} at ${name}`}
            defaultValue={old ? String(Number(old.joints[k].toFixed(DECIMALS))) : ""}
            required
          />
        ))}
      </span>
      <span class="touch-buttons">
        <button class="button" type="submit">
          Enter
        </button>
        {old ? (
          <button class="button" type="button" onClick={onDone}>
            Cancel
          </button>
        ) : others.length > 0 ? null : (
          <button class="button" type="button" onClick={() => touch({simulate: true})}>
            Simulate
          </button>
        )}
      </span>
    </form>
  );
}
