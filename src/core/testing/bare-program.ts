/** Texts in three quotes, texts of one line (`\1` is the quote that began it) and comments, whichever begins first. */
const WORDS = /"""[^]*?"""|("|')(?:\\.|(?!\1)[^\\\n])*\1|#.*/g;

/** A program without comments, words in quotes and empty lines: the part that must be the same in all languages. */
export function bareProgram(source: string): string {
  const code = source.replace(WORDS, (words) => (words.startsWith('#') ? '' : '""'));
  const lines = code.split('\n').map((line) => line.trimEnd());
  return lines.filter((line) => line !== '').join('\n');
}
