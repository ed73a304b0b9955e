// Tubes with the same reason as one list entry; long lists are collapsed, and only counted on paper.
import {plural, whole} from "../../../../drawing/numbers.js";
import {Reasons} from "../parts";

/** Number of tubes that are always shown. */
const SHOWN = 12;

export interface TubeGroup {
  reason: string;
  tubes: readonly string[];
}

export function GroupedTubes({groups}: {groups: readonly TubeGroup[]}) {
  return (
    <Reasons>
      {groups.map(({reason, tubes}) => (
        <>
          <b>{plural(tubes.length, "tube")}</b>, {reason}: {tubes.slice(0, SHOWN).join(", ")}
          {tubes.length > SHOWN ? (
            <details>
              <summary>and {whole(tubes.length - SHOWN)} more</summary>
              {tubes.slice(SHOWN).join(", ")}
            </details>
          ) : null}
        </>
      ))}
    </Reasons>
  );
}
