// "A or B": the readings that would split what these cannot, and what else would tell.
import {poseRequest} from "../arm/pose_link";
import {fixed, isNumber, probability, short} from "../drawing/numbers";
import type {DiagnoseDocument, NextReading} from "../server/documents";
import {cell} from "../server/workbench";
import {view} from "../shell/page_state";

export function Splitting({document}: {document: DiagnoseDocument}) {
  const readings = document.next_readings ?? [],
    splitting = document.splitting;
  const others = [...(splitting?.other_means ?? []).map((entry) => entry.what), ...(splitting?.columns_to_add ?? [])];
  if (!splitting && readings.length === 0) {
    return (
      <p class="muted">
        {document.explanations.length > 1
          ? "No further reading was found that would split these explanations."
          : "There is nothing to split: these readings leave one explanation at most."}
      </p>
    );
  }
  return (
    <div class="splitting">
      {splitting?.advice ? <p>{splitting.advice}</p> : null}
      {readings.length > 0 ? <ReadingTable readings={readings} /> : null}
      {others.length > 0 ? (
        <ul>
          {others.map((text) => (
            <li>{text}</li>
          ))}
        </ul>
      ) : null}
      {(splitting?.pairs ?? []).length > 0 && (
        <table>
          <thead>
            <tr>
              <th>if it is</th>
              <th>rather than</th>
              <th class="number">apart now</th>
              <th class="number">then</th>
              <th class="number">chance to tell</th>
            </tr>
          </thead>
          <tbody>
            {splitting!.pairs!.map((pair) => (
              <tr>
                <td>{pair.if_true}</td>
                <td>{pair.against}</td>
                <td class="number">{short(pair.criterion_gap_now)}</td>
                <td class="number">{short(pair.criterion_gap_expected)}</td>
                <td class="number">{probability(pair.probability_told)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </div>
  );
}

function ReadingTable({readings}: {readings: NextReading[]}) {
  const joints = Object.keys(readings[0].posture ?? {});
  const most = Math.max(1e-12, ...readings.map((reading) => reading.separation_sigmas).filter(isNumber));
  return (
    <table>
      <thead>
        <tr>
          {joints.map((joint) => (
            <th class="number">{joint}</th>
          ))}
          <th class="number">load</th>
          <th>tells apart, in sigmas</th>
          <th />
        </tr>
      </thead>
      <tbody>
        {readings.map((reading) => (
          <tr title={(reading.splits ?? []).join(" from ")}>
            {joints.map((joint) => (
              <td class="number">
                {fixed(reading.posture[joint], 1)}
                {arrow(reading.senses?.[joint])}
              </td>
            ))}
            <td class="number">{short(reading.load ?? 0)}</td>
            <td>
              <span class="chance">
                <span class="chance-bar">
                  <i style={{width: `${(100 * (reading.separation_sigmas ?? 0)) / most}%`}} />
                </span>
                {short(reading.separation_sigmas)}
              </span>
            </td>
            <td class="number">
              <button class="button small" onClick={() => show(reading)}>
                Arm
              </button>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** The sense in which a joint must arrive. */
function arrow(sense: number | undefined): string {
  return !sense ? "" : sense > 0 ? " ↑" : " ↓";
}

function show(reading: NextReading): void {
  const joints = cell.value?.joints ?? [];
  poseRequest.joints.value = joints.map((joint, i) => reading.posture[joint.name] ?? poseRequest.joints.value[i]);
  if (isNumber(reading.load)) poseRequest.load.value = reading.load;
  view.value = "arm";
}
