// Posture in which a view with the arm opens: the park posture, otherwise under a hole in the middle of the sheet,
// because a straight arm would pass through a wall.
import {useEffect} from "preact/hooks";
import {cell} from "../server/workbench";
import {picked, sheet} from "../shell/page_state";
import {isLive} from "./live";
import {poseRequest, showHole} from "./pose_link";

function openPosture(isPicked: boolean): void {
  const model = sheet.value;
  if (!model || cell.peek()?.park) return;
  if (poseRequest.hole.peek() >= 0 || poseRequest.reading.peek() || isLive.peek()) return;
  const middle = model.nearest(
    0.35 * model.radius,
    model.isOneLeg ? 0.5 * (model.extent.bottom + model.extent.top) : 0.35 * model.radius,
    model.radius,
  );
  if (middle < 0) return;
  if (isPicked) picked.value = middle;
  void showHole(middle);
}

/** Shows the arm at a hole when a view opens. With `isPicked`, that hole also becomes the picked one. */
export function useOpeningPosture(isPicked: boolean): void {
  useEffect(() => openPosture(isPicked), [sheet.value]);
}
