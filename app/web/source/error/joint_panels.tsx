// The errors of the current readings joint by joint; a click on a panel shows it in the large plot.
import {useMemo} from "preact/hooks";
import {multiplesOf} from "../../../drawing/joint_multiples.js";
import {cell, sceneDocument} from "../server/workbench";
import {chosenPart, chosenVariable, parts, shownView, variables} from "./focus";
import {JointGrid} from "./joint_grid";
import {compare} from "./loop";
import {readingErrors} from "./residuals";

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
  if (!errors || multiples.length === 0)
    return <p class="muted pad">Errors by joint appear here after a comparison.</p>;
  const shown = shownView.value;
  return (
    <div class="panel-body flush with-legend">
      <JointGrid
        errors={errors}
        multiples={multiples}
        isShown={({variable, part}) => shown?.variable.key === variable.key && shown.part.key === part.key}
        onChoose={({variable, part}) => {
          chosenVariable.value = variable.key;
          chosenPart.value = part.key;
        }}
      />
    </div>
  );
}
