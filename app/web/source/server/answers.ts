// Documents that the program is asked for anew whenever what they are of changes.
import {computed, effect, signal, useSignal, type ReadonlySignal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import type {Problem} from "./documents";
import {asProblem, get, isMissing} from "./requests";

export interface Loaded<T> {
  document: T | null;
  problem: Problem | null;
}

const NOTHING: Loaded<never> = {document: null, problem: null};

interface Question {
  /** What the document is of: another key, another document; "": there is none; null: nobody looks, and what is known
   * stays. */
  key: () => string | null;
  path: () => string;
  /** Whether the document before is shown until the new one is here. */
  keeps?: boolean;
  onProblem?: (error: unknown) => void;
}

/** A document that is missing is none. */
export function answerTo<T>({key, path, keeps = false, onProblem}: Question): ReadonlySignal<Loaded<T>> {
  const into = signal<Loaded<T>>(NOTHING),
    wantedKey = computed(key);
  let asked = "";
  effect(() => {
    const wanted = wantedKey.value;
    if (wanted === null || wanted === asked) return;
    asked = wanted;
    if (wanted === "") {
      into.value = NOTHING;
      return;
    }
    into.value = {document: keeps ? into.peek().document : null, problem: null};
    get<T>(path()).then(
      (document) => {
        if (asked === wanted) into.value = {document, problem: null};
      },
      (error) => {
        if (asked !== wanted) return;
        into.value = isMissing(error) ? NOTHING : {document: null, problem: asProblem(error)};
        if (!isMissing(error)) onProblem?.(error);
      },
    );
  });
  return into;
}

/** The document at an address, for as long as a component is there; none without an address. */
export function useAnswer<T>(path: string): Loaded<T> {
  const into = useSignal<Loaded<T>>(NOTHING);
  useEffect(() => {
    let isWanted = path !== "";
    into.value = NOTHING;
    const take = (found: Loaded<T>) => {
      if (isWanted) into.value = found;
    };
    if (isWanted)
      get<T>(path).then(
        (document) => take({document, problem: null}),
        (error) => take({document: null, problem: asProblem(error)}),
      );
    return () => {
      isWanted = false;
    };
  }, [path]);
  return into.value;
}
