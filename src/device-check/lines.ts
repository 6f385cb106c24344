/** Line and column of a place in a text, both counted from 1. Lines end as the editor and Python end them. */
export function placeOf(text: string, at: number): { readonly line: number; readonly column: number } {
  let line = 1;
  let start = 0;
  for (const end of text.matchAll(/\r\n?|\n/g)) {
    const next = end.index + end[0].length;
    if (next > at) break;
    line += 1;
    start = next;
  }
  return { line, column: at - start + 1 };
}

/** The end of a stretch of text, or of its first line where it goes on over several. */
export function endOnLine(text: string, from: number, to: number): number {
  const length = text.slice(from, to).search(/[\r\n]/);
  return length < 0 ? to : from + length;
}
