// "A or B": the readings that would split what these cannot, and what else would tell.
import {fixed, probability, short} from "../drawing/numbers";
import type {DiagnoseDocument, NextReading} from "../server/documents";
import {cell} from "../server/workbench";

export function Splitting({document}: {document: DiagnoseDocument}) {
  const readings = document.next_readings ?? [], splitting = document.splitting;
  const others = [...(splitting?.other_means ?? []).map((entry) => entry.what), ...(splitting?.columns_to_add ?? [])];
  if (readings.length === 0 && others.length === 0) {
    return <p class="muted">{document.explanations.length > 1 ?
      "No further reading was found that would split these explanations." :
      "There is nothing to split: these readings leave one explanation at most."}</p>;
  }
  return (
    <div class="splitting">
      {readings.length > 0 && (
        <>
          <p>Readings that would split the explanations best:</p>
          <table>
            <thead><tr><th>reading</th>{(cell.value?.joints ?? []).map((joint) => <th class="number">{joint.name}</th>)}
              <th class="number">load</th><th>splits</th></tr></thead>
            <tbody>{readings.map((reading) => <SplitRow key={reading.id} reading={reading} />)}</tbody>
          </table>
        </>)}
      {(splitting?.pairs ?? []).length > 0 && (
        <table>
          <thead><tr><th>if it is</th><th>rather than</th><th class="number">apart now</th><th class="number">then</th><th class="number">told</th></tr></thead>
          <tbody>{splitting!.pairs!.map((pair) => (
            <tr><td>{pair.if_true}</td><td>{pair.against}</td><td class="number">{short(pair.criterion_gap_now)}</td>
              <td class="number">{short(pair.criterion_gap_expected)}</td><td class="number">{probability(pair.probability_told)}</td></tr>))}
          </tbody>
        </table>)}
      {others.length > 0 && <><p><b>What else would tell</b></p><ul>{others.map((text) => <li>{text}</li>)}</ul></>}
    </div>
  );
}

function SplitRow({reading}: {reading: NextReading}) {
  const splits = Array.isArray(reading.splits) ? reading.splits.join(", ") : typeof reading.splits === "string" ? reading.splits : "";
  return (
    <tr>
      <td>{reading.point ?? reading.id}</td>
      {reading.joints.map((value) => <td class="number">{fixed(value, 2)}</td>)}
      <td class="number">{short(reading.load ?? 0)}</td>
      <td>{splits}</td>
    </tr>
  );
}
