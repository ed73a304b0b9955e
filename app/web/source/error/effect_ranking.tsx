// What could be missing: the answer with its Add, then every effect that was tried, most probable first.
import {isNumber, probability, short, withSigma} from "../drawing/numbers";
import type {DiagnoseDocument, EffectAt, Explanation, RankedEffect} from "../server/documents";
import {currentModel, runningJob} from "../server/workbench";
import {addEffects} from "./loop";
import {chosenExplanation} from "./residuals";
import {effectTitle, effectWords, explanationTitle, isEnough, keptText, sizeText} from "./words";

const MOST_RANKED = 14;

export function EffectRanking({document}: {document: DiagnoseDocument}) {
  const explanations = explanationsOf(document);
  const ranking = document.ranking.slice(0, MOST_RANKED);
  return (
    <div class="ranking">
      {explanations.map((explanation, index) => (
        <ExplanationCard
          key={explanationTitle(explanation)}
          explanation={explanation}
          index={index}
          document={document}
          letter={explanations.length > 1 ? String.fromCharCode(65 + index) : ""}
        />
      ))}
      <table>
        <thead>
          <tr>
            <th>effect</th>
            <th>probability</th>
            <th class="number">chi² falls by</th>
            <th>size</th>
            <th />
          </tr>
        </thead>
        <tbody>
          {ranking.map((effect) => (
            <RankedRow key={effectTitle(effect)} effect={effect} />
          ))}
        </tbody>
      </table>
      <p class="muted note">
        {document.ranking.length} causes were tried, each alone and with others; that nothing is missing has probability{" "}
        {probability(document.probability.nothing_missing)}, that no known effect is part of it{" "}
        {probability(document.probability.unknown_alone)}.
      </p>
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

/** Whether the model as it is now has this effect. */
function hasEffect(effect: EffectAt): boolean {
  return currentModel.value?.effects.some((own) => own.effect === effect.effect && own.at === effect.at) ?? false;
}

/** Every alternative: those that were drawn with their figures first, then the others by name and size. */
function explanationsOf(document: DiagnoseDocument): Explanation[] {
  const drawn = document.explanations ?? [];
  const titles = new Set(drawn.map(explanationTitle));
  const others = (document.alternatives ?? []).map((effects) => ({
    effects,
    chi2: NaN,
    p_value: NaN,
    rms: NaN,
    heldout_rms: null,
  }));
  return [...drawn, ...others.filter((other) => !titles.has(explanationTitle(other)))];
}

function ExplanationCard({
  explanation,
  index,
  document,
  letter,
}: {
  explanation: Explanation;
  index: number;
  document: DiagnoseDocument;
  letter: string;
}) {
  const unit = document.units.length;
  const isAdded = explanation.effects.every(hasEffect);
  const isDrawn = index < document.explanations.length && document.explanations.length > 1;
  const leaves = explanation.heldout_rms ?? explanation.rms;
  return (
    <div class={`explanation ${isAdded ? "added" : isEnough(explanation) ? "" : "not-enough"}`}>
      {letter ? <b class="letter">{letter}</b> : null}
      <div class="explanation-words">
        <b>{explanationTitle(explanation)}</b>
        <span class="muted">
          {isEnough(explanation)
            ? explanation.effects.map((effect) => effectWords(effect.effect)).join("; ")
            : "the closest of the known effects, but not enough"}
        </span>
        {explanation.effects
          .filter((effect) => (effect.also ?? []).length > 0)
          .map((effect) => (
            <span class="muted" key={effectTitle(effect)}>
              no reading tells {effectTitle(effect)} from {(effect.also ?? []).map(effectTitle).join(", ")}
            </span>
          ))}
        <span>
          {explanation.effects
            .map(sizeText)
            .filter((text) => text !== "")
            .join("; ")}
          {isNumber(leaves) ? ` · leaves ${short(leaves)} ${unit} held out` : ""}
        </span>
      </div>
      {isDrawn ? (
        <button
          class="button small"
          aria-pressed={chosenExplanation.value === index}
          aria-label={`Draw ${explanationTitle(explanation)}`}
          onClick={() => (chosenExplanation.value = index)}
        >
          {chosenExplanation.value === index ? "Drawn" : "Draw"}
        </button>
      ) : null}
      {isAdded ? (
        <span class="done">✓ added</span>
      ) : (
        <button
          class={isEnough(explanation) ? "button first" : "button"}
          disabled={runningJob("add") !== null}
          aria-label={`Add ${explanationTitle(explanation)}`}
          onClick={() => addEffects(explanation.effects)}
        >
          {isEnough(explanation) ? "Add" : "Add anyway"}
        </button>
      )}
    </div>
  );
}

function RankedRow({effect}: {effect: RankedEffect}) {
  const share = Math.max(0, Math.min(1, effect.probability ?? 0));
  const hint = [effectWords(effect.effect), keptText(effect.kept_fraction)].filter((text) => text !== "").join("; ");
  return (
    <tr title={hint}>
      <td class="effect-name">
        {effect.effect}
        <small>{effect.at}</small>
      </td>
      <td>
        <span class="chance">
          <span class="chance-bar">
            <i style={{width: `${100 * share}%`}} />
          </span>
          {probability(effect.probability)}
        </span>
      </td>
      <td class="number">{short(effect.chi2_fall)}</td>
      <td class="size">
        {effect.size
          ? `${effect.size.name.replaceAll("_", " ")} ${withSigma(effect.size.value, effect.size.sigma, effect.size.unit)}`
          : "–"}
      </td>
      <td class="number">
        {hasEffect(effect) ? (
          <span class="good">✓</span>
        ) : (
          <button
            class="button small"
            disabled={runningJob("add") !== null}
            aria-label={`Add ${effectTitle(effect)}`}
            onClick={() => addEffects([effect])}
          >
            Add
          </button>
        )}
      </td>
    </tr>
  );
}
