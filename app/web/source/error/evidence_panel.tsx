// Where the model fails: the errors at their places, as those of each joint, or every reading as a row.
import {signal} from "@preact/signals";
import {rove} from "../drawing/segments";
import {JointPanels} from "./joint_panels";
import {ReadingTable} from "./reading_table";
import {PlaneChoice, ResidualArrows} from "./residual_arrows";

type Tab = "places" | "joints" | "readings";
const TABS: [Tab, string][] = [
  ["places", "Places"],
  ["joints", "Joints"],
  ["readings", "Readings"],
];
const tab = signal<Tab>("places");

export function EvidencePanel() {
  return (
    <section class="panel evidence">
      <header>
        <div class="tabs" role="tablist" aria-label="Errors" onKeyDown={rove}>
          {TABS.map(([key, words]) => (
            <button
              role="tab"
              aria-selected={tab.value === key}
              tabIndex={tab.value === key ? 0 : -1}
              onClick={() => (tab.value = key)}
            >
              {words}
            </button>
          ))}
        </div>
        {tab.value === "places" ? (
          <div class="end">
            <PlaneChoice />
          </div>
        ) : null}
      </header>
      {tab.value === "places" ? <ResidualArrows /> : tab.value === "joints" ? <JointPanels /> : <ReadingTable />}
    </section>
  );
}
