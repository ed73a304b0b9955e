// Notice of a result that was computed for another model than the present one.
import {MarkIcon} from "../drawing/marks";
import {otherModelOf} from "../server/workbench";

export function OtherModel({name}: {name: string}) {
  const label = otherModelOf(name);
  if (label === "") return null;
  return (
    <span class="other-model" title="Made for another model than the present one: run it again to update it">
      <MarkIcon mark={{shape: "triangle", colour: "case0"}} size={12} /> out of date, made for: {label}
    </span>
  );
}
