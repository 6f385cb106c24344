/** Small letters without their accents: for the search, `É`, `e` and `é` are the same, and so are `ß` and `ss`. */
export const folded = (text: string): string =>
  text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase().replaceAll('ß', 'ss').replace(/[’ʼ]/g, "'");

/** The words of a search, folded; none for an empty one. */
export const wordsOf = (query: string): readonly string[] => folded(query).split(/\s+/).filter(Boolean);

/** A word without its ending, so that `drehen` finds `dreht` and `tourner` finds `tourne`; short words stay. Chosen by trying. */
const stemOf = (word: string): string => word.slice(0, Math.max(4, word.length - (word.length > 6 ? 3 : 2)));

/**
 * A score for how well something fits a search: 0 when a word is nowhere in it, and higher the nearer its words are to
 * the beginning of the name. Every word has to be there, in any order; a part of a word counts, too.
 */
export function fitOf(words: readonly string[], name: string, text: string): number {
  const [foldedName, foldedText] = [folded(name), folded(text)];
  let fit = 1;
  for (const word of words) {
    if (foldedName.startsWith(word)) fit += 4;
    else if (startsAWord(foldedName, word)) fit += 3;
    else if (foldedName.includes(word)) fit += 2;
    else if (startsAWord(foldedText, word)) fit += 1;
    else if (startsAWord(foldedName, stemOf(word))) fit += 0.75;
    else if (startsAWord(foldedText, stemOf(word))) fit += 0.5;
    else if (!foldedText.includes(word)) return 0;
  }
  return fit;
}

const startsAWord = (text: string, word: string): boolean => {
  const at = text.indexOf(word);
  return at === 0 || (at > 0 && text.split(/[^\p{L}\p{N}]+/u).some((part) => part.startsWith(word)));
};
