// Possibly missing effects: the explanation with its Add button, then every tried effect, most probable first.
import {
  briefTitle,
  effectTitle,
  explanationsOf,
  explanationTitle,
  explanationWords,
  isEnough,
  sizeRows,
  sizesOf,
} from "../../../drawing/explanations.js";
import {errorUnit} from "../../../drawing/error_budget.js";
import {errorText, isNumber} from "../../../drawing/numbers.js";
import {foldedRows, LEAST_FALL, rankingRows, triedText} from "../../../drawing/ranking.js";
import type {DiagnoseDocument, Explanation} from "../server/documents";
import {Table} from "../drawing/table";
import {currentModel, runningJob} from "../server/workbench";
import {addEffects} from "./loop";
import {hasCause, type Standing, standingOf} from "./in_model";
import {letterOf} from "../../../drawing/reading_errors.js";
import {type RankedRow, RankingTable} from "./ranking_table";
import {chosenExplanation} from "./residuals";

type Shown = Pick<Explanation, "effects"> & Partial<Explanation>;

export function EffectRanking({document}: {document: DiagnoseDocument}) {
  const explanations: Shown[] = explanationsOf(document);
  const {shown, folded, isWeak} = foldedRows(rankingRows(document.ranking));
  return (
    <div class="ranking">
      {explanations.map((explanation, index) => (
        <ExplanationCard
          key={explanationTitle(explanation)}
          explanation={explanation}
          index={index}
          document={document}
          standing={standingOf(explanation, explanations, currentModel.value)}
          letter={explanations.length > 1 ? letterOf(index) : ""}
        />
      ))}
      <RankingTable rows={shown} action={RankedAction} />
      {folded.length > 0 ? (
        <details>
          <summary class="muted">
            {isWeak ? `${folded.length} more that lower chi² by less than ${LEAST_FALL}` : `the other ${folded.length}`}
          </summary>
          <RankingTable rows={folded} action={RankedAction} />
        </details>
      ) : null}
      <p class="muted note">{triedText(document)}</p>
      {document.not_tried.length > 0 ? (
        <ul class="muted note">
          {document.not_tried.map((lack) => (
            <li key={lack}>not tried: {lack}</li>
          ))}
        </ul>
      ) : null}
    </div>
  );
}

interface ExplanationCardProps {
  explanation: Shown;
  index: number;
  document: DiagnoseDocument;
  standing: Standing;
  letter: string;
}

function ExplanationCard({explanation, index, document, standing, letter}: ExplanationCardProps) {
  const isDrawn = index < document.explanations.length && document.explanations.length > 1;
  return (
    <div class={`explanation ${standing === "added" ? "added" : isEnough(explanation) ? "" : "not-enough"}`}>
      {letter ? <b class="letter">{letter}</b> : null}
      <ExplanationWords explanation={explanation} unit={errorUnit(document)} />
      {isDrawn ? <DrawButton explanation={explanation} index={index} /> : null}
      {standing === "open" ? <AddButton explanation={explanation} /> : null}
      {standing === "added" ? <span class="done">✓ added</span> : null}
      {standing === "part of the added" ? <span class="muted">{standing}</span> : null}
    </div>
  );
}

function ExplanationWords({explanation, unit}: {explanation: Shown; unit: string}) {
  const leaves = explanation.heldout_rms ?? explanation.rms;
  const left = isNumber(leaves) ? [`leaves ${errorText(leaves, unit)} held out`] : [];
  const table = sizeRows(explanation);
  return (
    <div class="explanation-words">
      <b title={explanationTitle(explanation)}>{briefTitle(explanation)}</b>
      <span class="muted">{explanationWords(explanation)}</span>
      {explanation.effects
        .filter((effect) => effect.also_words)
        .map((effect) => (
          <span class="muted" key={effectTitle(effect)}>
            {effect.also_words}
          </span>
        ))}
      {table ? <Table {...table} text={[0, 1, 4]} /> : null}
      <span>{[...(table ? [] : [sizesOf(explanation).join("; ")]), ...left].filter(Boolean).join(" · ")}</span>
    </div>
  );
}

function DrawButton({explanation, index}: {explanation: Shown; index: number}) {
  const isDrawn = chosenExplanation.value === index;
  return (
    <button
      class="button small"
      aria-pressed={isDrawn}
      aria-label={`Draw ${explanationTitle(explanation)}`}
      onClick={() => (chosenExplanation.value = index)}
    >
      {isDrawn ? "Drawn" : "Draw"}
    </button>
  );
}

function AddButton({explanation}: {explanation: Shown}) {
  return (
    <button
      class={isEnough(explanation) ? "button first" : "button"}
      disabled={runningJob("add") !== null}
      aria-label={`Add ${explanationTitle(explanation)}`}
      onClick={() => addEffects(explanation.effects)}
    >
      {isEnough(explanation) ? "Add" : "Add anyway"}
    </button>
  );
}

/** Button that adds a ranked effect, unless the model has it. */
function RankedAction({row: {entry: effect, title}}: {row: RankedRow}) {
  if (hasCause(currentModel.value, effect)) return <span class="good nowrap">✓ added</span>;
  return (
    <button
      class="button small"
      disabled={runningJob("add") !== null}
      aria-label={`Add ${title}`}
      onClick={() => addEffects([effect])}
    >
      Add
    </button>
  );
}
