// Where the base stands: its place with sigmas, what is left at each touch, distances, correlations.
import {fixed, isNumber, lengthFigure, short} from "../../../drawing/numbers.js";
import {MARKED, TOUCH_SIGMAS, valueAndSigma} from "../../../drawing/sigma_text.js";
import type {CalibrateDocument} from "../server/documents";
import {units} from "../server/workbench";
import {OtherModel} from "../shell/other_model";
import {ProblemWords} from "../shell/states";
import {Covariance} from "./covariance";
import {outcome} from "./touches";

export function BasePanel() {
  const {problem, document} = outcome.value;
  if (problem)
    return (
      <section class="panel grow">
        <div class="panel-body">
          <ProblemWords problem={problem} />
        </div>
      </section>
    );
  return document ? <FoundBase document={document} /> : <NoBase />;
}

function NoBase() {
  return (
    <section class="panel grow">
      <header>
        <h2>Base</h2>
      </header>
      <div class="panel-body">
        <p class="muted">
          Where the base stands, what is left at each touch and how sure that is, once three holes are touched.
        </p>
      </div>
    </section>
  );
}

function FoundBase({document}: {document: CalibrateDocument}) {
  const {length} = units.value;
  const isShort = isFallingShort(document);
  return (
    <section class="panel grow">
      <header>
        <h2>Base</h2>
        <div class="end">
          <OtherModel name="calibrate" />
          <span class={isShort ? "bad" : "muted"}>
            {isShort ? MARKED : ""}rms {short(document.rms)} {length}
          </span>
        </div>
      </header>
      <div class="panel-body">
        {document.warnings.map((warning) => (
          <p class="warning">{warning}</p>
        ))}
        {document.to_do.length > 0 ? <ToDo steps={document.to_do} /> : null}
        <BasePose document={document} />
        <FromNominal nominal={document.nominal} />
        <h3>Residual at each touch, {length}</h3>
        <TouchResiduals residuals={document.residuals} />
        <h3>Distances by arm and sheet, {length}</h3>
        <Distances distances={document.distances} />
        <h3>Correlations of the base's numbers</h3>
        <Covariance matrix={document.covariance} />
        {document.reason ? <p class="muted">{document.reason}</p> : null}
      </div>
    </section>
  );
}

function isFallingShort({verdict}: CalibrateDocument): boolean {
  return verdict === "falls-short";
}

function ToDo({steps}: {steps: string[]}) {
  return (
    <>
      <h3>What to do</h3>
      <ul class="to-do">
        {steps.map((step) => (
          <li>
            <InCode text={step} />
          </li>
        ))}
      </ul>
    </>
  );
}

function BasePose({document}: {document: CalibrateDocument}) {
  const {length, angle} = units.value;
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
        <FigureRows name={`position, ${length}`} values={document.base.position} sigmas={document.sigma.position} />
        <FigureRows name={`turn, ${angle}`} values={document.base.rpy} sigmas={document.sigma.rotation} />
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

function FromNominal({nominal}: {nominal: CalibrateDocument["nominal"]}) {
  const {length, angle} = units.value;
  return (
    <p class="muted">
      {short(nominal.distance)} {length}
      {nominal.pitches
        ? ` (${nominal.pitches.map((pitches) => fixed(pitches, 2)).join(" and ")} pitches along x and y)`
        : ""}{" "}
      and {short(nominal.angle)} {angle} from nominal
    </p>
  );
}

function TouchResiduals({residuals}: {residuals: CalibrateDocument["residuals"]}) {
  return (
    <table>
      <tbody>
        {residuals.map((touch) => (
          <tr>
            <td>{touch.id}</td>
            <td>{touch.hole}</td>
            {touch.residual.map((value, k) => (
              <Left value={value} sigma={touch.sigma[k]} />
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Distances({distances}: {distances: CalibrateDocument["distances"]}) {
  const {length} = units.value;
  return (
    <table>
      <tbody>
        {distances.map((row) => (
          <tr>
            <td>
              {row.from} to {row.to}
            </td>
            <td class="number">{lengthFigure(row.by_arm, length)}</td>
            <td class="number">{lengthFigure(row.on_sheet, length)}</td>
            <td class="number">{lengthFigure(row.difference, length, 4)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Left({value, sigma}: {value: number; sigma: number}) {
  const times = Math.abs(value) / sigma;
  const isBad = times > TOUCH_SIGMAS;
  return (
    <td class={`number ${isBad ? "bad" : ""}`} title={isNumber(times) ? `${short(times)} sigmas` : ""}>
      {isBad ? MARKED : ""}
      {valueAndSigma(value, sigma)[0]}
    </td>
  );
}

/** Values and their sigmas below them, to the digits that those carry. */
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

/** What stands between backticks as code. */
function InCode({text}: {text: string}) {
  return <>{text.split("`").map((part, k) => (k % 2 === 1 ? <code>{part}</code> : part))}</>;
}
