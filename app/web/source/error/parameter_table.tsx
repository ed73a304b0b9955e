// What the last fit found, each number with its interval and a word on whether it can be told.
import {exact} from "../../../drawing/numbers.js";
import {valueAndSigma} from "../../../drawing/sigma_text.js";
import type {IdentifyDocument} from "../server/documents";

export function ParameterTable({document}: {document: IdentifyDocument}) {
  return (
    <table>
      <thead>
        <tr>
          <th>number</th>
          <th class="number">value</th>
          <th class="number">± sigma</th>
          <th class="number">start</th>
          <th>unit</th>
          <th>told</th>
        </tr>
      </thead>
      <tbody>
        {document.parameters.map((parameter) => (
          <tr key={parameter.name}>
            <td class="wrap">{parameter.name}</td>
            {valueAndSigma(parameter.value, parameter.sigma).map((figure) => (
              <td class="number">{figure}</td>
            ))}
            <td class="number">{exact(parameter.start)}</td>
            <td>{parameter.unit}</td>
            <td class={parameter.identifiable === "yes" ? "" : "bad"}>{parameter.identifiable}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
