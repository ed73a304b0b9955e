// Dialog for new readings, which are added to the open readings or replace them.
import {plural} from "../../../drawing/numbers.js";
import {state} from "../server/workbench";
import {Dialog} from "./dialog";
import {joinOffered, offered, openOffered} from "./load";

export function JoinDialog() {
  const here = state.value?.measurements;
  return (
    <Dialog name="join" title="Other readings">
      <p class="lead">
        <b>{offered.value?.name}</b> has readings that are not among the {plural(here?.readings ?? 0, "reading")} of{" "}
        {here?.name}.
      </p>
      <div class="row">
        <button class="button first" onClick={() => void openOffered()}>
          Open them instead
        </button>
        <button class="button" onClick={() => void joinOffered()}>
          Add them to these
        </button>
      </div>
    </Dialog>
  );
}
