// What the last fit found, each parameter with its interval and whether the readings identify it.
import {exact, MISSING, plainUnit, short} from "../../../drawing/numbers.js";
import {valueAndSigma} from "../../../drawing/sigma_text.js";
import type {IdentifyDocument} from "../server/documents";

interface ParameterTableProps {
  parameters: IdentifyDocument["parameters"];
  /** Whether there is room for 95 % intervals. */
  hasIntervals?: boolean;
}

export function ParameterTable({parameters, hasIntervals = false}: ParameterTableProps) {
  return (
    <table>
      <thead>
        <tr>
          <th>parameter</th>
          <th class="number">value</th>
          <th class="number">± sigma</th>
          {hasIntervals ? <th class="number">95 %</th> : null}
          <th class="number">start</th>
          <th>unit</th>
          <th>identifiable</th>
        </tr>
      </thead>
      <tbody>
        {parameters.map((parameter) => (
          <tr key={parameter.name}>
            <td class="wrap">{parameter.name}</td>
            {valueAndSigma(parameter.value, parameter.sigma).map((figure) => (
              <td class="number">{figure}</td>
            ))}
            {hasIntervals ? <td class="number">{parameter.interval?.map(short).join(" to ") ?? MISSING}</td> : null}
            <td class="number" title={exact(parameter.start)}>
              {short(parameter.start)}
            </td>
            <td>{plainUnit(parameter.unit === "1" ? "" : parameter.unit)}</td>
            <td class={parameter.identifiable === "yes" ? "" : "bad"}>{parameter.identifiable}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
