// Verdict of a diagnosis or a comparison as the list of sentences that the document contains.

/**
 * Returns the sentences of the verdict, with the advice on further readings last. Documents of earlier versions contain
 * one text that includes the advice; it is returned unchanged.
 * @param {{sentence?: string, sentences?: string[], splitting?: {advice?: string} | null}} document @returns {string[]}
 */
export function verdictItems({sentence, sentences, splitting}) {
  if (!Array.isArray(sentences)) return sentence ? [sentence] : [];
  return [...sentences, ...(splitting?.advice ? [splitting.advice] : [])];
}
