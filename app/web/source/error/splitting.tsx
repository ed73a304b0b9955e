// "A or B": the readings that would split what these cannot, and what else would tell.
import {poseRequest} from "../arm/pose_link";
import {PAIR_HEADS, pairCells, senseArrow, separations} from "../../../drawing/conditions.js";
import {fixed, isNumber, short} from "../../../drawing/numbers.js";
import {PosteriorPicture} from "./posterior_picture";
import {RunSheetPanel} from "./run_sheet_panel";
import type {DiagnoseDocument, NextReading} from "../server/documents";
import {cell} from "../server/workbench";
import {view} from "../shell/page_state";

/** The proposals of a diagnosis, the run sheet that is under way, and what the readings taken since have said. */
export function Splitting({document}: {document: DiagnoseDocument | null}) {
  return (
    <div class="splitting">
      <PosteriorPicture />
      {document?.splitting?.advice ? <p>{document.splitting.advice}</p> : null}
      <RunSheetPanel />
      {document ? <Proposals document={document} /> : null}
    </div>
  );
}

function Proposals({document}: {document: DiagnoseDocument}) {
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
    <>
      {readings.length > 0 && !document.run_sheet ? <ReadingTable readings={readings} /> : null}
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
              {PAIR_HEADS.map((head, k) => (
                <th class={k < 2 ? "" : "number"}>{head}</th>
              ))}
            </tr>
          </thead>
          <tbody>
            {splitting!.pairs!.map((pair) => (
              <tr>
                {pairCells(pair).map((cell, k) => (
                  <td class={k < 2 ? "" : "number"}>{cell}</td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </>
  );
}

function ReadingTable({readings}: {readings: NextReading[]}) {
  const joints = Object.keys(readings[0].posture ?? {});
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
        {separations(readings).map(({reading, share, text}) => (
          <tr title={(reading.splits ?? []).join(" from ")}>
            {joints.map((joint) => (
              <td class="number">
                {fixed(reading.posture[joint], 1)}
                {senseArrow(reading.senses?.[joint])}
              </td>
            ))}
            <td class="number">{short(reading.load ?? 0)}</td>
            <td>
              <span class="chance">
                <span class="chance-bar">
                  <i style={{width: `${100 * share}%`}} />
                </span>
                {text}
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

function show(reading: NextReading): void {
  const joints = cell.value?.joints ?? [];
  poseRequest.joints.value = joints.map((joint, i) => reading.posture[joint.name] ?? poseRequest.joints.value[i]);
  if (isNumber(reading.load)) poseRequest.load.value = reading.load;
  view.value = "arm";
}
