// Means to decide between explanations: readings that would distinguish them, and others.
import {PAIR_HEADS, pairCells} from "../../../drawing/conditions.js";
import {Table} from "../drawing/table";
import {PosteriorPicture} from "./posterior_picture";
import {RunSheetPanel} from "./run_sheet_panel";
import type {DiagnoseDocument} from "../server/documents";

/**
 * Proposals of a diagnosis for distinguishing explanations, the current run sheet, and the change of the probabilities
 * with the readings taken since.
 */
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
          : "Only one explanation fits: no further readings are needed."}
      </p>
    );
  }
  return (
    <>
      {readings.length > 0 && !document.run_sheet ? (
        <p class="muted">An earlier program proposed readings here: diagnose again for their run sheet.</p>
      ) : null}
      {others.length > 0 ? (
        <ul>
          {others.map((text) => (
            <li>{text}</li>
          ))}
        </ul>
      ) : null}
      {(splitting?.pairs ?? []).length > 0 ? (
        <Table heads={PAIR_HEADS} rows={splitting!.pairs!.map(pairCells)} text={[0, 1]} />
      ) : null}
    </>
  );
}
