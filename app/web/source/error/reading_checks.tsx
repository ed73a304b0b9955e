// What looked wrong with the readings when they were opened: one line for each, and how to mend it.
import {MarkIcon, type Mark} from "../drawing/marks";
import {short} from "../../../drawing/numbers.js";
import type {ReadingCheck, ReadingsInfo} from "../server/state_documents";
import {units} from "../server/workbench";

const MARKS: Record<ReadingCheck["severity"], Mark> = {
  mistake: {shape: "triangle", colour: "case0"},
  remark: {shape: "ring", colour: "muted"},
};

export function ReadingChecks({readings}: {readings: ReadingsInfo}) {
  const {checks, missing_columns: missing} = readings;
  if (checks.length === 0) return null;
  return (
    <section class="panel reading-checks" aria-label="Checks of the readings">
      <header>
        <h2>Checks of the readings</h2>
      </header>
      <ul>
        {checks.map((check) => (
          <Check key={check.name + (check.assume ?? "")} check={check} />
        ))}
        {missing.map(({column, sentence}) => (
          <li key={column}>
            <MarkIcon mark={{shape: "none", colour: "muted"}} size={16} />
            <span>
              no column <code>{column}</code>: {sentence}
            </span>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Check({check}: {check: ReadingCheck}) {
  const {error_as_is: asIs, error_if_mended: mended} = check;
  const ways = [check.assume, ...check.equally].filter((way) => way !== null);
  return (
    <li class={check.severity}>
      <MarkIcon mark={MARKS[check.severity]} size={16} />
      <span>
        {check.sentence}
        {asIs !== null && mended !== null && (
          <>
            : error {short(asIs)} → {short(mended)} {units.value.length}
          </>
        )}
        {ways.map((way, k) => (
          <span key={way}>
            {k ? " or " : "; "}
            <code>--assume {way}</code>
          </span>
        ))}
      </span>
    </li>
  );
}
