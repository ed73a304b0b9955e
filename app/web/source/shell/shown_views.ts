// Views that the opened cell can use, in the order of the work.
import {computed} from "@preact/signals";
import {records} from "../outage/desk";
import {cell} from "../server/workbench";
import {VIEWS} from "./page_state";

export const shownViews = computed(() => {
  const has = {
    arm: true,
    sheet: cell.value?.has_sheet ?? true,
    records: (records.value.document?.records.length ?? 0) > 0,
  };
  return VIEWS.filter(({needs}) => has[needs]);
});
