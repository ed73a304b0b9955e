// Evidence of the model's failure: errors at the readings' positions, errors per joint, a histogram, or one table row
// for each reading.
import type {ComponentType} from "preact";
import {choicesOf} from "../drawing/segments";
import {Tabs} from "../drawing/tabs";
import {ErrorHistogram, HistogramChoice} from "./error_histogram";
import {JointPanels} from "./joint_panels";
import {ReadingTable} from "./reading_table";
import {PlaneChoice, ResidualArrows} from "./residual_arrows";
import {evidenceTab, type EvidenceTab} from "./tabs";

/** The tabs: their words, their content, and the choice at the end of the head. */
const TABS: Record<EvidenceTab, {words: string; body: ComponentType; end?: ComponentType}> = {
  places: {words: "Places", body: ResidualArrows, end: PlaneChoice},
  joints: {words: "Joints", body: JointPanels},
  histogram: {words: "Histogram", body: ErrorHistogram, end: HistogramChoice},
  readings: {words: "Readings", body: ReadingTable},
};
const CHOICES = choicesOf(Object.entries(TABS).map(([name, {words}]) => [name as EvidenceTab, words] as const));

export function EvidencePanel() {
  const {body: Body, end: End} = TABS[evidenceTab.value];
  return (
    <section class="panel evidence">
      <header>
        <Tabs label="Errors" tabs={CHOICES} value={evidenceTab.value} onChoose={(next) => (evidenceTab.value = next)} />
        {End ? (
          <div class="end">
            <End />
          </div>
        ) : null}
      </header>
      <Body />
    </section>
  );
}
