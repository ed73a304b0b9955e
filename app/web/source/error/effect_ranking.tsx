// Possibly missing effects: the explanation with its Add button, then every tried effect, most probable first.
import {byHeldOut, closestToTry, isSizeWithinNoise, isWithinNoise} from "../../../drawing/closest.js";
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
  const explanations = cardsOf(document);
  const {shown, folded, isWeak} = foldedRows(rankingRows(document.ranking));
  return (
    <div class="ranking">
      {inOrder(document, explanations).map((explanation) => (
        <ExplanationCard
          key={explanationTitle(explanation)}
          explanation={explanation}
          index={explanations.indexOf(explanation)}
          document={document}
          standing={standingOf(explanation, explanations, currentModel.value)}
          letter={explanations.length > 1 ? letterOf(explanations.indexOf(explanation)) : ""}
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

/** Returns all explanations, with the closest one that is worth a trial. */
function cardsOf(document: DiagnoseDocument): Shown[] {
  const cards: Shown[] = explanationsOf(document),
    closest = closestToTry(document);
  const isThere = closest && cards.map(explanationTitle).includes(explanationTitle(closest));
  return closest && !isThere ? [...cards, {...closest, enough: false}] : cards;
}

/** Returns the cards as shown: by their held-out error, with those that may be added first, if none is certain. */
function inOrder({verdict}: DiagnoseDocument, cards: readonly Shown[]): readonly Shown[] {
  if (verdict !== "unexplained") return cards;
  const sorted = byHeldOut(cards);
  return [...sorted.filter(isWorthAdding), ...sorted.filter((card) => !isWorthAdding(card))];
}

/** Returns false if an effect of an uncertain explanation, or every effect of a certain one, is within the noise. */
function isWorthAdding(explanation: Shown): boolean {
  const {effects} = explanation;
  return isEnough(explanation) ? !effects.every(isWithinNoise) : !effects.some(isWithinNoise);
}

const WITHIN_NOISE = "within two standard deviations of zero";

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
      {standing === "open" && isWorthAdding(explanation) ? <AddButton explanation={explanation} /> : null}
      {standing === "open" && !isWorthAdding(explanation) ? <span class="muted">{WITHIN_NOISE}</span> : null}
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
  if (isSizeWithinNoise(effect))
    return (
      <span class="muted" title={`The size is ${WITHIN_NOISE}`}>
        –
      </span>
    );
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
