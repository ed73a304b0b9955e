// Tables of the base found from touches, and of the residuals of touches and of distances between touches.
import {isNumber, lengthFigure, short} from "../../../drawing/numbers.js";
import {MARKED, TOUCH_SIGMAS, valueAndSigma} from "../../../drawing/sigma_text.js";
import type {CalibrateDocument, Units} from "../server/documents";
import {suspicionOf} from "./suspicion";

export function isFallingShort({verdict}: CalibrateDocument): boolean {
  return verdict === "falls-short";
}

export function BasePose({document, length, angle}: {document: CalibrateDocument} & Pick<Units, "length" | "angle">) {
  const {base, sigma} = document;
  if (!base || !sigma) return null;
  return (
    <table>
      <thead>
        <tr>
          <th />
          <th class="number">x</th>
          <th class="number">y</th>
          <th class="number">z</th>
        </tr>
      </thead>
      <tbody>
        <FigureRows name={`position, ${length}`} values={base.position} sigmas={sigma.position} />
        <FigureRows name={`turn, ${angle}`} values={base.rpy} sigmas={sigma.rotation} />
        {isFallingShort(document) ? (
          <tr>
            <td colSpan={4} class="bad">
              {MARKED}the touches do not fit: these sigmas hold only where they do
            </td>
          </tr>
        ) : null}
      </tbody>
    </table>
  );
}

interface TouchFiguresProps {
  document: CalibrateDocument;
  unit: string;
  /** True on paper, where the sigmas are printed because there are no tooltips. */
  hasSigmas?: boolean;
}

/** Shows the residual of each touch and of each distance between touches; nothing if no base was fitted. */
export function TouchFigures({document, unit, hasSigmas = false}: TouchFiguresProps) {
  const {residuals = [], distances = []} = document;
  if (residuals.length === 0) return null;
  return (
    <>
      <h3>Residual at each touch, {unit}</h3>
      <table>
        <tbody>
          {residuals.map(({id, hole, residual, sigma}) => (
            <>
              <tr>
                <td>{id}</td>
                <td>{hole}</td>
                {residual.map((value, k) => (
                  <Left value={value} sigma={sigma[k]} hasSigma={hasSigmas} />
                ))}
              </tr>
              <Suspected document={document} touch={id} />
            </>
          ))}
        </tbody>
      </table>
      <h3>Distances by arm and sheet, {unit}</h3>
      <table>
        <tbody>
          {distances.map(({from, to, by_arm, on_sheet, difference, sigma}) => (
            <tr>
              <td>
                {from} to {to}
              </td>
              <td class="number">{lengthFigure(by_arm, unit)}</td>
              <td class="number">{lengthFigure(on_sheet, unit)}</td>
              <Left value={difference} sigma={sigma} hasSigma={hasSigmas} />
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

/** Shows the suspicion about a touch below the residual of the touch. */
function Suspected({document, touch}: {document: CalibrateDocument; touch: string}) {
  const suspicion = suspicionOf(document, touch);
  if (!suspicion) return null;
  return (
    <tr>
      <td />
      <td colSpan={4} class={suspicion.isOutlier ? "bad" : ""}>
        {suspicion.isOutlier ? MARKED : ""}
        {suspicion.words}
      </td>
    </tr>
  );
}

/** Shows a residual, marked if it exceeds TOUCH_SIGMAS standard deviations. */
function Left({value, sigma, hasSigma}: {value: number; sigma: number; hasSigma: boolean}) {
  const times = Math.abs(value) / sigma,
    isBad = times > TOUCH_SIGMAS,
    [shown, about] = valueAndSigma(value, sigma);
  return (
    <td class={`number ${isBad ? "bad" : ""}`} title={isNumber(times) ? `${short(times)} sigmas` : ""}>
      {isBad ? MARKED : ""}
      {shown}
      {hasSigma ? <small> ± {about}</small> : null}
    </td>
  );
}

/** Shows values with their sigmas below, rounded to the digits that the sigmas justify. */
function FigureRows({name, values, sigmas}: {name: string; values: readonly number[]; sigmas: readonly number[]}) {
  const pairs = values.map((value, k) => valueAndSigma(value, sigmas[k]));
  return (
    <>
      {[name, "± sigma"].map((title, k) => (
        <tr>
          <th>{title}</th>
          {pairs.map((pair) => (
            <td class="number">{pair[k]}</td>
          ))}
        </tr>
      ))}
    </>
  );
}
