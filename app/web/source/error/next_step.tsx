// A single button for the next step that an engineer would take.
import type {ComponentChildren} from "preact";
import {useEffect, useRef} from "preact/hooks";
import {addWords, briefTitle, causeKey, formulaTexts} from "../../../drawing/explanations.js";
import {plural} from "../../../drawing/numbers.js";
import {verdictMark} from "../../../drawing/kinds.js";
import type {DiagnoseDocument} from "../server/documents";
import {hasModelBefore} from "../server/workbench";
import {dialog} from "../shell/page_state";
import {answer} from "./answer";
import {suggestedFormula} from "./focus";
import {openFormula} from "./formula_box";
import {addEffects, areChangeable, currentDiagnosis, removeCauses, startCompare, startDiagnose} from "./loop";
import {advice} from "./guidance_panel";
import {assume, mistake} from "./reading_checks";
import {effectsTab} from "./tabs";
import {addedInVain} from "./within_noise";

interface Step {
  words: ComponentChildren;
  act: () => unknown;
  title?: string;
  isOff?: boolean;
  /** True for a step that is possible but not needed. */
  isQuiet?: boolean;
}

export function NextStep({isBusy}: {isBusy: boolean}) {
  const diagnosis = currentDiagnosis.value;
  const {words, act, title, isOff, isQuiet} =
    stepOfMistake() ?? (diagnosis ? stepAfter(diagnosis, isBusy) : null) ?? stepOfLoop(isBusy);
  // A disabled button loses the focus. For keyboard users, restore the focus with the next step.
  const button = useRef<HTMLButtonElement>(null);
  const hadFocus = useRef(false);
  useEffect(() => {
    if (isOff || !hadFocus.current) return;
    hadFocus.current = false;
    if (document.activeElement === document.body) button.current?.focus();
  }, [isOff]);
  return (
    <div class="next-box">
      <button
        ref={button}
        class={`button ${isQuiet ? "" : "first"} large next`}
        title={title}
        disabled={isOff}
        onClick={() => {
          hadFocus.current = true;
          void act();
        }}
      >
        {words}
      </button>
      {advice.value.length > 0 ? (
        <button class="link" onClick={() => (effectsTab.value = "steps")}>
          All {plural(advice.value.length, "step")} after this verdict
        </button>
      ) : null}
    </div>
  );
}

/** Returns the step that corrects a suspected mistake in the readings; null if there is none. */
function stepOfMistake(): Step | null {
  if (!mistake.value) return null;
  const {sentence, way} = mistake.value;
  return {words: `Assume ${way}`, act: () => assume(way), title: sentence, isOff: !areChangeable.value};
}

/** Verdicts after which the next step adds the first explanation. */
const ADDED = new Set(["explained", "partly-explained", "ambiguous"]);

function stepAfter(diagnosis: DiagnoseDocument, isBusy: boolean): Step | null {
  const {verdict, explanations} = diagnosis,
    [first] = explanations;
  if (verdict === "unexplained") return {words: "Try a formula", act: () => openFormula(suggestedFormula.peek())};
  if (isOpen(diagnosis)) {
    const words = explanations.length > 1 ? "Readings that distinguish them" : "Next readings";
    return {words, act: () => (effectsTab.value = "split")};
  }
  if (first && ADDED.has(verdict))
    return {words: <span>{addWords(first)}</span>, act: () => addEffects(first.effects), isOff: isBusy};
  if (verdict === "inconclusive") return {words: "Open more readings", act: () => (dialog.value = "open")};
  return null;
}

/** Returns true if further readings, or other means, would distinguish the open explanations. */
function isOpen({verdict, next_readings: next, splitting}: DiagnoseDocument): boolean {
  const others = (splitting?.other_means?.length ?? 0) + (splitting?.columns_to_add?.length ?? 0);
  return (verdict === "ambiguous" || verdict === "inconclusive") && next.length + others > 0;
}

/** Returns the next step of the loop: compare, remove what was added in vain, then diagnose. */
function stepOfLoop(isBusy: boolean): Step {
  if (!answer.value) return {words: "Compare", act: startCompare, isOff: isBusy};
  const vain = addedInVain.value;
  if (vain.length > 0)
    return {
      words: `Remove ${briefTitle({effects: vain})}`,
      act: () => removeCauses(vain.map(causeKey)),
      title: ["The readings do not show it; the model is fitted without it", formulaTexts(vain)].join("\n").trim(),
      isOff: isBusy,
    };
  const isDone = answer.value.mark === verdictMark("adequate");
  return {
    words: isDone && hasModelBefore.value ? "Diagnose again" : "Diagnose",
    act: startDiagnose,
    isOff: isBusy || currentDiagnosis.value !== null,
    isQuiet: isDone,
  };
}
