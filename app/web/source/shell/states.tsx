// What a view shows when it has nothing to show: that it waits, that something is not there, or what went wrong.
import type {ComponentChildren} from "preact";
import type {Problem} from "../server/documents";

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
  const isSplit = problem.where || problem.found || problem.expected;
  return (
    <div class="problem-words">
      {problem.where ? (
        <p>
          <b>{problem.where}</b>
        </p>
      ) : null}
      {problem.found ? <p>found {problem.found}</p> : null}
      {problem.expected ? <p>expected {problem.expected}</p> : null}
      {isSplit ? null : <p>{problem.message}</p>}
      {problem.advice ? <p class="advice">{problem.advice}</p> : null}
    </div>
  );
}
