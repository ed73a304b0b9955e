// Where the base stands: its place with sigmas, what is left at each touch, distances, correlations.
import {fixed, isNumber, lengthFigure, short} from "../../../drawing/numbers.js";
import {MARKED, TOUCH_SIGMAS, valueAndSigma} from "../../../drawing/sigma_text.js";
import type {CalibrateDocument, TouchResidual} from "../server/documents";
import {units} from "../server/workbench";
import {OtherModel} from "../shell/other_model";
import {ProblemWords} from "../shell/states";
import {Covariance} from "./covariance";
import {suspicionOf} from "./suspicion";
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
  const {warnings = [], to_do = [], nominal, covariance} = document;
  return (
    <section class="panel grow">
      <header>
        <h2>Base</h2>
        <div class="end">
          <OtherModel name="calibrate" />
          <FitFigure document={document} />
        </div>
      </header>
      <div class="panel-body">
        {document.reason ? (
          <p class="warning">
            {document.status === "done" ? "" : "The base stays where it was: "}
            {document.reason}
          </p>
        ) : null}
        {warnings.map((warning) => (
          <p class="warning">{warning}</p>
        ))}
        {to_do.length > 0 ? <ToDo steps={to_do} /> : null}
        <BasePose document={document} />
        {nominal ? <FromNominal nominal={nominal} /> : null}
        <TouchFigures document={document} />
        {covariance ? (
          <>
            <h3>Correlations of the base's numbers</h3>
            <Covariance matrix={covariance} />
          </>
        ) : null}
      </div>
    </section>
  );
}

/** How the touches fit, or that they place no base. */
function FitFigure({document}: {document: CalibrateDocument}) {
  const isBad = document.status !== "done" || isFallingShort(document);
  return (
    <span class={isBad ? "bad" : "muted"}>
      {isBad ? MARKED : ""}
      {document.status === "done" ? "" : "not calibrated "}
      {isNumber(document.rms) ? `rms ${short(document.rms)} ${units.value.length}` : ""}
    </span>
  );
}

/** What is left at each touch and between them; nothing where no base was fitted. */
function TouchFigures({document}: {document: CalibrateDocument}) {
  const {length} = units.value;
  const {residuals = [], distances = []} = document;
  if (residuals.length === 0) return null;
  return (
    <>
      <h3>Residual at each touch, {length}</h3>
      <TouchResiduals residuals={residuals} document={document} />
      <h3>Distances by arm and sheet, {length}</h3>
      <Distances distances={distances} />
    </>
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

function FromNominal({nominal}: {nominal: NonNullable<CalibrateDocument["nominal"]>}) {
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

function TouchResiduals({residuals, document}: {residuals: TouchResidual[]; document: CalibrateDocument}) {
  return (
    <table>
      <tbody>
        {residuals.map((touch) => (
          <>
            <tr>
              <td>{touch.id}</td>
              <td>{touch.hole}</td>
              {touch.residual.map((value, k) => (
                <Left value={value} sigma={touch.sigma[k]} />
              ))}
            </tr>
            <Suspected document={document} touch={touch.id} />
          </>
        ))}
      </tbody>
    </table>
  );
}

/** What is suspected of a touch, below its residual. */
function Suspected({document, touch}: {document: CalibrateDocument; touch: string}) {
  const suspicion = suspicionOf(document, touch);
  if (!suspicion) return null;
  return (
    <tr>
      <td />
      <td colSpan={4} class={suspicion.isOdd ? "bad" : ""}>
        {suspicion.isOdd ? MARKED : ""}
        {suspicion.words}
      </td>
    </tr>
  );
}

function Distances({distances}: {distances: NonNullable<CalibrateDocument["distances"]>}) {
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
