// Totals of all packages: planned = done + excluded + unresolved, with a bar for each.
import type {Counts, Totals} from "./desk";

const NUMBERS = ["planned", "done", "excluded", "unresolved"] as const;

/** Bar of done, excluded and unresolved items, each with its own pattern. */
function Bar({counts}: {counts: Counts}) {
  const share = (count: number) => `${(100 * count) / Math.max(1, counts.planned)}%`;
  return (
    <span class="desk-share" role="img" aria-label={`${counts.percent.toFixed(1)} % done`}>
      <span class="done" style={{width: share(counts.done)}} />
      <span class="held" style={{width: share(counts.queued + counts.held)}} />
      <span class="out" style={{width: share(counts.excluded)}} />
    </span>
  );
}

function Row({name, counts}: {name: string; counts: Counts}) {
  return (
    <tr>
      <th scope="row">{name}</th>
      {NUMBERS.map((key) => (
        <td class="number" key={key}>
          {counts[key]}
        </td>
      ))}
      <td>
        <Bar counts={counts} />
      </td>
      <td class="number">{counts.percent.toFixed(1)} %</td>
    </tr>
  );
}

export function TotalsTable({totals}: {totals: Totals}) {
  return (
    <>
      <table class="desk-table">
        <thead>
          <tr>
            <th>package</th>
            {NUMBERS.map((key) => (
              <th class="number" key={key}>
                {key}
              </th>
            ))}
            <th />
            <th class="number">of what is to do</th>
          </tr>
        </thead>
        <tbody>
          {totals.packages.map((of) => (
            <Row
              key={`${of.package} ${of.steam_generator} ${of.leg}`}
              name={`${of.package} ${of.steam_generator}/${of.leg}`}
              counts={of}
            />
          ))}
          <Row name="all" counts={totals.total} />
        </tbody>
      </table>
      {totals.shifts.map(({date, shift, done}) => (
        <p class="muted" key={date + shift}>
          {date} {shift}: {done} done
        </p>
      ))}
    </>
  );
}
