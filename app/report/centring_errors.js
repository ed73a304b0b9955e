// The centring errors of a plan that was scored against a true arm.
import {isNumber} from "../drawing/numbers.js";
import {list} from "./values.js";

/// The scored errors of one mode as {tube, dx, dy, error}.
export function errorsOf(report, mode) {
  return list(report.tubes)
      .map((tube) => ({tube, ...object(tube[mode])}))
      .filter((entry) => isNumber(entry.dx) && isNumber(entry.dy) && isNumber(entry.tube.x) && isNumber(entry.tube.y))
      .map((entry) => ({...entry, error: isNumber(entry.error) ? entry.error : Math.hypot(entry.dx, entry.dy)}));
}

export function largestError(errors) {
  return errors.reduce((most, entry) => Math.max(most, Math.hypot(entry.dx, entry.dy)), 0);
}
