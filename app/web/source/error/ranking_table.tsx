// Effects that were tried, most probable first. On paper nothing can be pointed at: what the page says there stands in words.
import type {ComponentType} from "preact";
import type {Barred} from "../../../drawing/ranking.js";
import {IS_THERE, type rankingRows} from "../../../drawing/ranking.js";
import type {RankedEffect} from "../server/documents";

export type RankedRow = ReturnType<typeof rankingRows<RankedEffect>>[number];

interface RankingTableProps {
  rows: readonly RankedRow[];
  /** What can be done with an effect; on paper nothing. */
  action?: ComponentType<{row: RankedRow}>;
}

export function RankingTable({rows, action: Action}: RankingTableProps) {
  if (rows.length === 0) return null;
  return (
    <table>
      <thead>
        <tr>
          <th>effect</th>
          <th title={`${IS_THERE}; several may be`}>{Action ? "is there" : IS_THERE}</th>
          <th class="number">chi² falls by</th>
          <th
            class="size"
            title="as this effect alone would have it, by one linear step; the cards have the fitted sizes"
          >
            size, alone
          </th>
          {Action ? <th /> : <th>observable</th>}
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (Action ? <Ranked key={row.title} row={row} action={Action} /> : <OnPaper row={row} />))}
      </tbody>
    </table>
  );
}

/** A figure behind a bar of its share. */
export function Chance({share, text}: Barred) {
  return (
    <span class="chance">
      <span class="chance-bar">
        <i style={{width: `${100 * share}%`}} />
      </span>
      {text}
    </span>
  );
}

function Ranked({row, action: Action}: {row: RankedRow; action: ComponentType<{row: RankedRow}>}) {
  const {entry: effect, words, kept, probability, fall, size} = row;
  return (
    <tr title={[words, kept].filter((text) => text !== "").join("; ")}>
      <td class="effect-name">
        {effect.effect}
        <small>{effect.at}</small>
      </td>
      <td>
        <Chance {...probability} />
      </td>
      <td class="number">{fall.text}</td>
      <td class="size" title={`${size.name} ${size.text}`}>
        {size.name} {size.text}
      </td>
      <td class="number">
        <Action row={row} />
      </td>
    </tr>
  );
}

/** Less than this share of an effect shows in the readings: how much is said in words. */
const LITTLE = 0.5;

function OnPaper({row: {entry, title, words, kept, probability, fall, size, shows}}: {row: RankedRow}) {
  return (
    <tr>
      <td class="effect-name">
        {title}
        {words ? <small>{words}</small> : null}
        {kept && entry.kept_fraction < LITTLE ? <small>{kept}</small> : null}
      </td>
      <td>
        <Chance {...probability} />
      </td>
      <td class="number">
        <Chance {...fall} />
      </td>
      <td class="size">
        {size.name} {size.text}
      </td>
      <td>
        <Chance {...shows} />
      </td>
    </tr>
  );
}
