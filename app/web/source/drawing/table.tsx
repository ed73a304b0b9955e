// A table of values.
import type {ComponentChildren} from "preact";
import {MISSING} from "../../../drawing/numbers.js";

/**
 * Content of a table. A cell is text, an element, or null for a missing value; `text` lists the indices of the columns
 * without numbers.
 */
export interface TableProps {
  heads: readonly ComponentChildren[];
  rows: readonly (readonly ComponentChildren[])[];
  text?: readonly number[];
}

export function Table({heads, rows, text = [0]}: TableProps) {
  const kind = (column: number) => (text.includes(column) ? "" : "number");
  return (
    <div class="table">
      <table>
        <thead>
          <tr>
            {heads.map((head, k) => (
              <th scope="col" class={kind(k)}>
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr>
              {row.map((cell, k) => (
                <td class={kind(k)}>{cell === null ? MISSING : cell}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
