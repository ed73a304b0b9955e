// The error view: the verdict and the next step at the top; the ladder, the effects, and the errors below.
import {Panel} from "../drawing/panel";
import {state} from "../server/workbench";
import {dialog} from "../shell/page_state";
import {Splitter, splitStyle} from "../shell/splits";
import {Nothing} from "../shell/states";
import {EffectsPanel} from "./effects_panel";
import {EvidencePanel} from "./evidence_panel";
import {LadderBars} from "./ladder_bars";
import {ReadingChecks} from "./reading_checks";
import {ResidualPlot} from "./residual_plot";
import {SelectionBar} from "./selection_bar";
import {VerdictBand} from "./verdict_band";

export function ErrorView() {
  const readings = state.value?.measurements;
  if (!readings) {
    return (
      <Nothing title="No readings yet">
        <p>
          Drop a CSV of measurements anywhere on the page, open one of the folder, or make readings to practise on. They
          are compared with the model at once.
        </p>
        <div class="row">
          <button class="button first large" onClick={() => (dialog.value = "open")}>
            Open readings
          </button>
        </div>
      </Nothing>
    );
  }
  return (
    <div class="error-view" style={splitStyle("error-columns", "error-rows")}>
      <VerdictBand />
      <ReadingChecks readings={readings} />
      <Panel title="Error of each model">
        <LadderBars />
      </Panel>
      <EffectsPanel />
      <EvidencePanel />
      <ResidualPlot />
      <SelectionBar />
      <Splitter name="error-columns" />
      <Splitter name="error-rows" />
    </div>
  );
}
