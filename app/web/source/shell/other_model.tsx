// Notice of a result that was computed for another model than the present one.
import {MarkIcon} from "../drawing/marks";
import {otherModelOf} from "../server/workbench";

export function OtherModel({name}: {name: string}) {
  const label = otherModelOf(name);
  if (label === "") return null;
  return (
    <span class="other-model" title="It stays as it was made; ask for it again to have it of the model as it is now">
      <MarkIcon mark={{shape: "triangle", colour: "case0"}} size={12} /> of another model: {label}
    </span>
  );
}
