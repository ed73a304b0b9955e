// The verdict with its sentences and key values, and the next step.
import {budgetText, errorUnit, idsSetAside, setAsideText} from "../../../drawing/error_budget.js";
import {errorText, isNumber, short, whole} from "../../../drawing/numbers.js";
import {MARKED} from "../../../drawing/sigma_text.js";
import {MarkIcon} from "../drawing/marks";
import type {JudgedDocument} from "../server/documents";
import type {ReadingsInfo} from "../server/state_documents";
import {runningJob, state} from "../server/workbench";
import {answer} from "./answer";
import {selectedReadings} from "./linked";
import {currentComparison, currentDiagnosis, ladder, WORK_ON_READINGS} from "./loop";
import {NextStep} from "./next_step";

export function VerdictBand() {
  const now = answer.value;
  const job = runningJob(...WORK_ON_READINGS);
  const document = currentDiagnosis.value ?? currentComparison.value;
  const judged = document ?? ladder.value.document;
  return (
    <section class="panel verdict" aria-live="polite">
      {now ? <MarkIcon mark={now.mark} size={34} /> : <span class="verdict-space" />}
      <div class="verdict-words">
        <h1>{now?.words ?? (job ? "Working" : "Not compared yet")}</h1>
        {now ? (
          <ul>
            {now.items.map((item) => (
              <li key={item}>{item}</li>
            ))}
          </ul>
        ) : (
          <p>{job ? `${job.label || job.kind} …` : "Compare the readings with the model as it is now."}</p>
        )}
        {judged ? <Budget document={judged} /> : null}
      </div>
      <dl class="verdict-figures">
        <dt>readings</dt>
        <dd>{usedText(state.value?.measurements, judged)}</dd>
        <dt>chi² per degree of freedom</dt>
        <dd>
          <Misfit chi2={document?.chi2_per_dof ?? ladder.value.document?.models.at(-1)?.chi2_per_dof} />
        </dd>
        <dt>noise floor</dt>
        <dd>
          {errorText(
            document?.rms.noise_floor ?? ladder.value.document?.models.at(-1)?.rms.noise_floor,
            judged ? errorUnit(judged) : "",
          )}
        </dd>
      </dl>
      <NextStep isBusy={job !== null} />
    </section>
  );
}

/** Error with its budget; a click selects the readings excluded from the error. */
function Budget({document}: {document: JudgedDocument}) {
  const ids = idsSetAside(document);
  return (
    <p class="muted budget">
      {budgetText(document)}{" "}
      {ids.length > 0 ? (
        <button class="button small" title={ids.join(", ")} onClick={() => (selectedReadings.value = new Set(ids))}>
          {setAsideText(document, readingsInUse())}: select
        </button>
      ) : null}
    </p>
  );
}

/** Returns the number of readings that are not set aside by hand. */
function readingsInUse(): number {
  const measurements = state.value?.measurements;
  return measurements ? measurements.readings - measurements.set_aside : 0;
}

/**
 * Returns "52 of 120" if some readings are set aside, by hand or as outliers, or held out; otherwise only the total.
 */
function usedText(measurements: ReadingsInfo | null | undefined, judged: JudgedDocument | null): string {
  if (!measurements) return "";
  const {readings, set_aside, held_out} = measurements;
  const used = readings - set_aside - held_out - (judged ? idsSetAside(judged).length : 0);
  return used === readings ? whole(readings) : `${whole(used)} of ${whole(readings)}`;
}

/** Squared ratio of errors to the stated noise above which errors are marked, by a sign and by colour. */
const TWICE = 4;

function Misfit({chi2}: {chi2: number | null | undefined}) {
  if (!isNumber(chi2)) return <>–</>;
  const isBad = chi2 >= TWICE;
  return (
    <span class={isBad ? "bad" : ""} title={`errors are ${short(Math.sqrt(chi2))} times the stated noise`}>
      {isBad ? MARKED : ""}
      {short(chi2)}
    </span>
  );
}
