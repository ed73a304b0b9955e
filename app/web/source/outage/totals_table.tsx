// Totals of items: planned = done + excluded + unresolved, with a bar for each row.
import type {ComponentChildren} from "preact";
import {fixed, whole} from "../../../drawing/numbers.js";
import type {Counts, Totals} from "./desk";

const NUMBERS = ["planned", "done", "excluded", "unresolved"] as const;

export type NamedCounts = Counts & {name: string};

/** Bar of done, excluded and unresolved items, each with its own pattern. */
function Bar({counts}: {counts: Counts}) {
  const share = (count: number) => `${(100 * count) / Math.max(1, counts.planned)}%`;
  return (
    <span class="desk-share" role="img" aria-label={`${fixed(counts.percent, 1)} % done`}>
      <span class="done" style={{width: share(counts.done)}} />
      <span class="held" style={{width: share(counts.queued + counts.held)}} />
      <span class="out" style={{width: share(counts.excluded)}} />
    </span>
  );
}

interface CountsTableProps {
  /** Head of the column of names. */
  what: string;
  rows: readonly NamedCounts[];
  /** Further columns before the counts: their heads, and their values in a row. */
  more?: readonly {head: string; of: (row: NamedCounts) => ComponentChildren}[];
}

export function CountsTable({what, rows, more = []}: CountsTableProps) {
  return (
    <table class="desk-table">
      <thead>
        <tr>
          <th>{what}</th>
          {[...more.map(({head}) => head), ...NUMBERS].map((head) => (
            <th class="number" key={head}>
              {head}
            </th>
          ))}
          <th />
          <th class="number">of what is to do</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <tr key={row.name}>
            <th scope="row">{row.name}</th>
            {more.map(({head, of}) => (
              <td class="number" key={head}>
                {of(row)}
              </td>
            ))}
            {NUMBERS.map((key) => (
              <td class="number" key={key}>
                {whole(row[key])}
              </td>
            ))}
            <td>
              <Bar counts={row} />
            </td>
            <td class="number">{fixed(row.percent, 1)} %</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

export function TotalsTable({totals}: {totals: Totals}) {
  const rows = totals.packages.map((of) => ({...of, name: `${of.package} ${of.steam_generator}/${of.leg}`}));
  return (
    <>
      <CountsTable what="package" rows={[...rows, {...totals.total, name: "all"}]} />
      {totals.shifts.map(({date, shift, done, reopened}) => (
        <p class="muted" key={date + shift}>
          {date} {shift}: {done} done
          {reopened > 0 ? `, ${reopened} no longer done` : ""}
        </p>
      ))}
    </>
  );
}
