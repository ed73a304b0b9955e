// What a view shows when it has nothing to show: that it waits, that something is not there, or what went wrong.
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

/** The program's own words: where, what was found, what was expected, what to do. */
export function ProblemWords({problem}: {problem: Problem}) {
  const {where, found, expected, message, advice} = pageProblem(problem);
  return (
    <div class="problem-words">
      {where ? (
        <p>
          <b>{where}</b>
        </p>
      ) : null}
      {found ? <p>found {found}</p> : null}
      {expected ? <p>expected {expected}</p> : null}
      {where || found || expected ? null : <p>{message}</p>}
      {advice ? <p class="advice">{advice}</p> : null}
    </div>
  );
}
