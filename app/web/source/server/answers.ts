// Documents that are requested again from the program whenever their inputs change.
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
  /**
   * Key of the document's inputs; a new key requests the document again. An empty key means that there is no document;
   * null means that the view is closed, and the known document is kept.
   */
  key: () => string | null;
  path: () => string;
  /** True if the old document is shown until the new one arrives. */
  keeps?: boolean;
  /** Called with the reason of a failure, or with null after an answer. */
  onProblem?: (error: unknown) => void;
}

/** Returns the answer to a question as a signal. If the server has no such document, the answer is empty. */
export function answerTo<T>({key, path, keeps = false, onProblem}: Question): ReadonlySignal<Loaded<T>> {
  const into = signal<Loaded<T>>(NOTHING),
    wantedKey = computed(key);
  let requested = "";
  effect(() => {
    const wanted = wantedKey.value;
    if (wanted === null || wanted === requested) return;
    requested = wanted;
    if (wanted === "") {
      into.value = NOTHING;
      return;
    }
    into.value = {document: keeps ? into.peek().document : null, problem: null};
    get<T>(path()).then(
      (document) => {
        if (requested !== wanted) return;
        into.value = {document, problem: null};
        onProblem?.(null);
      },
      (error) => {
        if (requested !== wanted) return;
        into.value = isMissing(error) ? NOTHING : {document: null, problem: asProblem(error)};
        if (!isMissing(error)) onProblem?.(error);
      },
    );
  });
  return into;
}

/** Returns the document at an address during the lifetime of a component; empty for an empty address. */
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
