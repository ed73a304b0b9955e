// The calibrate view: the holes to touch, with the best ringed; entered or simulated joint values; the base with its
// sigmas; the residual of each touch; and the effect on the error over the sheet.
import {WithSheet} from "../sheet/with_sheet";
import {BasePanel} from "./base_panel";
import {TouchPanel} from "./touch_panel";
import {TouchSheet} from "./touch_sheet";

export function CalibrateView() {
  return (
    <WithSheet without={<p>A base is found by touching holes. Open a cell with a sheet.</p>}>
      {(model) => (
        <div class="calibrate-view">
          <TouchSheet model={model} />
          <aside class="side">
            <TouchPanel model={model} />
            <BasePanel />
          </aside>
        </div>
      )}
    </WithSheet>
  );
}
