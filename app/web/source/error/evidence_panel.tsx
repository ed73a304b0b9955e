// Evidence of the model's failure: errors at the readings' positions, errors per joint, or one table row for each
// reading.
import {signal} from "@preact/signals";
import {choicesOf} from "../drawing/segments";
import {Tabs} from "../drawing/tabs";
import {JointPanels} from "./joint_panels";
import {ReadingTable} from "./reading_table";
import {PlaneChoice, ResidualArrows} from "./residual_arrows";

type Tab = "places" | "joints" | "readings";
const TABS = choicesOf<Tab>([
  ["places", "Places"],
  ["joints", "Joints"],
  ["readings", "Readings"],
]);
const tab = signal<Tab>("places");

export function EvidencePanel() {
  return (
    <section class="panel evidence">
      <header>
        <Tabs label="Errors" tabs={TABS} value={tab.value} onChoose={(next) => (tab.value = next)} />
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
