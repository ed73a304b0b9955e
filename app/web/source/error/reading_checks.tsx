// Mistakes suspected when the readings were opened: one line each, with the proposed correction.
import {computed} from "@preact/signals";
import {MarkIcon, type Mark} from "../drawing/marks";
import {errorText, plural} from "../../../drawing/numbers.js";
import {pageWords} from "../server/page_words";
import type {ReadingCheck, ReadingsInfo, WorkbenchState} from "../server/state_documents";
import {post} from "../server/requests";
import {state, units} from "../server/workbench";
import {areChangeable, changeReadings, startCompare} from "./loop";

const MARKS: Record<ReadingCheck["severity"], Mark> = {
  mistake: {shape: "triangle", colour: "case0"},
  remark: {shape: "ring", colour: "muted"},
};

export function ReadingChecks({readings}: {readings: ReadingsInfo}) {
  const {checks, missing_columns: missing, assumed, joined} = readings;
  if (checks.length === 0 && assumed.length === 0 && joined === 0) return null;
  return (
    <section class="panel reading-checks" aria-label="Checks of the readings">
      <header>
        <h2>Checks of the readings</h2>
      </header>
      <ul>
        {assumed.length > 0 ? <Assumed assumed={assumed} /> : null}
        {joined > 0 ? <Joined count={joined} all={readings.readings} /> : null}
        {checks.map((check) => (
          <Check key={check.name + (check.assume ?? "")} check={check} />
        ))}
        {missing.map(({column, sentence}) => (
          <li key={column}>
            <MarkIcon mark={{shape: "none", colour: "muted"}} size={16} />
            <span>
              column <code>{column}</code> (missing, or equal in all rows): {sentence}
            </span>
          </li>
        ))}
      </ul>
    </section>
  );
}

function waysOf(check: ReadingCheck): string[] {
  return [check.assume, ...check.equally].filter((way): way is string => way !== null && way !== "");
}

/**
 * The first suspected mistake that an assumption can correct, and that must be settled before any verdict on the model;
 * null if there is none.
 */
export const mistake = computed(() => {
  const checks = state.value?.measurements?.checks ?? [];
  const found = checks.find((check) => check.severity === "mistake" && waysOf(check).length > 0);
  return found ? {sentence: pageWords(found.sentence), way: waysOf(found)[0]} : null;
});

/**
 * Reads the readings again under assumptions that correct suspected mistakes, and compares again; their file is not
 * changed. Without arguments, revokes all assumptions.
 */
export async function assume(...ways: string[]): Promise<void> {
  const taken = () => post<WorkbenchState>("/api/measurements/assume", {assume: ways});
  if (await changeReadings("The readings cannot be corrected in this way", taken)) await startCompare();
}

/** Assumptions about the readings, with a button to revoke them. */
function Assumed({assumed}: {assumed: string[]}) {
  const isAsIs = assumed.every((way) => way === "as-is");
  return (
    <Reversible
      words={isAsIs ? "Used as they are, despite all warnings" : `Used with ${assumed.join(", ")}`}
      back="Take back"
      title="As they are in their file"
      onBack={() => void assume()}
    />
  );
}

/** Removes the readings that were added last, and compares again. */
async function part(): Promise<void> {
  const parted = () => post<WorkbenchState>("/api/measurements/part", {});
  if (await changeReadings("The readings stay together", parted)) await startCompare();
}

function Joined({count, all}: {count: number; all: number}) {
  return (
    <Reversible
      words={`${plural(count, "reading")} joined the ${all - count} before`}
      back="Take out again"
      title="The other readings remain, with those set aside or held out"
      onBack={() => void part()}
    />
  );
}

interface Step {
  words: string;
  back: string;
  title: string;
  onBack: () => void;
}

/** Changes made to the readings when they were read, with a button to revoke the changes. */
function Reversible({words, back, title, onBack}: Step) {
  return (
    <li class="remark">
      <MarkIcon mark={MARKS.remark} size={16} />
      <span>{words}</span>
      <span class="mends">
        <button class="button small" disabled={!areChangeable.value} title={title} onClick={onBack}>
          {back}
        </button>
      </span>
    </li>
  );
}

function Check({check}: {check: ReadingCheck}) {
  const {error_as_is: asIs, error_if_mended: ifCorrected} = check;
  const ways = waysOf(check);
  return (
    <li class={check.severity}>
      <MarkIcon mark={MARKS[check.severity]} size={16} />
      <span>
        {pageWords(check.sentence)}
        {asIs !== null && ifCorrected !== null && (
          <>
            : error {errorText(asIs, units.value.length)} → {errorText(ifCorrected, units.value.length)}
          </>
        )}
      </span>
      {ways.length > 0 ? (
        <span class="mends">
          {ways.map((way) => (
            <button
              key={way}
              class={`button small ${check.severity === "mistake" && way === ways[0] ? "first" : ""}`}
              disabled={!areChangeable.value}
              title={`The readings are used with ${way}; their file is not changed`}
              onClick={() => void assume(way)}
            >
              Assume {way}
            </button>
          ))}
          {check.severity === "mistake" ? (
            <button
              class="button small"
              disabled={!areChangeable.value}
              title="Nothing is wrong with the readings: continue"
              onClick={() => void assume("as-is")}
            >
              Leave as they are
            </button>
          ) : null}
        </span>
      ) : null}
    </li>
  );
}
