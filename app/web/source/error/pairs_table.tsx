// What further readings would do to each pair of explanations.
import {PAIR_HEADS, pairCells} from "../../../drawing/conditions.js";
import type {DiagnoseDocument} from "../server/documents";

type Pairs = NonNullable<NonNullable<DiagnoseDocument["splitting"]>["pairs"]>;

export function PairsTable({pairs}: {pairs: Pairs}) {
  if (pairs.length === 0) return null;
  return (
    <table>
      <thead>
        <tr>
          {PAIR_HEADS.map((head, k) => (
            <th class={k < 2 ? "" : "number"}>{head}</th>
          ))}
        </tr>
      </thead>
      <tbody>
        {pairs.map((pair) => (
          <tr>
            {pairCells(pair).map((cell, k) => (
              <td class={k < 2 ? "" : "number"}>{cell}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
