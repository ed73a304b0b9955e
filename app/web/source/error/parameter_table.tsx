// Results of the last fit: each parameter with its confidence interval and how well the readings identify it.
import {exact, MISSING, plainUnit, short} from "../../../drawing/numbers.js";
import {valueAndSigma} from "../../../drawing/sigma_text.js";
import {Table} from "../drawing/table";
import type {IdentifyDocument} from "../server/documents";

interface ParameterTableProps {
  parameters: IdentifyDocument["parameters"];
  /** True if there is room for the 95 % intervals. */
  hasIntervals?: boolean;
}

export function ParameterTable({parameters, hasIntervals = false}: ParameterTableProps) {
  const intervalOf = (interval: [number, number] | null) => interval?.map(short).join(" to ") ?? MISSING;
  const rows = parameters.map(({name, title = name, hint, value, sigma, interval, start, unit, identifiable}) => [
    <span class="wrap" title={hint}>
      {title}
    </span>,
    ...valueAndSigma(value, sigma),
    ...(hasIntervals ? [intervalOf(interval)] : []),
    <span title={exact(start)}>{valueAndSigma(start, sigma)[0]}</span>,
    plainUnit(unit === "1" ? "" : unit),
    <span class={identifiable === "yes" ? "" : "bad"}>{identifiable}</span>,
  ]);
  const heads = ["parameter", "value", "± sigma", ...(hasIntervals ? ["95 %"] : []), "start", "unit", "identifiable"];
  return <Table heads={heads} rows={rows} text={[0, heads.length - 2, heads.length - 1]} />;
}
