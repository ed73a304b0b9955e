// Verdict of a diagnosis or a comparison, sentence by sentence, in the words of its document.

/**
 * The advice on further readings comes last. An earlier program wrote one text with the advice in it: that stays whole.
 * @param {{sentence?: string, sentences?: string[], splitting?: {advice?: string} | null}} document @returns {string[]}
 */
export function verdictItems({sentence, sentences, splitting}) {
  if (!Array.isArray(sentences)) return sentence ? [sentence] : [];
  return [...sentences, ...(splitting?.advice ? [splitting.advice] : [])];
}
