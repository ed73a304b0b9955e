// Table of tried effects, most probable first. On paper, which has no tooltips, their contents are printed.
import type {ComponentType} from "preact";
import type {Barred} from "../../../drawing/ranking.js";
import {IS_THERE, type rankingRows} from "../../../drawing/ranking.js";
import type {RankedEffect} from "../server/documents";

export type RankedRow = ReturnType<typeof rankingRows<RankedEffect>>[number];

interface RankingTableProps {
  rows: readonly RankedRow[];
  /** Action for an effect; on paper there is none. */
  action?: ComponentType<{row: RankedRow}>;
}

export function RankingTable({rows, action: Action}: RankingTableProps) {
  if (rows.length === 0) return null;
  return (
    <table>
      <thead>
        <tr>
          <th>effect</th>
          <th title={`${IS_THERE}; several may be present`}>{Action ? "is there" : IS_THERE}</th>
          <th class="number">chi² falls by</th>
          <th class="size" title="size of this effect alone, from one linear step; the cards show the fitted sizes">
            size, alone
          </th>
          {Action ? <th /> : <th>observable</th>}
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <Ranked key={row.title} row={row} action={Action} />
        ))}
      </tbody>
    </table>
  );
}

/** A probability or fraction as text, in front of a bar of proportional length. */
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

/** Fraction below which an effect is hardly visible in the readings; on paper the fraction is printed. */
const LITTLE = 0.5;

function Ranked({row, action: Action}: {row: RankedRow} & Pick<RankingTableProps, "action">) {
  const {entry, title, words, kept, probability, fall, size, shows} = row;
  const isNamed = Action === undefined || entry.title !== undefined;
  const said = Action ? [entry.title ? "" : entry.at] : [words, entry.kept_fraction < LITTLE ? kept : ""];
  return (
    <tr title={[words, kept].filter((text) => text !== "").join("; ")}>
      <td class="effect-name">
        {isNamed ? title : entry.effect}
        {said.map((text) => (text ? <small>{text}</small> : null))}
      </td>
      <td>
        <Chance {...probability} />
      </td>
      <td class="number">{Action ? fall.text : <Chance {...fall} />}</td>
      <td class="size" title={`${size.name} ${size.text}`}>
        {size.name} {size.text}
      </td>
      <td class={Action ? "number" : ""}>{Action ? <Action row={row} /> : <Chance {...shows} />}</td>
    </tr>
  );
}
