// What can be done with readings that were picked out of a picture: they are set aside, and the ladder follows.
import {plural} from "../drawing/numbers";
import {runningJobs} from "../server/workbench";
import {pickedOut} from "./linked";
import {setAside} from "./loop";

export function SelectionBar() {
  const ids = [...pickedOut.value];
  return (
    <p class="selection-bar" role="status">
      <b>{plural(ids.length, "reading")} picked out</b>
      <button
        class="button small first"
        disabled={runningJobs.value.length > 0}
        onClick={() => void setAside(ids, true)}
      >
        Set aside
      </button>
      <button class="button small" onClick={() => (pickedOut.value = new Set())}>
        Leave them
      </button>
    </p>
  );
}
