// The calibrated base: its pose with sigmas, the residual of each touch, distances, correlations.
import {Panel} from "../drawing/panel";
import {errorText, fixed, isNumber, short} from "../../../drawing/numbers.js";
import {MARKED} from "../../../drawing/sigma_text.js";
import type {CalibrateDocument} from "../server/documents";
import {pageAdvice, pageWords} from "../server/page_words";
import {units} from "../server/workbench";
import {OtherModel} from "../shell/other_model";
import {ProblemWords} from "../shell/states";
import {BasePose, isFallingShort, TouchFigures} from "./base_figures";
import {Covariance} from "./covariance";
import {outcome} from "./touches";

export function BasePanel() {
  const {problem, document} = outcome.value;
  if (problem)
    return (
      <Panel kind="grow">
        <ProblemWords problem={problem} />
      </Panel>
    );
  if (document) return <FoundBase document={document} />;
  return (
    <Panel title="Base" kind="grow">
      <p class="muted">Base pose, residuals and uncertainty appear here after three touches.</p>
    </Panel>
  );
}

function FoundBase({document}: {document: CalibrateDocument}) {
  const {warnings = [], to_do = [], nominal, covariance} = document;
  const end = (
    <>
      <OtherModel name="calibrate" />
      <FitFigure document={document} />
    </>
  );
  return (
    <Panel title="Base" end={end} kind="grow">
      {document.reason ? (
        <p class="warning">
          {document.status === "done" ? "" : "The base has not moved: "}
          {pageWords(document.reason)}
        </p>
      ) : null}
      {warnings.map((warning) => (
        <p class="warning">{pageWords(warning)}</p>
      ))}
      {to_do.length > 0 ? <ToDo steps={to_do} /> : null}
      <BasePose document={document} {...units.value} />
      {nominal ? <FromNominal nominal={nominal} /> : null}
      <TouchFigures document={document} unit={units.value.length} />
      {covariance ? (
        <>
          <h3>Correlations of the base's numbers</h3>
          <Covariance matrix={covariance} />
        </>
      ) : null}
    </Panel>
  );
}

/** Shows the quality of the fit, or a note that the touches do not determine the base. */
function FitFigure({document}: {document: CalibrateDocument}) {
  const isBad = document.status !== "done" || isFallingShort(document);
  return (
    <span class={isBad ? "bad" : "muted"}>
      {isBad ? MARKED : ""}
      {document.status === "done" ? "" : "not calibrated "}
      {isNumber(document.rms) ? `rms ${errorText(document.rms, units.value.length)}` : ""}
    </span>
  );
}

function ToDo({steps}: {steps: string[]}) {
  return (
    <>
      <h3>What to do</h3>
      <ul class="to-do">
        {steps
          .map(pageAdvice)
          .filter(Boolean)
          .map((step) => (
            <li>
              <InCode text={step} />
            </li>
          ))}
      </ul>
    </>
  );
}

function FromNominal({nominal}: {nominal: NonNullable<CalibrateDocument["nominal"]>}) {
  const {length, angle} = units.value;
  return (
    <p class="muted">
      {errorText(nominal.distance, length)}
      {nominal.pitches
        ? ` (${nominal.pitches.map((pitches) => fixed(pitches, 2)).join(" and ")} pitches along x and y)`
        : ""}{" "}
      and {short(nominal.angle)} {angle} from nominal
    </p>
  );
}

/** Shows text in which parts between backticks are set as code. */
function InCode({text}: {text: string}) {
  return <>{text.split("`").map((part, k) => (k % 2 === 1 ? <code>{part}</code> : part))}</>;
}
