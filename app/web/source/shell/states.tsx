// Placeholders of a view without content: waiting, missing data, or an error.
import type {ComponentChildren} from "preact";
import type {Problem} from "../server/documents";
import {pageProblem} from "../server/page_words";

export function Waiting({words, isBusy = false}: {words: string; isBusy?: boolean}) {
  return (
    <div class="nothing" role="status">
      {isBusy ? <div class="busy" aria-hidden="true" /> : null}
      <p>{words}</p>
    </div>
  );
}

export function Nothing({title, children}: {title: string; children?: ComponentChildren}) {
  return (
    <div class="nothing">
      <h2>{title}</h2>
      {children}
    </div>
  );
}

/** Problem in the program's words: where, what happened or the found and the expected value, and the remedy. */
export function ProblemWords({problem}: {problem: Problem}) {
  const {where, found, expected, message, advice} = pageProblem(problem);
  return (
    <div class="problem-words">
      {where ? (
        <p>
          <b>{where}</b>
        </p>
      ) : null}
      {found ? <p>{expected ? `found ${found}` : found}</p> : null}
      {expected ? <p>expected {expected}</p> : null}
      {where || found || expected ? null : <p>{message}</p>}
      {advice ? <p class="advice">{advice}</p> : null}
    </div>
  );
}
