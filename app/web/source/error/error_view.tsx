// The error view: the verdict and the next thing to do on top; the ladder, the effects, and the errors themselves below.
import {computed, signal} from "@preact/signals";
import {choicesOf} from "../drawing/segments";
import {Tabs} from "../drawing/tabs";
import {briefTitle} from "../../../drawing/explanations.js";
import {verdictMark} from "../../../drawing/kinds.js";
import {MARKED} from "../../../drawing/sigma_text.js";
import {comparisonItems, sentencesOf, verdictItems} from "../../../drawing/verdict_items.js";
import {MarkIcon, type Mark} from "../drawing/marks";
import {isNumber, plural, short} from "../../../drawing/numbers.js";
import type {DiagnoseDocument} from "../server/documents";
import {currentModel, runningJob, state, units} from "../server/workbench";
import {dialog} from "../shell/page_state";
import {OtherModel} from "../shell/other_model";
import {Nothing, ProblemWords, Waiting} from "../shell/states";
import {EffectRanking} from "./effect_ranking";
import {EvidencePanel} from "./evidence_panel";
import {suggestedFormula} from "./focus";
import {FormulaBox, formulaText} from "./formula_box";
import {ladderOf} from "./ladder";
import {LadderBars} from "./ladder_bars";
import {
  addEffects,
  areChangeable,
  currentComparison,
  currentDiagnosis,
  diagnose,
  identify,
  ladder,
  startCompare,
  startDiagnose,
  WORK_ON_READINGS,
} from "./loop";
import {ParameterTable} from "./parameter_table";
import {assume, mistake, ReadingChecks} from "./reading_checks";
import {runSheet} from "./run_sheet";
import {ResidualPlot} from "./residual_plot";
import {SelectionBar} from "./selection_bar";
import {Splitting} from "./splitting";

type Tab = "effects" | "split" | "formula" | "numbers";
const tab = signal<Tab>("effects");

interface Answer {
  words: string;
  mark: Mark;
  items: string[];
}

function answerOf({verdict, verdict_words}: {verdict: string; verdict_words?: string}, items: string[]): Answer {
  // What the command line would say is a button here.
  const plain = items.map((item) => item.replace(/ \(--assume [^)]*\)/g, ""));
  return {words: verdict_words ?? verdict, mark: verdictMark(verdict), items: plain};
}

/** What the top of the view says: of the newest document about the model as it is now. */
const answer = computed<Answer | null>(() => {
  const diagnosed = currentDiagnosis.value,
    compared = currentComparison.value;
  if (diagnosed) return answerOf(diagnosed, verdictItems(diagnosed));
  const fallen = fallOfError();
  if (fallen && compared && compared.verdict !== "adequate")
    return answerOf(compared, [...fallen.items, ...comparisonItems(compared).slice(1)]);
  return fallen ?? (compared ? answerOf(compared, comparisonItems(compared)) : null);
});

/** How the last change of the model has changed the error, where the ladder knows. */
function fallOfError(): Answer | null {
  const document = ladder.value.document;
  if (!document || document.model !== state.value?.model || document.models.length < 2 || !state.value.can_undo)
    return null;
  const {models, floor, unit} = ladderOf(document);
  const before = models.at(-2)!,
    now = models.at(-1)!;
  if (now.heldout === null || before.heldout === null) return null;
  const isAtFloor = floor !== null && now.heldout < 1.25 * floor;
  const [from, to] = [short(before.heldout), short(now.heldout)];
  const change =
    from === to ? `stays at ${to}` : `${now.heldout < before.heldout ? "fell" : "rose"} from ${from} to ${to}`;
  return {
    words: isAtFloor ? "At the noise floor" : "Above the noise floor",
    mark: verdictMark(isAtFloor ? "adequate" : "falls-short"),
    items: sentencesOf(
      `With ${(currentModel.value?.label ?? "this model").replace(/^\+ /, "")} the held-out error ${change} ${unit}; ` +
        `noise alone leaves ${short(floor)} ${unit}.`,
    ),
  };
}

export function ErrorView() {
  const readings = state.value?.measurements;
  if (!readings) {
    return (
      <Nothing title="No readings yet">
        <p>
          Drop a CSV of measurements anywhere on the page, open one of the folder, or make readings to practise on. They
          are compared with the model at once.
        </p>
        <div class="row">
          <button class="button first large" onClick={() => (dialog.value = "open")}>
            Open readings
          </button>
        </div>
      </Nothing>
    );
  }
  return (
    <div class="error-view">
      <VerdictBand />
      <ReadingChecks readings={readings} />
      <section class="panel">
        <header>
          <h2>Error of each model</h2>
        </header>
        <div class="panel-body">
          <LadderBars />
        </div>
      </section>
      <EffectsPanel />
      <EvidencePanel />
      <ResidualPlot />
      <SelectionBar />
    </div>
  );
}

function VerdictBand() {
  const now = answer.value;
  const job = runningJob(...WORK_ON_READINGS);
  const document = currentDiagnosis.value ?? currentComparison.value;
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
      </div>
      <dl class="verdict-figures">
        <dt>readings</dt>
        <dd>{state.value?.measurements?.readings}</dd>
        <dt>chi² per degree of freedom</dt>
        <dd>
          <Misfit chi2={document?.chi2_per_dof ?? ladder.value.document?.models.at(-1)?.chi2_per_dof} />
        </dd>
        <dt>noise floor</dt>
        <dd>
          {short(document?.rms.noise_floor ?? ladder.value.document?.models.at(-1)?.rms.noise_floor)}{" "}
          {units.value.length}
        </dd>
      </dl>
      <NextStep isBusy={job !== null} />
    </section>
  );
}

/** Errors of twice the stated noise and more are marked, by a sign as well as by colour. */
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

/** Verdicts after which the first explanation is added. */
const ADDED = new Set(["explained", "partly-explained", "ambiguous"]);

/** Whether further readings, or other means, would settle what these leave open. */
function isOpen({verdict, next_readings: next, splitting}: DiagnoseDocument): boolean {
  const others = (splitting?.other_means?.length ?? 0) + (splitting?.columns_to_add?.length ?? 0);
  return (verdict === "ambiguous" || verdict === "inconclusive") && next.length + others > 0;
}

/** No known effect: a law of one's own, begun with what the error follows. */
function tryFormula(): void {
  if (formulaText.peek().trim() === "") formulaText.value = suggestedFormula.peek();
  tab.value = "formula";
}

/** One button: what an engineer would do next. */
function NextStep({isBusy}: {isBusy: boolean}) {
  const diagnosis = currentDiagnosis.value;
  const first = diagnosis?.explanations[0];
  if (mistake.value) {
    const {sentence, way} = mistake.value;
    return (
      <button
        class="button first large next"
        title={sentence}
        disabled={!areChangeable.value}
        onClick={() => void assume(way)}
      >
        Take {way}
      </button>
    );
  }
  if (diagnosis?.verdict === "unexplained") {
    return (
      <button class="button first large next" onClick={tryFormula}>
        Try a formula
      </button>
    );
  }
  if (diagnosis && isOpen(diagnosis)) {
    return (
      <button class="button first large next" onClick={() => (tab.value = "split")}>
        {diagnosis.explanations.length > 1 ? "What would tell them apart" : "What to read next"}
      </button>
    );
  }
  if (diagnosis && first && ADDED.has(diagnosis.verdict)) {
    return (
      <button class="button first large next" disabled={isBusy} onClick={() => addEffects(first.effects)}>
        <span>Add {briefTitle(first)}</span>
      </button>
    );
  }
  if (diagnosis?.verdict === "inconclusive") {
    return (
      <button class="button first large next" onClick={() => (dialog.value = "open")}>
        Open more readings
      </button>
    );
  }
  if (!answer.value)
    return (
      <button class="button first large next" disabled={isBusy} onClick={startCompare}>
        Compare
      </button>
    );
  const isDone = answer.value.mark === verdictMark("adequate");
  return (
    <button
      class={`button large next ${isDone ? "" : "first"}`}
      disabled={isBusy || diagnosis !== null}
      onClick={startDiagnose}
    >
      {isDone && state.value?.can_undo ? "Diagnose again" : "Diagnose"}
    </button>
  );
}

function EffectsPanel() {
  const document = diagnose.value.document;
  const splits = document ? document.next_readings.length : 0;
  const tabs = choicesOf<Tab>([
    ["effects", "What is missing"],
    ["split", document && document.explanations.length > 1 ? `A or B${splits > 0 ? ` · ${splits}` : ""}` : "A or B"],
    ["formula", "Formula"],
    ["numbers", "Numbers"],
  ]);
  return (
    <section class="panel">
      <header>
        <Tabs label="What is missing" tabs={tabs} value={tab.value} onChoose={(next) => (tab.value = next)} />
        <div class="end">
          <OtherModel name="diagnose" />
        </div>
      </header>
      <div class="panel-body" role="tabpanel">
        <TabBody />
      </div>
    </section>
  );
}

function TabBody() {
  const found = diagnose.value;
  if (tab.value === "formula") return <FormulaBox />;
  if (tab.value === "numbers") {
    return identify.value.document ? (
      <ParameterTable document={identify.value.document} />
    ) : (
      <p class="muted">The fitted numbers stand here once an effect is added or the model is identified.</p>
    );
  }
  if (tab.value === "split" && (found.document || runSheet.value)) return <Splitting document={found.document} />;
  if (runningJob("diagnose")) return <Waiting words="Trying every effect at every place" isBusy />;
  if (found.problem) return <ProblemWords problem={found.problem} />;
  if (!found.document) {
    return (
      <div class="nothing">
        <p>
          {plural(state.value?.measurements?.readings ?? 0, "reading")} here. Diagnose tries every effect of the
          catalogue at every place of the arm.
        </p>
      </div>
    );
  }
  return (
    <>
      {found.document.warnings.map((entry) => (
        <p class="warning">{typeof entry === "string" ? entry : entry.sentence}</p>
      ))}
      <EffectRanking document={found.document} />
    </>
  );
}
